// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "ConstrainedMesh.h"

#include "../Base/DisjointSets.h"
#include "../Base/SortInSteps.h"

#include <algorithm> // for lower_bound, max, max_element, min
#include <cstdint>   // for flags
#include <utility>   // for move

namespace biting
{

namespace
{

// Where steps end, as shares of the time for a million points.
constexpr double FacesEnd = 0.25;
constexpr double BorderEnd = 0.27;
constexpr double RegionsEnd = 0.28;
constexpr double CountsEnd = 0.45;
constexpr double NumbersEnd = 0.65;

/// Begins to bring what is at the address into the cache, where the compiler knows how to.
void Prefetch([[maybe_unused]] const void* address)
{
#ifdef __GNUC__
  __builtin_prefetch(address);
#endif
}

/// A half-edge with a mark, and what decides when one comes to it along the constraints.
struct BorderEdge
{
  Id Edge = NoId;
  Id Constraint = NoId;
  Point2 Place;           ///< the end that is nearer to the constraint's start
  bool IsReverse = false; ///< the constraint leads from greater points to less ones
  bool IsRight = false;   ///< the triangle is on the right of the constraint
};

/// Ends are compared along the constraint by the order of points: exact, as they are collinear.
bool ComesBefore(const BorderEdge& a, const BorderEdge& b)
{
  if (a.Constraint != b.Constraint)
  {
    return a.Constraint < b.Constraint;
  }
  if (a.Place != b.Place)
  {
    return (a.Place < b.Place) != a.IsReverse;
  }
  return !a.IsRight && b.IsRight;
}

BorderEdge MakeBorderEdge(const HalfEdgeMesh& mesh, const ConstraintEdges& constraints, Id edge)
{
  const Id constraint = mesh.Mark(edge) / 2;
  const Point2& origin = mesh.PointAt(mesh.Origin(edge));
  const Point2& target = mesh.PointAt(mesh.Target(edge));
  const bool isReverse =
    mesh.PointAt(constraints.Ends[constraint]) < mesh.PointAt(constraints.Starts[constraint]);
  const bool isRight = (target < origin) != isReverse;
  return { edge, constraint, isRight ? target : origin, isReverse, isRight };
}

/// All half-edges with a mark, along the constraints; `marked` has the triangles that may have one.
std::vector<BorderEdge> CollectBorder(const HalfEdgeMesh& mesh, const ConstraintEdges& constraints,
  const std::vector<Id>& marked, Pulse& pulse)
{
  const PulsePart part(pulse, FacesEnd, BorderEnd);
  std::vector<BorderEdge> border;
  pulse.ForEach(marked.size(),
    [&mesh, &constraints, &marked, &border](std::size_t k)
    {
      const Id first = HalfEdgeMesh::FirstEdge(marked[k]);
      for (Id edge = first; edge < first + 3; ++edge)
      {
        if (mesh.Mark(edge) != NoId)
        {
          border.push_back(MakeBorderEdge(mesh, constraints, edge));
        }
      }
    });
  SortInSteps(border, ComesBefore, pulse);
  return border;
}

/// The faces that marks part: sets of triangles that share edges without one, numbered by their
/// first triangles.
class Faces
{
public:
  Faces(const HalfEdgeMesh& mesh, Pulse& pulse)
  {
    const PulsePart part(pulse, 0.0, FacesEnd);
    DisjointSets sets(static_cast<std::size_t>(mesh.NumberOfTriangles));
    pulse.ForEach(sets.Size(),
      [this, &mesh, &sets](std::size_t t)
      {
        const Id triangle = static_cast<Id>(t);
        const bool hasMarks = mesh.HasMarks(triangle);
        for (Id edge = 4 * triangle; edge < 4 * triangle + 3; ++edge)
        {
          const Id neighbor = HalfEdgeMesh::TriangleOf(mesh.Twins[edge]);
          if (neighbor < triangle && (!hasMarks || mesh.Mark(edge) == NoId))
          {
            sets.Unite(triangle, neighbor);
          }
        }
        if (hasMarks)
        {
          this->WithMarks.push_back(triangle);
        }
      });
    this->OfTriangle.reserve(sets.Size());
    pulse.ForEach(sets.Size(),
      [this, &mesh, &sets](std::size_t t)
      {
        const Id triangle = static_cast<Id>(t);
        const Id first = sets.SetOf(triangle);
        this->OfTriangle.push_back(first == triangle ? this->Count++ : this->OfTriangle[first]);
        if (this->Outer == NoId && mesh.IsGhost(triangle))
        {
          this->Outer = this->OfTriangle.back();
        }
      });
  }

  Id Size() const { return this->Count; }
  Id FaceOf(Id triangle) const { return this->OfTriangle[triangle]; }

  /// The face beyond the convex hull.
  Id OuterFace() const { return this->Outer; }

  /// The triangles that have or had marks, ascending.
  const std::vector<Id>& Marked() const { return this->WithMarks; }

  std::vector<Id> Take() { return std::move(this->OfTriangle); }

private:
  std::vector<Id> OfTriangle;
  std::vector<Id> WithMarks;
  Id Count = 0;
  Id Outer = NoId;
};

/// A step from face to face, across a half-edge with a mark.
struct Step
{
  Id From = NoId;
  Id To = NoId;
  std::uint8_t IsOdd = 0;
};

/// Face -> 1 where it is an odd number of boundaries away from the outer face.
std::vector<std::uint8_t> FindInside(
  const HalfEdgeMesh& mesh, const std::vector<BorderEdge>& border, const Faces& faces, Pulse& pulse)
{
  constexpr std::uint8_t unknown = 2;
  std::vector<Step> steps;
  steps.reserve(border.size());
  for (const BorderEdge& one : border)
  {
    steps.push_back({ faces.FaceOf(HalfEdgeMesh::TriangleOf(one.Edge)),
      faces.FaceOf(HalfEdgeMesh::TriangleOf(mesh.Twins[one.Edge])),
      static_cast<std::uint8_t>(mesh.Mark(one.Edge) & 1) });
  }
  const auto isBefore = [](const Step& a, const Step& b) { return a.From < b.From; };
  SortInSteps(steps, isBefore, pulse);
  std::vector<std::uint8_t> isInside(static_cast<std::size_t>(faces.Size()), unknown);
  std::vector<Id> queue{ faces.OuterFace() };
  isInside[faces.OuterFace()] = 0;
  for (std::size_t next = 0; next < queue.size() && pulse.Beat(); ++next)
  {
    const Id face = queue[next];
    for (auto step = std::lower_bound(steps.begin(), steps.end(), Step{ face, NoId, 0 }, isBefore);
         step != steps.end() && step->From == face; ++step)
    {
      if (isInside[step->To] == unknown)
      {
        isInside[step->To] = isInside[face] ^ step->IsOdd;
        queue.push_back(step->To);
      }
    }
  }
  return isInside;
}

/// The regions: the faces inside.
struct Regions
{
  std::vector<Id> OfFace; ///< face -> region, NoId outside
  Id Size = 0;
};

Regions NumberRegions(
  const HalfEdgeMesh& mesh, const std::vector<BorderEdge>& border, const Faces& faces, Pulse& pulse)
{
  const PulsePart part(pulse, BorderEnd, RegionsEnd);
  const std::vector<std::uint8_t> isInside = FindInside(mesh, border, faces, pulse);
  Regions regions;
  regions.OfFace.assign(faces.Size(), NoId);
  for (std::size_t k = 0; k < border.size() && pulse.Beat(); ++k)
  {
    const Id face = faces.FaceOf(HalfEdgeMesh::TriangleOf(border[k].Edge));
    if (isInside[face] == 1 && regions.OfFace[face] == NoId)
    {
      regions.OfFace[face] = regions.Size++;
    }
  }
  return regions;
}

/// Copies triangles out: renumbered, without gaps and ghosts.
class Writer
{
public:
  /// `numbers` are the faces of the triangles.
  Writer(HalfEdgeMesh& mesh, const std::vector<Id>& order, std::vector<Id>&& numbers, Pulse& pulse)
    : Mesh(mesh)
    , Order(order)
    , Beats(pulse)
    , Numbers(std::move(numbers))
  {
  }

  /// Empty on abort.
  Triangulation Write(const Regions& regions)
  {
    this->CountTriangles(regions);
    this->NumberTriangles();
    this->WriteTriangles();
    return this->Beats.HasStopped() ? Triangulation() : std::move(this->Result);
  }

private:
  Id& LastCorner(std::size_t triangle)
  {
    return this->Mesh.Corners[HalfEdgeMesh::FirstEdge(static_cast<Id>(triangle)) + 3];
  }

  /// Numbers become those of the regions.
  void CountTriangles(const Regions& regions)
  {
    const PulsePart part(this->Beats, RegionsEnd, CountsEnd);
    this->Sizes.assign(regions.Size + 1, 0);
    const std::size_t points = 1 + *std::max_element(this->Order.begin(), this->Order.end());
    this->Begins.resize(points + 1);
    this->Beats.ForEach(this->Numbers.size(),
      [this, &regions](std::size_t triangle)
      {
        const Id region = regions.OfFace[this->Numbers[triangle]];
        this->Numbers[triangle] = region;
        if (region != NoId)
        {
          this->TakePoints(triangle);
          ++this->Sizes[region + 1];
          ++this->Begins[this->LastCorner(triangle) + 1];
        }
      });
  }

  /// Corners become points of the caller; the place beside them, which is free, takes the last one.
  void TakePoints(std::size_t triangle)
  {
    Id* corners = &this->Mesh.Corners[HalfEdgeMesh::FirstEdge(static_cast<Id>(triangle))];
    for (int k = 0; k < 3; ++k)
    {
      corners[k] = this->Order[corners[k]];
    }
    corners[3] = std::max({ corners[0], corners[1], corners[2] });
  }

  /// The triangles inside, by counting.
  std::vector<Id> SortByLastCorner()
  {
    std::vector<Id> sorted(this->Result.Regions.size());
    this->Beats.ForEach(this->Begins.size() - 1,
      [this](std::size_t point) { this->Begins[point + 1] += this->Begins[point]; });
    this->Beats.ForEach(this->Numbers.size(),
      [this, &sorted](std::size_t triangle)
      {
        if (this->Numbers[triangle] != NoId)
        {
          sorted[this->Begins[this->LastCorner(triangle)]++] = static_cast<Id>(triangle);
        }
      });
    ReleaseInSteps(this->Beats, this->Begins);
    return sorted;
  }

  /// Keeps the order within each.
  std::vector<Id> SortByRegion(std::vector<Id> sorted)
  {
    std::vector<Id> inside(sorted.size());
    this->Beats.ForEach(sorted.size(),
      [this, &sorted, &inside](std::size_t place)
      { inside[this->Sizes[this->Numbers[sorted[place]]]++] = sorted[place]; });
    return inside;
  }

  /// Region by region, within by last corners; fills Regions of the result.
  void NumberTriangles()
  {
    const PulsePart part(this->Beats, CountsEnd, NumbersEnd);
    for (std::size_t region = 0; region + 1 < this->Sizes.size(); ++region)
    {
      this->Result.Regions.resize(
        this->Result.Regions.size() + this->Sizes[region + 1], static_cast<Id>(region));
      this->Sizes[region + 1] += this->Sizes[region];
    }
    std::vector<Id> sorted = this->SortByLastCorner();
    const bool isOne = this->Sizes.size() == 2;
    this->Inside = isOne ? std::move(sorted) : this->SortByRegion(std::move(sorted));
    this->Beats.ForEach(this->Inside.size(),
      [this](std::size_t number)
      { this->Numbers[this->Inside[number]] = static_cast<Id>(number); });
  }

  /// The order of the result is not that of the memory: what the next triangles need is fetched,
  /// then what their neighbors do.
  void WriteTriangles()
  {
    const PulsePart part(this->Beats, NumbersEnd, 1.0);
    const std::size_t size = this->Inside.size();
    this->Result.Neighbors.resize(3 * size, NoId);
    this->Result.Constraints.resize(3 * size, NoId);
    this->Result.Corners.resize(3 * size, NoId);
    constexpr std::size_t FarAhead = 24;
    constexpr std::size_t Ahead = 12;
    this->Beats.ForEach(size,
      [this, last = size - 1](std::size_t number)
      {
        const Id far = HalfEdgeMesh::FirstEdge(this->Inside[std::min(number + FarAhead, last)]);
        Prefetch(&this->Mesh.Twins[far]);
        Prefetch(&this->Mesh.Corners[far]);
        const Id near = HalfEdgeMesh::FirstEdge(this->Inside[std::min(number + Ahead, last)]);
        for (Id edge = near; edge < near + 3; ++edge)
        {
          Prefetch(&this->Numbers[HalfEdgeMesh::TriangleOf(this->Mesh.Twins[edge])]);
        }
        this->WriteTriangle(HalfEdgeMesh::FirstEdge(this->Inside[number]), 3 * number);
      });
    ReleaseInSteps(
      this->Beats, this->Mesh.Marks, this->Mesh.Twins, this->Mesh.Corners, this->Numbers);
  }

  void WriteTriangle(Id first, std::size_t slot)
  {
    const bool hasMarks = this->Mesh.HasMarks(HalfEdgeMesh::TriangleOf(first));
    for (Id edge = first; edge < first + 3; ++edge, ++slot)
    {
      const Id mark = hasMarks ? this->Mesh.Mark(edge) : NoId;
      this->Result.Constraints[slot] = mark == NoId ? NoId : mark / 2;
      this->Result.Neighbors[slot] =
        this->Numbers[HalfEdgeMesh::TriangleOf(this->Mesh.Twins[edge])];
      this->Result.Corners[slot] = this->Mesh.Corners[edge];
    }
  }

  HalfEdgeMesh& Mesh;
  const std::vector<Id>& Order;
  Pulse& Beats;
  std::vector<Id> Numbers; ///< triangle of the mesh -> of the result, NoId outside
  std::vector<Id> Inside;  ///< triangle of the result -> of the mesh
  std::vector<Id> Sizes;   ///< of region r: entry r + 1
  std::vector<Id> Begins;  ///< how many triangles have point p as their last corner: entry p + 1
  Triangulation Result;
};

} // namespace

Triangulation TakeInside(HalfEdgeMesh& mesh, const ConstraintEdges& constraints,
  const std::vector<Id>& order, Pulse& pulse)
{
  ReleaseInSteps(pulse, mesh.VertexEdges);
  Faces faces(mesh, pulse);
  if (pulse.HasStopped())
  {
    return {};
  }
  const std::vector<BorderEdge> border = CollectBorder(mesh, constraints, faces.Marked(), pulse);
  ReleaseInSteps(pulse, mesh.Points);
  const Regions regions = NumberRegions(mesh, border, faces, pulse);
  return Writer(mesh, order, faces.Take(), pulse).Write(regions);
}

} // namespace biting
