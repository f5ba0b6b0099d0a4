// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingBiteFrame_h
#define BitingBiteFrame_h

#include "../Base/Box.h"
#include "../Base/CellIndex.h"
#include "../Base/Ids.h"
#include "../Base/Point.h"
#include "BiteLists.h" // for entries
#include "Bites.h"

#include <cstddef> // for a count

namespace biting
{

/// A bite in units of a grid's cells.
struct FramedBite
{
  Id Bite;
  double X, Y;    ///< its centre
  double Reach;   ///< half-width and slack
  CellBox Extent; ///< as far as it is filed
};

/// A cell's low corner, in units of a grid's cells.
struct CellPlace
{
  double X, Y;
};

/// A bite as cells of one size see it.
struct SizedBite
{
  double Size;    ///< of the cells, in units of those at the top: a power of two
  double PerSize; ///< its inverse
  float Square;   ///< of the bite's reach, in units of the cells
};

/// A grid of equal squares over a box, and how bites lie in it: how far each is filed, and what
/// stands of it in the list of a cell.
class BiteFrame
{
public:
  /// `nearReach`: how far from its centre a bite is filed at least, in half-widths. `slack`: how
  /// far outside of it, as a length.
  BiteFrame(const Bites& bites, const Box2& bounds, double nearReach, double slack);

  double Area() const { return this->Extents.X * this->Extents.Y; }
  void SetCellsPerLength(double cellsPerLength);
  double CellsPerLength() const { return this->Scale; }
  Id Columns() const { return this->NumberOfColumns; }
  Id Rows() const { return this->NumberOfRows; }
  std::size_t Size() const; ///< of the grid, in cells

  /// In units of a cell, from the low corner of the grid.
  Point2 ToGrid(const Point2& p) const
  {
    return { (p.X - this->Origin.X) * this->Scale, (p.Y - this->Origin.Y) * this->Scale };
  }

  /// The square about a point.
  CellBox ToGrid(const Point2& center, double reach) const
  {
    return { (center.X - reach - this->Origin.X) * this->Scale,
      (center.Y - reach - this->Origin.Y) * this->Scale,
      (center.X + reach - this->Origin.X) * this->Scale,
      (center.Y + reach - this->Origin.Y) * this->Scale };
  }

  CellBox ExtentOf(Id bite) const;
  FramedBite Framed(Id bite) const;
  SizedBite InCells(const FramedBite& bite, double size) const;

  /// What stands in the list of a leaf.
  static BiteEntry EntryOf(const FramedBite& bite, const SizedBite& sized, const CellPlace& leaf)
  {
    return { static_cast<float>((bite.X - leaf.X) * sized.PerSize),
      static_cast<float>((bite.Y - leaf.Y) * sized.PerSize), sized.Square, bite.Bite };
  }

  /// Calls visit(column, row, cell) for the cells that the box meets.
  template <typename Visit>
  void VisitCells(const CellBox& box, Visit&& visit) const
  {
    VisitCellsAt(box, this->NumberOfColumns, this->NumberOfRows,
      [this, &visit](Id column, Id row)
      {
        visit(column, row, row * this->NumberOfColumns + column);
        return false;
      });
  }

private:
  const Bites& All;
  Point2 Origin;
  Point2 Extents; ///< width and height
  double Scale = 1.0;
  Id NumberOfColumns = 1;
  Id NumberOfRows = 1;
  double NearReach; ///< in half-widths
  double Slack;     ///< a length
};

} // namespace biting

#endif
