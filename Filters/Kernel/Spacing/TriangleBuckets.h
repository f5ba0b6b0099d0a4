// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingTriangleBuckets_h
#define BitingTriangleBuckets_h

#include "../Base/Box.h"
#include "../Base/Ids.h"
#include "../Base/Pulse.h"

#include <vector> // for the arrays

namespace biting
{

/// Which triangles may contain a point, for triangles of very different sizes.
///
/// A grid of cells over the box of all triangles; a cell that many triangles meet is itself cut by
/// a grid, and so on. The cells of each grid have the shape and number of the triangles in it, so
/// that graded and stretched triangulations need few levels. Cost: about linear to build, one
/// arithmetic step a level to find a leaf, a handful of triangles in a leaf.
class TriangleBuckets
{
public:
  struct Range
  {
    const Id* First;
    const Id* Last;
    const Id* begin() const { return this->First; }
    const Id* end() const { return this->Last; }
  };

  /// Of three corners a triangle: at least one, and each has an area.
  /// Incomplete if the pulse stops: it must not be asked then.
  TriangleBuckets(const std::vector<Point2>& points, const std::vector<Id>& corners, Pulse& pulse);

  /// All triangles that meet the leaf of x; outside, those of the nearest leaf along the axes.
  Range Near(const Point2& x) const
  {
    const Cell* cell = &this->Cells.front();
    while (cell->Count < 0)
    {
      const Grid& grid = this->Grids[static_cast<std::size_t>(cell->First)];
      cell = &this->Cells[static_cast<std::size_t>(
        grid.FirstCell + grid.Column(x.X) + grid.Columns * grid.Row(x.Y))];
    }
    const Id* first = this->Entries.data() + cell->First;
    return { first, first + cell->Count };
  }

  /// How often triangles are in leaves, and in cells that are cut.
  std::size_t NumberOfEntries() const { return this->Entries.size(); }

private:
  struct Cell
  {
    Id First = 0; ///< of its entries, or the grid that cuts it
    Id Count = 0; ///< of its entries, or -1: cut by a grid
  };

  /// Column and Row are monotone, also after rounding, and clamp what lies outside (or is NaN).
  struct Grid
  {
    Point2 Low;
    Point2 CellsPerLength;
    Id Columns = 1;
    Id Rows = 1;
    Id FirstCell = 0;

    Id Column(double x) const { return Clamp((x - Low.X) * CellsPerLength.X, Columns - 1); }
    Id Row(double y) const { return Clamp((y - Low.Y) * CellsPerLength.Y, Rows - 1); }

    static Id Clamp(double position, Id last)
    {
      const double least = position > 0.0 ? position : 0.0;
      return least < last ? static_cast<Id>(least) : last;
    }
  };

  /// Of triangles, added up.
  struct Extents
  {
    Point2 Sum;
    double Area;
    double Count;

    /// In how many cells of a grid each is filed, in the mean. A convex shape meets about as many
    /// cells as its area and its two extents, in cells, add up to.
    double CopiesIn(const Point2& density) const
    {
      return 1.0 + (Sum.X * density.X + Sum.Y * density.Y + Area * density.X * density.Y) / Count;
    }
  };

  void Cut(Id cellId, const Box2& box, const std::vector<Id>& ids, int depth, double copies);
  Extents Measure(const Box2& box, const std::vector<Id>& ids) const;
  Grid ChooseGrid(const Box2& box, const std::vector<Id>& ids, double copies) const;
  void File(const Grid& grid, const Box2& box, const std::vector<Id>& ids);

  struct Source;

  const Source* Triangles = nullptr; ///< only while building
  Pulse* Beats = nullptr;            ///< only while building
  std::vector<Cell> Cells;           ///< the first one is the root
  std::vector<Grid> Grids;
  std::vector<Id> Entries; ///< those of cells that are cut are no longer asked for
};

} // namespace biting

#endif
