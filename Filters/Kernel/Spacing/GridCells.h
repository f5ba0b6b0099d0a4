// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingGridCells_h
#define BitingGridCells_h

#include "ConeCollector.h"

#include <array> // for corners

namespace biting
{

/// The cells of a grid as the limit of its slope sees them: cell k has node k as its low corner. At
/// the last nodes cells have no width or height. Values are those of f: scaled, clamped, and no
/// larger than Cap, above which nothing can remain; so differences of fill values do not cancel
/// what is beside them.
class GridCells
{
public:
  GridCells(const GridSource& source, double gradation, const ValueRange& range);

  Id Columns() const { return this->ColumnCount; }
  Id Rows() const { return this->RowCount; }
  double Gradation() const { return this->Slope; }
  Id Node(Id column, Id row) const { return column + this->ColumnCount * row; }
  double X(Id column) const { return this->Source.XNodes[static_cast<std::size_t>(column)]; }
  double Y(Id row) const { return this->Source.YNodes[static_cast<std::size_t>(row)]; }
  Point2 Place(Id column, Id row) const { return { this->X(column), this->Y(row) }; }

  double Given(Id node) const
  {
    const double value = this->Range(this->Source.Values[static_cast<std::size_t>(node)]);
    return value < this->Cap ? value : this->Cap;
  }

  /// The column to the right and the row above, or the last ones.
  Id Right(Id column) const { return std::min(column + 1, this->ColumnCount - 1); }
  Id Above(Id row) const { return std::min(row + 1, this->RowCount - 1); }

  /// At the corners (0, 0), (1, 0), (0, 1), (1, 1) of a cell.
  std::array<double, 4> Corners(Id column, Id row) const;

  /// Whether f grows in a cell by more than so many times what the gradation allows, with a margin.
  bool IsSteep(Id column, Id row, double times = 1.0) const;

private:
  const GridSource& Source;
  const double Slope;
  const ValueRange Range;
  const Id ColumnCount;
  const Id RowCount;
  double Cap;
};

} // namespace biting

#endif
