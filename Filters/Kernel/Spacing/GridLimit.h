// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingGridLimit_h
#define BitingGridLimit_h

#include "../Base/Pulse.h"
#include "GridBounds.h"
#include "GridInterpolator.h"
#include "LongCells.h"

#include <optional> // for long cells

namespace biting
{

/// What f is on a grid that is steeper than the gradation: the largest Lipschitz function below its
/// interpolant, within the tolerances of Spacing. Outside of the grid the nearest border value is
/// what is given, as far as bounds reach.
///
/// Method: nodes are bounded by passes over lines of them. Where f may grow by no more than a share
/// of itself across a cell, the interpolant of bounded nodes is as good as f; elsewhere it is what
/// the nodes, the sides and the lines around allow at a point.
/// In and beside long cells those are all nodes along lines of them and the sides between
/// (LongCells), and from where sides exceed the least value f grows to nodes first (Plateaus).
/// Linear in the number of nodes, but for a logarithm where cells are long; constant cost for an
/// evaluation, but in long cells about the logarithm of their number.
class GridLimit
{
public:
  /// The grid has no holes. Without meaning if the monitor asks to stop.
  GridLimit(const std::shared_ptr<const GridSource>& source, double gradation, const Box2& bounds,
    const ValueRange& range, Monitor& monitor);

  /// Whether anything is steep. Where not, there is nothing to be asked for.
  bool IsNeeded() const { return !this->Values.empty(); }

  /// f, scaled and clamped.
  double operator()(const Point2& x) const;

  /// Columns or rows.
  struct Nearby
  {
    std::size_t First;
    std::size_t Last;
    bool AreCut; ///< whether there are more within reach
  };

private:
  /// Cells and nodes, by number: not bits, as threads write them.
  using Marks = std::vector<char>;

  Marks FindSteepCells(Pulse& pulse) const;
  bool IsSteep(std::size_t column, std::size_t row) const;
  Marks SetValues(const Marks& steep, Pulse& pulse);
  void LowerToLines(const Marks& steep, std::size_t node);
  float GivenAt(std::size_t node) const;
  void FindLimitedCells(Marks& changed, Pulse& pulse);
  double FromCellsAround(const GridInterpolator::Place& place, const Point2& x, double limit) const;
  double FromNearby(
    const Nearby& columns, const Nearby& rows, const Point2& x, double growth, double limit) const;

  const std::shared_ptr<const GridSource> Source; ///< with nodes out to the bounds
  const GridInterpolator Given;
  const double Least;     ///< of the values of the source
  const double Unit;      ///< of f: a power of two
  const double Gradation; ///< from here on f is in that unit
  const ValueRange Range;
  const GridBounds Bounds;
  const bool HasLines;       ///< whether the least value may be reached within cells
  std::vector<float> Values; ///< f at nodes; single precision is more than anybody sees
  std::optional<LongCells> Long;
  std::vector<bool> IsLimited; ///< whether f may be below what is given in the cell above a node
};

} // namespace biting

#endif
