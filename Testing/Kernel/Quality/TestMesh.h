// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingTestMesh_h
#define BitingTestMesh_h

#include "../Support/Dice.h"
#include "Base/Ids.h"
#include "Base/Point.h"
#include "Predicates/Predicates.h"

#include <cstdint>    // for seeds
#include <functional> // for what to keep
#include <map>        // for edges
#include <utility>    // for pairs
#include <vector>     // for the arrays

namespace biting
{

/// A small triangulation that tests build and change, at any cost. Arrays as in Triangulation.
struct TestMesh
{
  std::vector<Point2> Points;
  std::vector<Id> Corners;
  std::vector<Id> Neighbors;
  std::vector<Id> Constraints;

  /// A grid of rectangles between the given lines, each cut in two triangles. Those with columns
  /// and rows that `isKept` denies are left out.
  static TestMesh Grid(const std::vector<double>& xLines, const std::vector<double>& yLines,
    const std::function<bool(std::size_t, std::size_t)>& isKept);

  /// A square of side 1 with random points inserted one by one: triangles of any shape.
  static TestMesh Random(std::size_t numberOfPoints, std::uint64_t seed);

  /// Flips all edges that have a vertex in the circle beyond them: constrained Delaunay.
  void MakeDelaunay();

  /// Flips edges at random wherever both triangles stay counterclockwise.
  void Shuffle(int numberOfFlips, std::uint64_t seed);

  /// Moves each point by up to `reach` along both axes, where all triangles stay counterclockwise.
  void Jitter(double reach, std::uint64_t seed);

  /// Drops the triangles with a centroid that is denied, and the vertices only these had.
  void Keep(const std::function<bool(const Point2&)>& isKept);

  /// Fills Neighbors from Corners, and marks the boundary edges as constraint 0.
  void Link();

  bool Insert(const Point2& p);
  bool Flip(std::size_t slot);
  bool IsCounterclockwise() const;
  void DropUnusedPoints();
  double Area() const;

  const Point2& Place(std::size_t slot) const
  {
    return this->Points[static_cast<std::size_t>(this->Corners[slot])];
  }
};

/// The next corner of the same triangle, counterclockwise.
inline std::size_t NextSlot(std::size_t slot)
{
  return slot % 3 == 2 ? slot - 2 : slot + 1;
}

inline TestMesh TestMesh::Grid(const std::vector<double>& xLines, const std::vector<double>& yLines,
  const std::function<bool(std::size_t, std::size_t)>& isKept)
{
  TestMesh mesh;
  for (const double y : yLines)
  {
    for (const double x : xLines)
    {
      mesh.Points.push_back({ x, y });
    }
  }
  const Id width = static_cast<Id>(xLines.size());
  for (std::size_t row = 0; row + 1 < yLines.size(); ++row)
  {
    for (std::size_t column = 0; column + 1 < xLines.size(); ++column)
    {
      if (isKept(column, row))
      {
        const Id a = static_cast<Id>(row) * width + static_cast<Id>(column);
        const Id d = a + width;
        mesh.Corners.insert(mesh.Corners.end(), { a, a + 1, d + 1, a, d + 1, d });
      }
    }
  }
  mesh.DropUnusedPoints();
  mesh.Link();
  return mesh;
}

inline TestMesh TestMesh::Random(std::size_t numberOfPoints, std::uint64_t seed)
{
  Dice dice(seed);
  TestMesh mesh;
  mesh.Points = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } };
  mesh.Corners = { 0, 1, 2, 0, 2, 3 };
  while (mesh.Points.size() < numberOfPoints)
  {
    const double x = dice.Between(0.0, 1.0);
    mesh.Insert({ x, dice.Between(0.0, 1.0) });
  }
  mesh.Link();
  return mesh;
}

inline void TestMesh::MakeDelaunay()
{
  bool isFlipped = true;
  while (isFlipped)
  {
    isFlipped = false;
    for (std::size_t slot = 0; slot < this->Corners.size(); ++slot)
    {
      const std::size_t first = slot / 3 * 3;
      const std::size_t other = 3 * static_cast<std::size_t>(this->Neighbors[slot]);
      bool isInvaded = false;
      for (std::size_t k = 0; k < 3 && this->Neighbors[slot] != NoId; ++k)
      {
        isInvaded = isInvaded ||
          InCircle(this->Place(first), this->Place(first + 1), this->Place(first + 2),
            this->Place(other + k)) > 0;
      }
      isFlipped = (isInvaded && this->Flip(slot)) || isFlipped;
    }
  }
}

inline void TestMesh::Shuffle(int numberOfFlips, std::uint64_t seed)
{
  Dice dice(seed);
  for (int i = 0; i < numberOfFlips; ++i)
  {
    this->Flip(dice.Roll() % this->Corners.size());
  }
}

inline void TestMesh::Jitter(double reach, std::uint64_t seed)
{
  Dice dice(seed);
  for (Point2& point : this->Points)
  {
    const Point2 before = point;
    point.X += dice.Between(-reach, reach);
    point.Y += dice.Between(-reach, reach);
    point = this->IsCounterclockwise() ? point : before;
  }
}

inline void TestMesh::Keep(const std::function<bool(const Point2&)>& isKept)
{
  std::vector<Id> kept;
  for (std::size_t slot = 0; slot < this->Corners.size(); slot += 3)
  {
    const Point2 sum = this->Place(slot) + this->Place(slot + 1) + this->Place(slot + 2);
    if (isKept(1.0 / 3.0 * sum))
    {
      kept.insert(
        kept.end(), { this->Corners[slot], this->Corners[slot + 1], this->Corners[slot + 2] });
    }
  }
  this->Corners = kept;
  this->DropUnusedPoints();
  this->Link();
}

inline void TestMesh::Link()
{
  this->Neighbors.assign(this->Corners.size(), NoId);
  this->Constraints.assign(this->Corners.size(), NoId);
  std::map<std::pair<Id, Id>, std::size_t> slots;
  for (std::size_t slot = 0; slot < this->Corners.size(); ++slot)
  {
    slots[{ this->Corners[NextSlot(slot)], this->Corners[NextSlot(NextSlot(slot))] }] = slot;
  }
  for (const auto& [ends, slot] : slots)
  {
    const auto across = slots.find({ ends.second, ends.first });
    const bool isInner = across != slots.end();
    this->Neighbors[slot] = isInner ? static_cast<Id>(across->second / 3) : NoId;
    this->Constraints[slot] = isInner ? NoId : 0;
  }
}

// Splits the triangle around p in three; false if p is not inside of one.
inline bool TestMesh::Insert(const Point2& p)
{
  for (std::size_t slot = 0; slot < this->Corners.size(); slot += 3)
  {
    const Id a = this->Corners[slot];
    const Id b = this->Corners[slot + 1];
    const Id c = this->Corners[slot + 2];
    if (Orient2D(this->Place(slot), this->Place(slot + 1), p) > 0 &&
      Orient2D(this->Place(slot + 1), this->Place(slot + 2), p) > 0 &&
      Orient2D(this->Place(slot + 2), this->Place(slot), p) > 0)
    {
      const Id added = static_cast<Id>(this->Points.size());
      this->Points.push_back(p);
      this->Corners[slot + 2] = added;
      this->Corners.insert(this->Corners.end(), { b, c, added, c, a, added });
      return true;
    }
  }
  return false;
}

// The triangles (p, a, b) and (d, b, a) become (p, a, d) and (d, b, p) if both are
// counterclockwise.
inline bool TestMesh::Flip(std::size_t slot)
{
  if (this->Neighbors[slot] == NoId)
  {
    return false;
  }
  const std::size_t slotOfA = NextSlot(slot);
  const std::size_t slotOfB = NextSlot(slotOfA);
  std::size_t across = 3 * static_cast<std::size_t>(this->Neighbors[slot]);
  while (this->Corners[NextSlot(across)] != this->Corners[slotOfB])
  {
    across += 1;
  }
  if (Orient2D(this->Place(slot), this->Place(slotOfA), this->Place(across)) <= 0 ||
    Orient2D(this->Place(across), this->Place(slotOfB), this->Place(slot)) <= 0)
  {
    return false;
  }
  this->Corners[slotOfB] = this->Corners[across];
  this->Corners[NextSlot(NextSlot(across))] = this->Corners[slot];
  this->Link();
  return true;
}

inline bool TestMesh::IsCounterclockwise() const
{
  for (std::size_t slot = 0; slot < this->Corners.size(); slot += 3)
  {
    if (Orient2D(this->Place(slot), this->Place(slot + 1), this->Place(slot + 2)) <= 0)
    {
      return false;
    }
  }
  return true;
}

inline void TestMesh::DropUnusedPoints()
{
  std::vector<Id> names(this->Points.size(), NoId);
  std::vector<Point2> used;
  for (Id& corner : this->Corners)
  {
    Id& name = names[static_cast<std::size_t>(corner)];
    if (name == NoId)
    {
      name = static_cast<Id>(used.size());
      used.push_back(this->Points[static_cast<std::size_t>(corner)]);
    }
    corner = name;
  }
  this->Points = used;
}

inline double TestMesh::Area() const
{
  double doubledArea = 0.0;
  for (std::size_t slot = 0; slot < this->Corners.size(); slot += 3)
  {
    doubledArea +=
      Cross(this->Place(slot + 1) - this->Place(slot), this->Place(slot + 2) - this->Place(slot));
  }
  return 0.5 * doubledArea;
}

/// 0, 1, ..., count.
inline std::vector<double> UnitLines(int count)
{
  std::vector<double> lines;
  for (int i = 0; i <= count; ++i)
  {
    lines.push_back(i);
  }
  return lines;
}

} // namespace biting

#endif
