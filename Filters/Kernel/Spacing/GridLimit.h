// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingGridLimit_h
#define BitingGridLimit_h

#include "EdgeBound.h"
#include "GridInterpolator.h"
#include "GridSweeps.h"
#include "LookedAt.h"

#include <cstdint> // for places of nodes

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
  /// A node that f grows from, with whether sides are gentle around it; in one word, so that it is
  /// handed on as one.
  class Origin
  {
  public:
    Origin(std::size_t column, std::size_t row, bool hasSides)
      : Word(static_cast<std::uint64_t>(row) << 33 |
          static_cast<std::uint64_t>(hasSides ? 1u : 0u) << 32 | column)
    {
    }

    std::size_t Column() const { return this->Word & 0xffffffffu; }
    std::size_t Row() const { return this->Word >> 33; }
    bool HasSides() const { return (this->Word >> 32 & 1u) != 0; }
    bool operator==(const Origin& other) const { return this->Word == other.Word; }

  private:
    std::uint64_t Word;
  };

  /// Single precision is more than anybody sees.
  struct Node
  {
    float Value; ///< f
    float Start; ///< f at its origin; infinite where nothing is steep nor bounded
    Origin From; ///< itself where f is as given
  };

  enum class Cell : std::uint8_t
  {
    AsGiven,
    Small, ///< corners are bounded
    Wide   ///< the same, or it is beside a steep one, and f may grow by more than a share of itself
  };

  enum class Sides
  {
    IfNear, ///< where they make a difference
    Always
  };

  /// Bits of GentleSides.
  static constexpr unsigned ToLeft = 1;
  static constexpr unsigned ToRight = 2;
  static constexpr unsigned Down = 4;
  static constexpr unsigned Up = 8;

  std::size_t NodeAt(std::size_t column, std::size_t row) const
  {
    return column + this->Source->XNodes.size() * row;
  }
  Point2 PlaceOf(const Origin& from) const
  {
    return { this->Source->XNodes[from.Column()], this->Source->YNodes[from.Row()] };
  }
  Node AsGiven(std::size_t column, std::size_t row) const
  {
    const std::size_t node = this->NodeAt(column, row);
    return { static_cast<float>(this->Range(this->Source->Values[node])),
      std::numeric_limits<float>::infinity(), { column, row, this->GentleSides[node] != 0 } };
  }

  bool IsLeast(double value) const { return !(this->Range.Scale * value > this->Range.Least); }

  Node Itself(std::size_t column, std::size_t row) const
  {
    Node node = this->AsGiven(column, row);
    node.Start = node.Value;
    return node;
  }

  bool FindSteepCells(GridSweeps& sweeps, Pulse& pulse);
  bool IsSteep(std::size_t column, std::size_t row) const;
  void AddSteepCell(std::size_t column, std::size_t row, GridSweeps& sweeps);
  void SetGiven();
  void FindGentleSides(
    std::size_t node, std::size_t other, double length, unsigned toOther, unsigned back);
  bool HandOn(const Node& other, Node& node, const Point2& place) const;
  void ClassifyCells(const GridSweeps& sweeps, Pulse& pulse);
  void ForgetSlight(std::size_t column, std::size_t row);
  Cell KindOf(std::size_t column, std::size_t row) const;
  double BoundFrom(Node& source, const Point2& x, double limit, Sides sides) const;
  double BoundFromSides(Node& source, const Point2& x, double own) const;
  double ValueInWideCell(const Point2& x, const GridInterpolator::Place& place, double given) const;
  double LowerFromRow(const Point2& x, std::size_t row, std::size_t first, std::size_t last,
    LookedAt<std::size_t>& looked, double least) const;

  const std::shared_ptr<const GridSource> Source; ///< with nodes out to the bounds
  const GridInterpolator Given;
  const double Gradation;
  const ValueRange Range;
  const EdgeBound Bound;
  std::vector<double> ColumnGrowth; ///< of f across the wider cell beside each column
  std::vector<double> RowGrowth;
  const double SquaredGradation;
  std::vector<Node> Nodes;
  std::vector<std::uint8_t> GentleSides; ///< of each node: where values grow less than f may
  std::vector<Cell> Cells;               ///< cell k has node k as its low corner
};

} // namespace biting

#endif
