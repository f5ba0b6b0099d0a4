// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingGridLimit_h
#define BitingGridLimit_h

#include "GridBounds.h"
#include "GridInterpolator.h"
#include "GridSweeps.h"
#include "LookedAt.h"

namespace biting
{

/// What f is on a grid that is steeper than the gradation: the largest Lipschitz function below its
/// interpolant, within the tolerances of Spacing. Outside of the grid the nearest border value is
/// what is given, as far as bounds reach.
///
/// Method: f grows from the sides of cells, along which values are linear. Nodes hand on to their
/// neighbors, in two sweeps, the node whose sides bound them, so that distances are those of the
/// plane and not of paths along the grid. Where f may
/// grow by more than a share of itself across a cell, it is what bounds the corners that bounds its
/// points, too; elsewhere the interpolant of bounded corners is as good.
/// Linear in the number of nodes; constant cost for an evaluation.
class GridLimit
{
public:
  /// The grid has no holes. Without meaning if the monitor asks to stop.
  GridLimit(const std::shared_ptr<const GridSource>& source, double gradation, const Box2& bounds,
    const ValueRange& range, Monitor& monitor);

  /// Whether anything is steep. Where not, there is nothing to be asked for.
  bool IsNeeded() const { return !this->Nodes.empty(); }

  /// f, scaled and clamped.
  double operator()(const Point2& x) const;

private:
  using Kind = GridBounds::Kind;
  using Origin = GridBounds::Origin;
  using Node = GridBounds::Node;

  std::size_t NodeAt(std::size_t column, std::size_t row) const
  {
    return this->Bounds.NodeAt(column, row);
  }

  bool FindSteepCells(GridSweeps& sweeps, Pulse& pulse);
  bool IsSteep(std::size_t column, std::size_t row) const;
  void AddSteepCell(std::size_t column, std::size_t row, GridSweeps& sweeps);
  void AddLine(std::size_t column, std::size_t row);
  void SetGiven();
  bool HandOn(std::size_t from, Node& node, const Point2& place) const;
  bool IsFarFromLine(const Node& node, const Origin& itself) const;
  void FindLimitedCells(Pulse& pulse);
  void BoundByLines(
    const Origin& from, const Point2& x, LookedAt<std::uint64_t>& looked, double& least) const;
  void BoundByLine(std::size_t column, std::size_t row, const Point2& x,
    LookedAt<std::uint64_t>& looked, double& least) const;
  double ValueInWideCell(const Point2& x, const GridInterpolator::Place& place, double given) const;

  const std::shared_ptr<const GridSource> Source; ///< with nodes out to the bounds
  const GridInterpolator Given;
  const double Unit;      ///< of f: a power of two
  const double Gradation; ///< from here on f is in that unit
  const ValueRange Range;
  const GridBounds Bounds;
  std::vector<Node> Nodes;
  std::vector<bool> IsLimited; ///< whether f may be below what is given in the cell above a node
};

} // namespace biting

#endif
