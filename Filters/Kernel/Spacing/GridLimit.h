// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingGridLimit_h
#define BitingGridLimit_h

#include "EdgeBound.h"
#include "GridInterpolator.h"
#include "GridSweeps.h"
#include "LevelLine.h"
#include "LookedAt.h"

#include <array>   // for sides
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
  /// What f grows from: a node alone; one of which a side is gentle, that is values along it rise
  /// or fall less than f may; or the line through a cell, above its low node, along which what is
  /// given reaches the least value.
  enum class Kind : std::uint8_t
  {
    Node,
    NodeWithSides,
    LineOfCell
  };

  /// In one word, so that it is handed on as one.
  class Origin
  {
  public:
    Origin(std::size_t column, std::size_t row, Kind kind)
      : Word(
          (static_cast<std::uint64_t>(row) << 2 | static_cast<std::uint64_t>(kind)) << 32 | column)
    {
    }

    std::size_t Column() const { return this->Word & 0xffffffffu; }
    std::size_t Row() const { return this->Word >> 34; }
    bool HasSides() const { return this->Is(Kind::NodeWithSides); }
    bool IsLine() const { return this->Is(Kind::LineOfCell); }
    std::uint64_t Key() const { return this->Word; }
    bool operator==(const Origin& other) const { return this->Word == other.Word; }

  private:
    bool Is(Kind kind) const { return (this->Word >> 32 & 3u) == static_cast<std::uint64_t>(kind); }

    std::uint64_t Word;
  };

  /// From a node to an end of the cells beside it: along x or along y. Of no length at the border.
  struct Side
  {
    std::size_t Column; ///< of its end
    std::size_t Row;
    double Width;
    double Height;
  };

  /// In units of f that suit it, single precision is more than anybody sees.
  struct Node
  {
    float Value; ///< f
    float Start; ///< f at its origin; infinite where nothing is steep nor bounded
    Origin From; ///< itself where f is as given
  };

  std::size_t NodeAt(std::size_t column, std::size_t row) const
  {
    return column + this->Source->XNodes.size() * row;
  }
  Point2 PlaceOf(const Origin& from) const
  {
    return { this->Source->XNodes[from.Column()], this->Source->YNodes[from.Row()] };
  }
  double GivenAt(std::size_t column, std::size_t row) const
  {
    return this->Source->Values[this->NodeAt(column, row)];
  }

  /// As given; it bounds others.
  Node Itself(std::size_t column, std::size_t row) const
  {
    const auto value = static_cast<float>(this->Range(this->GivenAt(column, row)));
    return { value, value,
      { column, row, this->HasGentleSides(column, row) ? Kind::NodeWithSides : Kind::Node } };
  }

  bool FindSteepCells(GridSweeps& sweeps, Pulse& pulse);
  bool IsSteep(std::size_t column, std::size_t row) const;
  bool HasLine(std::size_t column, std::size_t row) const;
  void AddSteepCell(std::size_t column, std::size_t row, GridSweeps& sweeps);
  void AddLine(std::size_t column, std::size_t row);
  void SetGiven();
  std::array<Side, 4> SidesOf(std::size_t column, std::size_t row) const;
  double Rise(double start, const Side& side) const;
  bool IsGentle(double rise, const Side& side) const;
  bool IsFalling(double rise, const Side& side) const;
  bool HasGentleSides(std::size_t column, std::size_t row) const;
  bool HandOn(const Node& other, Node& node, const Point2& place) const;
  void FindLimitedCells(Pulse& pulse);
  double BoundFrom(Node& source, const Point2& x, double limit) const;
  double BoundFromSides(Node& source, const Point2& x, double own) const;
  double BoundFromLine(std::size_t column, std::size_t row, const Point2& x) const;
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
  const EdgeBound Bound;
  std::vector<double> ColumnGrowth; ///< of f across the wider cell beside each column
  std::vector<double> RowGrowth;
  const double SquaredGradation;
  std::vector<Node> Nodes;
  std::vector<bool> IsLimited; ///< whether f may be below what is given in the cell above a node
};

} // namespace biting

#endif
