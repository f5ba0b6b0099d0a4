// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingCellIndex_h
#define BitingCellIndex_h

#include "Ids.h"

// Positions and boxes in units of the cells of a grid, which is a part of rows and columns.

namespace biting
{

/// The cell that a position is in, of `count` in a row; the first or the last one beyond the ends.
inline Id ClampedIndex(double position, Id count)
{
  return position <= 0.0 ? 0 : (position >= count ? count - 1 : static_cast<Id>(position));
}

/// A box in units of a cell, relative to its low corner.
struct CellBox
{
  double LowX, LowY, HighX, HighY;

  /// The same box, relative to a cell of the grid.
  CellBox From(Id column, Id row) const
  {
    return { this->LowX - column, this->LowY - row, this->HighX - column, this->HighY - row };
  }

  /// The same box in units of the parts of a cell that is divided so.
  CellBox Divided(Id columns, Id rows) const
  {
    return { this->LowX * columns, this->LowY * rows, this->HighX * columns, this->HighY * rows };
  }
};

/// Calls visit(column, row) for the cells of a grid that the box meets, row by row, until it
/// returns true. A box beyond the grid meets the cells at its border.
template <typename Visit>
bool VisitCellsAt(const CellBox& box, Id columns, Id rows, Visit&& visit)
{
  const Id firstColumn = ClampedIndex(box.LowX, columns);
  const Id lastColumn = ClampedIndex(box.HighX, columns);
  const Id lastRow = ClampedIndex(box.HighY, rows);
  for (Id row = ClampedIndex(box.LowY, rows); row <= lastRow; ++row)
  {
    for (Id column = firstColumn; column <= lastColumn; ++column)
    {
      if (visit(column, row))
      {
        return true;
      }
    }
  }
  return false;
}

} // namespace biting

#endif
