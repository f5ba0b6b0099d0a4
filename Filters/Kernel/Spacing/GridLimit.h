// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingGridLimit_h
#define BitingGridLimit_h

#include "../Base/Pulse.h"
#include "EdgeBound.h"
#include "GridInterpolator.h"
#include "LookedAt.h"

#include <cstdint> // for ids of nodes

namespace biting
{

/// What f is on a grid that is steeper than the gradation: the largest Lipschitz function below its
/// interpolant, within the tolerances of Spacing. Outside of the grid the nearest border value is
/// what is given, as far as bounds reach.
///
/// Method: f grows from the sides of cells, along which values are linear. Nodes hand on to their
/// neighbors, in two sweeps, the node whose sides bound them (vector propagation, after Danielsson
/// 1980), so that distances are those of the plane and not of paths along the grid. Where f may
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
  using NodeId = std::uint32_t;

  /// What bounds f at a node: the sides around another one, or its own value. Single precision is
  /// more than anybody sees.
  struct Node
  {
    float Value;
    NodeId Source;
  };

  enum class Cell : std::uint8_t
  {
    AsGiven,
    Small, ///< corners are bounded
    Wide,  ///< the same, or it is steep, and f may grow by more than a share of itself
    Steep  ///< while it is not known whether it is wide
  };

  NodeId NodeAt(std::size_t column, std::size_t row) const
  {
    return static_cast<NodeId>(column + this->Grid.Columns() * row);
  }
  Point2 PlaceOf(std::size_t column, std::size_t row) const
  {
    return { this->Grid.X(column), this->Grid.Y(row) };
  }
  double Given(std::size_t column, std::size_t row) const
  {
    return this->Range(this->Grid.Value(column, row));
  }

  bool IsSteepCell(std::size_t column, std::size_t row) const
  {
    return this->Cells[this->NodeAt(column, row)] == Cell::Steep;
  }

  bool FindSteepCells(Pulse& pulse);
  bool IsSteep(std::size_t column, std::size_t row) const;
  void SetGiven(Pulse& pulse);
  void Sweep(Pulse& pulse);
  void SweepRow(std::size_t row, std::size_t from);
  void HandOn(NodeId from, NodeId to, const Point2& place, double away, bool isSteep);
  void ClassifyCells(Pulse& pulse);
  void ForgetSlight(std::size_t column, std::size_t row);
  Cell KindOf(std::size_t column, std::size_t row, const std::vector<bool>& isOfSteep) const;
  double BoundFrom(NodeId source, const Point2& x) const;
  double ValueInWideCell(const Point2& x, const GridInterpolator::Place& place, double given) const;
  double LowerFromRow(const Point2& x, std::size_t row, std::size_t first, std::size_t last,
    LookedAt<NodeId>& looked, double least) const;

  GridInterpolator Grid;
  const double Gradation;
  const ValueRange Range;
  const EdgeBound Bound;
  std::vector<Node> Nodes;
  std::vector<Cell> Cells; ///< cell k has node k as its low corner
};

} // namespace biting

#endif
