// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingGridBounds_h
#define BitingGridBounds_h

#include "EdgeBound.h"
#include "Spacing.h"

#include <array>   // for sides
#include <cstdint> // for places of nodes

namespace biting
{

/// What the nodes of a grid without holes, the sides of its cells and the least value within them
/// allow elsewhere: f grows from there with the gradation.
class GridBounds
{
public:
  /// Values above do not matter; differences of smaller ones do not overflow.
  static constexpr double GreatestValue = 1e300;

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

  /// In units of f that suit it, single precision is more than anybody sees.
  struct Node
  {
    float Value; ///< f
    float Start; ///< f at its origin; infinite where nothing is steep nor bounded
    Origin From; ///< itself where f is as given
  };

  /// `gradation` is positive; each axis has at least two nodes.
  GridBounds(std::shared_ptr<const GridSource> source, double gradation, const ValueRange& range);

  std::size_t NodeAt(std::size_t column, std::size_t row) const
  {
    return column + this->Source->XNodes.size() * row;
  }

  /// As given; it bounds others.
  Node Itself(std::size_t column, std::size_t row) const
  {
    const auto value = static_cast<float>(this->Range(this->GivenAt(column, row)));
    return { value, value,
      { column, row, this->HasGentleSides(column, row) ? Kind::NodeWithSides : Kind::Node } };
  }

  /// How much f may grow across the wider one of the cells beside a node.
  double GrowthAt(std::size_t column, std::size_t row) const
  {
    return std::max(this->ColumnGrowth[column], this->RowGrowth[row]);
  }

  /// Whether what is given reaches the least value within a cell.
  bool HasLine(std::size_t column, std::size_t row) const;

  /// What the line along which it does allows at x; where that is not below `limit`, which is no
  /// less than the least value, it may be any value that is not.
  double FromLine(std::size_t column, std::size_t row, const Point2& x, double limit) const;

  /// What the origin of `source` and its sides allow at x; where that is not below `limit`, it may
  /// be any value that is not. The source becomes the end of these sides that is nearest to what
  /// bounds x.
  double From(Node& source, const Point2& x, double limit) const;

private:
  /// From a node to an end of the cells beside it: along x or along y. Of no length at the border.
  struct Side
  {
    std::size_t Column; ///< of its end
    std::size_t Row;
    double Width;
    double Height;
  };

  Point2 PlaceOf(const Origin& from) const
  {
    return { this->Source->XNodes[from.Column()], this->Source->YNodes[from.Row()] };
  }
  double GivenAt(std::size_t column, std::size_t row) const
  {
    return this->Source->Values[this->NodeAt(column, row)];
  }
  Point2 ToCell(std::size_t column, std::size_t row, const Point2& x) const;
  double FromSides(Node& source, const Point2& x, double own) const;
  std::array<Side, 4> SidesOf(std::size_t column, std::size_t row) const;
  double Rise(double start, const Side& side) const;
  bool IsGentle(double rise, const Side& side) const;
  bool IsFalling(double rise, const Side& side) const;
  bool HasGentleSides(std::size_t column, std::size_t row) const;

  const std::shared_ptr<const GridSource> Source;
  const double Gradation;
  const double SquaredGradation;
  const ValueRange Range;
  const EdgeBound Edge;
  std::vector<double> ColumnGrowth; ///< of f across the wider cell beside each column
  std::vector<double> RowGrowth;
};

} // namespace biting

#endif
