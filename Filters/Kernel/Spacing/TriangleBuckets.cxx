// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "TriangleBuckets.h"

#include <algorithm> // for min, max
#include <array>     // for corners
#include <numeric>   // for iota
#include <utility>   // for pairs

namespace biting
{
namespace
{

/// Measured: fewer entries cost memory and build time, more cost evaluation time.
constexpr std::size_t EntriesPerLeaf = 12;
constexpr double TrianglesPerCell = 2.0;

/// How often a triangle may be filed, about: a grid that needs more is made coarser. All levels
/// share what is allowed, or long triangles, which no grid can tell apart, would multiply.
constexpr double MaximumCopies = 16.0;

/// Many triangles around one vertex cannot be told apart by any number of levels.
constexpr int MaximumDepth = 10;

using Corners = std::array<Point2, 3>;

Box2 BoxOf(const Corners& corners)
{
  Box2 box;
  for (const Point2& corner : corners)
  {
    box.Add(corner);
  }
  return box;
}

Box2 Intersection(const Box2& a, const Box2& b)
{
  return { { std::max(a.Low.X, b.Low.X), std::max(a.Low.Y, b.Low.Y) },
    { std::min(a.High.X, b.High.X), std::min(a.High.Y, b.High.Y) } };
}

/// Which boxes of half sizes `half` may meet a triangle: none of its sides has the whole box on its
/// outside. With room for rounding: a triangle filed too often costs nothing but time.
class CellTest
{
public:
  CellTest(const Corners& corners, const Point2& half)
    : Origin(corners[0])
  {
    const double turn = Cross(corners[1] - corners[0], corners[2] - corners[0]) < 0.0 ? -1.0 : 1.0;
    for (std::size_t k = 0; k < 3; ++k)
    {
      constexpr double RoomForRounding = 1.000001;
      const Point2 inwards = turn * Perpendicular(corners[k == 2 ? 0 : k + 1] - corners[k]);
      const double reach = std::abs(inwards.X) * half.X + std::abs(inwards.Y) * half.Y;
      this->Inwards[k] = inwards;
      this->Least[k] = Dot(inwards, corners[k] - this->Origin) - RoomForRounding * reach;
    }
  }

  bool operator()(const Point2& center) const
  {
    const Point2 offset = center - this->Origin;
    return Dot(this->Inwards[0], offset) >= this->Least[0] &&
      Dot(this->Inwards[1], offset) >= this->Least[1] &&
      Dot(this->Inwards[2], offset) >= this->Least[2];
  }

private:
  Point2 Origin;
  std::array<Point2, 3> Inwards;
  std::array<double, 3> Least;
};

} // namespace

/// The triangles, by the ids of their corners.
struct TriangleBuckets::Source
{
  const std::vector<Point2>& Points;
  const std::vector<Id>& Ids;

  Point2 PlaceOf(std::size_t corner) const
  {
    return this->Points[static_cast<std::size_t>(this->Ids[corner])];
  }

  Corners operator[](Id triangle) const
  {
    const std::size_t first = 3 * static_cast<std::size_t>(triangle);
    return { this->PlaceOf(first), this->PlaceOf(first + 1), this->PlaceOf(first + 2) };
  }
};

TriangleBuckets::TriangleBuckets(
  const std::vector<Point2>& points, const std::vector<Id>& corners, Pulse& pulse)
  : Beats(&pulse)
{
  const Source source{ points, corners };
  this->Triangles = &source;
  Box2 box;
  for (const Id point : corners)
  {
    box.Add(points[static_cast<std::size_t>(point)]);
  }
  this->Entries.resize(corners.size() / 3);
  std::iota(this->Entries.begin(), this->Entries.end(), 0);
  this->Cells.push_back({ 0, static_cast<Id>(this->Entries.size()) });
  this->Cut(0, box, std::vector<Id>(this->Entries), 0, MaximumCopies);
  this->Triangles = nullptr;
  this->Beats = nullptr;
}

/// Where a cell has many entries, `ids`.
void TriangleBuckets::Cut(
  Id cellId, const Box2& box, const std::vector<Id>& ids, int depth, double copies)
{
  Grid grid = this->ChooseGrid(box, ids, copies);
  const Id cells = grid.Columns * grid.Rows;
  if (ids.size() <= EntriesPerLeaf || depth == MaximumDepth || cells < 2)
  {
    return;
  }
  const std::size_t before = depth == 0 ? 0 : this->Entries.size();
  this->Entries.resize(before);
  grid.FirstCell = static_cast<Id>(this->Cells.size());
  this->Cells[static_cast<std::size_t>(cellId)] = { static_cast<Id>(this->Grids.size()), -1 };
  this->Grids.push_back(grid);
  this->File(grid, box, ids);
  const Point2 size{ box.Width() / grid.Columns, box.Height() / grid.Rows };
  for (Id cell = 0; cell < cells && this->Beats->Beat(); ++cell)
  {
    const Cell filed = this->Cells[static_cast<std::size_t>(grid.FirstCell + cell)];
    if (static_cast<std::size_t>(filed.Count) > EntriesPerLeaf)
    {
      const Point2 low{ box.Low.X + (cell % grid.Columns) * size.X,
        box.Low.Y + (cell / grid.Columns) * size.Y };
      const auto first = this->Entries.begin() + filed.First;
      const std::vector<Id> own(first, first + filed.Count);
      const double copiesLeft = copies / this->Measure(box, own).CopiesIn(grid.CellsPerLength);
      this->Cut(grid.FirstCell + cell, { low, low + size }, own, depth + 1, copiesLeft);
    }
  }
}

/// As far as they are in a box.
TriangleBuckets::Extents TriangleBuckets::Measure(const Box2& box, const std::vector<Id>& ids) const
{
  Extents all{ {}, 0.0, static_cast<double>(ids.size()) };
  for (Id id : ids)
  {
    this->Beats->Beat();
    const Corners corners = (*this->Triangles)[id];
    const Box2 own = Intersection(box, BoxOf(corners));
    const Point2 size{ std::max(own.Width(), 0.0), std::max(own.Height(), 0.0) };
    const double area = 0.5 * std::abs(Cross(corners[1] - corners[0], corners[2] - corners[0]));
    all.Sum = all.Sum + size;
    all.Area += std::min(area, size.X * size.Y);
  }
  return all;
}

/// As many cells as asked for by the number of triangles, in the proportions of their mean box, but
/// not so many that long triangles are filed again and again.
TriangleBuckets::Grid TriangleBuckets::ChooseGrid(
  const Box2& box, const std::vector<Id>& ids, double copies) const
{
  const Extents all = this->Measure(box, ids);
  const Point2 ratio{ box.Width() * all.Count / std::max(all.Sum.X, box.Width()),
    box.Height() * all.Count / std::max(all.Sum.Y, box.Height()) };
  double shrink = std::sqrt(all.Count / TrianglesPerCell / (ratio.X * ratio.Y));
  Grid grid;
  do
  {
    grid.Low = box.Low;
    grid.Columns = std::max(static_cast<Id>(std::min(ratio.X * shrink, all.Count)), 1);
    grid.Rows = std::max(static_cast<Id>(std::min(ratio.Y * shrink, all.Count)), 1);
    grid.CellsPerLength = { grid.Columns / box.Width(), grid.Rows / box.Height() };
    shrink *= 0.7;
  } while (grid.Columns * grid.Rows > 1 && all.CopiesIn(grid.CellsPerLength) > copies);
  return grid;
}

/// Adds the cells of a grid, and their entries.
void TriangleBuckets::File(const Grid& grid, const Box2& box, const std::vector<Id>& ids)
{
  const auto first = static_cast<std::size_t>(grid.FirstCell);
  this->Cells.resize(first + static_cast<std::size_t>(grid.Columns * grid.Rows));
  const Point2 half{ 0.5 * box.Width() / grid.Columns, 0.5 * box.Height() / grid.Rows };
  std::vector<std::pair<Id, Id>> filed; // cells and ids
  filed.reserve(4 * ids.size());
  for (Id id : ids)
  {
    this->Beats->Beat();
    const Corners corners = (*this->Triangles)[id];
    const Box2 own = BoxOf(corners);
    const CellTest mayMeet(corners, half);
    const Id lastRow = grid.Row(own.High.Y);
    const Id lastColumn = grid.Column(own.High.X);
    for (Id row = grid.Row(own.Low.Y); row <= lastRow; ++row)
    {
      for (Id column = grid.Column(own.Low.X); column <= lastColumn; ++column)
      {
        if (mayMeet({ box.Low.X + (2 * column + 1) * half.X, box.Low.Y + (2 * row + 1) * half.Y }))
        {
          filed.emplace_back(grid.FirstCell + column + grid.Columns * row, id);
          ++this->Cells[static_cast<std::size_t>(filed.back().first)].Count;
        }
      }
    }
  }
  auto end = static_cast<Id>(this->Entries.size());
  for (std::size_t cell = first; cell < this->Cells.size(); ++cell)
  {
    this->Cells[cell].First = end;
    end += this->Cells[cell].Count;
    this->Cells[cell].Count = 0;
  }
  this->Entries.resize(static_cast<std::size_t>(end));
  for (const auto& [cellId, id] : filed)
  {
    Cell& cell = this->Cells[static_cast<std::size_t>(cellId)];
    this->Entries[static_cast<std::size_t>(cell.First + cell.Count++)] = id;
  }
}

} // namespace biting
