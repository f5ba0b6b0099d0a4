// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "TriangleBuckets.h"

#include <algorithm> // for min, max
#include <numeric>   // for partial_sum

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

Box2 BoxOf(const TriangleBuckets::Corners& corners)
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

/// Whether the line of an edge separates the triangle from a box of half sizes `half`. With room
/// for rounding: a triangle filed too often costs nothing but time.
bool Separates(const Point2& start, const Point2& end, const Point2& opposite, const Point2& center,
  const Point2& half)
{
  const Point2 normal = Perpendicular(end - start);
  const double reach = std::abs(normal.X) * half.X + std::abs(normal.Y) * half.Y;
  const double boxSide = Dot(normal, center - start);
  const double ownSide = Dot(normal, opposite - start);
  constexpr double RoomForRounding = 1.000001;
  return ownSide > 0.0 ? boxSide < -RoomForRounding * reach : boxSide > RoomForRounding * reach;
}

bool MayMeet(const TriangleBuckets::Corners& t, const Point2& center, const Point2& half)
{
  return !Separates(t[0], t[1], t[2], center, half) && !Separates(t[1], t[2], t[0], center, half) &&
    !Separates(t[2], t[0], t[1], center, half);
}

} // namespace

/// The entries of the cells of one grid: those of cell c are Ids[Starts[c]] to Ids[Starts[c + 1]].
struct TriangleBuckets::Filing
{
  std::vector<Id> Starts;
  std::vector<Id> Ids;
};

TriangleBuckets::TriangleBuckets(const std::vector<Corners>& triangles, Pulse& pulse)
  : Triangles(&triangles)
  , Beats(&pulse)
{
  Box2 box;
  std::vector<Id> ids(triangles.size());
  for (std::size_t triangle = 0; triangle < triangles.size(); ++triangle)
  {
    ids[triangle] = static_cast<Id>(triangle);
    const Box2 own = BoxOf(triangles[triangle]);
    box.Add(own.Low);
    box.Add(own.High);
  }
  this->Cells.resize(1);
  this->Fill(0, box, ids, 0, MaximumCopies);
  this->Triangles = nullptr;
  this->Beats = nullptr;
}

void TriangleBuckets::Fill(
  Id cellId, const Box2& box, const std::vector<Id>& ids, int depth, double copies)
{
  const bool isLeaf = ids.size() <= EntriesPerLeaf || depth == MaximumDepth;
  Grid grid = isLeaf ? Grid() : this->ChooseGrid(box, ids, copies);
  if (grid.Columns * grid.Rows < 2)
  {
    this->FillLeaf(cellId, ids);
    return;
  }
  const Filing filing = this->File(grid, box, ids);
  grid.FirstCell = static_cast<Id>(this->Cells.size());
  this->Cells[static_cast<std::size_t>(cellId)] = { static_cast<Id>(this->Grids.size()), -1 };
  this->Grids.push_back(grid);
  this->Cells.resize(this->Cells.size() + static_cast<std::size_t>(grid.Columns * grid.Rows));
  const Point2 size{ box.Width() / grid.Columns, box.Height() / grid.Rows };
  for (Id cell = 0; cell < grid.Columns * grid.Rows && this->Beats->Beat(); ++cell)
  {
    const Point2 low{ box.Low.X + (cell % grid.Columns) * size.X,
      box.Low.Y + (cell / grid.Columns) * size.Y };
    const auto first = filing.Starts.begin() + cell;
    const std::vector<Id> own(filing.Ids.begin() + first[0], filing.Ids.begin() + first[1]);
    const double copiesLeft = copies / this->ExpectedCopies(grid, box, own);
    this->Fill(grid.FirstCell + cell, { low, low + size }, own, depth + 1, copiesLeft);
  }
}

void TriangleBuckets::FillLeaf(Id cellId, const std::vector<Id>& ids)
{
  this->Cells[static_cast<std::size_t>(cellId)] = { static_cast<Id>(this->Entries.size()),
    static_cast<Id>(ids.size()) };
  this->Entries.insert(this->Entries.end(), ids.begin(), ids.end());
}

/// As many cells as asked for by the number of triangles, in the proportions of their mean box, but
/// not so many that long triangles are filed again and again.
TriangleBuckets::Grid TriangleBuckets::ChooseGrid(
  const Box2& box, const std::vector<Id>& ids, double copies) const
{
  Point2 extent;
  for (Id id : ids)
  {
    this->Beats->Beat();
    const Box2 own = Intersection(box, BoxOf((*this->Triangles)[static_cast<std::size_t>(id)]));
    extent = extent + Point2{ std::max(own.Width(), 0.0), std::max(own.Height(), 0.0) };
  }
  const auto count = static_cast<double>(ids.size());
  const Point2 ratio{ box.Width() * count / std::max(extent.X, box.Width()),
    box.Height() * count / std::max(extent.Y, box.Height()) };
  double shrink = std::sqrt(count / TrianglesPerCell / (ratio.X * ratio.Y));
  Grid grid;
  do
  {
    grid.Low = box.Low;
    grid.Columns = std::max(static_cast<Id>(std::min(ratio.X * shrink, count)), 1);
    grid.Rows = std::max(static_cast<Id>(std::min(ratio.Y * shrink, count)), 1);
    grid.CellsPerLength = { grid.Columns / box.Width(), grid.Rows / box.Height() };
    shrink *= 0.7;
  } while (grid.Columns * grid.Rows > 1 && this->ExpectedCopies(grid, box, ids) > copies);
  return grid;
}

/// In how many cells of a grid each triangle is filed, in the mean. A convex shape meets about as
/// many cells as its area and its two extents, in cells, add up to.
double TriangleBuckets::ExpectedCopies(
  const Grid& grid, const Box2& box, const std::vector<Id>& ids) const
{
  double entries = 0.0;
  for (Id id : ids)
  {
    this->Beats->Beat();
    const Corners& corners = (*this->Triangles)[static_cast<std::size_t>(id)];
    const Box2 own = Intersection(box, BoxOf(corners));
    const double columns = std::max(own.Width(), 0.0) * grid.CellsPerLength.X;
    const double rows = std::max(own.Height(), 0.0) * grid.CellsPerLength.Y;
    const double area = 0.5 * std::abs(Cross(corners[1] - corners[0], corners[2] - corners[0])) *
      grid.CellsPerLength.X * grid.CellsPerLength.Y;
    entries += 1.0 + columns + rows + std::min(area, columns * rows);
  }
  return ids.empty() ? 1.0 : entries / static_cast<double>(ids.size());
}

TriangleBuckets::Filing TriangleBuckets::File(
  const Grid& grid, const Box2& box, const std::vector<Id>& ids) const
{
  Filing filing;
  filing.Starts.assign(static_cast<std::size_t>(grid.Columns * grid.Rows) + 1, 0);
  this->ForEachMeeting(grid, box, ids,
    [&filing](Id cell, Id) { ++filing.Starts[static_cast<std::size_t>(cell) + 1]; });
  std::partial_sum(filing.Starts.begin(), filing.Starts.end(), filing.Starts.begin());
  filing.Ids.resize(static_cast<std::size_t>(filing.Starts.back()));
  std::vector<Id> next = filing.Starts;
  this->ForEachMeeting(grid, box, ids,
    [&filing, &next](Id cell, Id id)
    { filing.Ids[static_cast<std::size_t>(next[static_cast<std::size_t>(cell)]++)] = id; });
  return filing;
}

/// Calls visit(cell, id) for each triangle and each cell of the grid that it may meet.
template <typename Visit>
void TriangleBuckets::ForEachMeeting(
  const Grid& grid, const Box2& box, const std::vector<Id>& ids, Visit visit) const
{
  const Point2 half{ 0.5 * box.Width() / grid.Columns, 0.5 * box.Height() / grid.Rows };
  for (Id id : ids)
  {
    this->Beats->Beat();
    const Corners& corners = (*this->Triangles)[static_cast<std::size_t>(id)];
    const Box2 own = BoxOf(corners);
    for (Id row = grid.Row(own.Low.Y); row <= grid.Row(own.High.Y); ++row)
    {
      for (Id column = grid.Column(own.Low.X); column <= grid.Column(own.High.X); ++column)
      {
        const Point2 center{ box.Low.X + (2 * column + 1) * half.X,
          box.Low.Y + (2 * row + 1) * half.Y };
        if (MayMeet(corners, center, half))
        {
          visit(column + grid.Columns * row, id);
        }
      }
    }
  }
}

} // namespace biting
