// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingGridBounds_h
#define BitingGridBounds_h

#include "EdgeBound.h"
#include "Spacing.h"

namespace biting
{

/// What the sides and the insides of the cells of a grid without holes, and the least value within
/// cells, allow elsewhere: f grows from there with the gradation.
class GridBounds
{
public:
  /// Values above do not matter; differences of smaller ones do not overflow.
  static constexpr double GreatestValue = 1e300;

  /// `gradation` is positive; each axis has at least two nodes.
  GridBounds(std::shared_ptr<const GridSource> source, double gradation, const ValueRange& range);

  std::size_t NodeAt(std::size_t column, std::size_t row) const
  {
    return column + this->Source->XNodes.size() * row;
  }

  /// What the sides at a node allow at x, or `limit` if that is less. Where values along a side
  /// are as steep as f may be, its lower end bounds, which is not looked at.
  double FromSides(std::size_t column, std::size_t row, const Point2& x, double limit) const;

  /// Of these, the side to the right of the node, and the one above.
  double FromRow(std::size_t column, std::size_t row, const Point2& x, double limit) const;
  double FromColumn(std::size_t column, std::size_t row, const Point2& x, double limit) const;

  /// Whether what is given reaches the least value within the cell above a node.
  bool HasLine(std::size_t column, std::size_t row) const;

  /// What the line allows at x along which it does, or `limit` if that is less or there is none.
  double FromLine(std::size_t column, std::size_t row, const Point2& x, double limit) const;

  /// What is given within the cell above a node allows at x, or `limit` if that is less. Of a cell
  /// where it is about linear only the sides bound, and none is looked at.
  double FromWithin(std::size_t column, std::size_t row, const Point2& x, double limit) const;

private:
  double FromSide(
    double along, double across, double length, double start, double end, double limit) const;
  double FootOn(double along, double across, double length, double start, double end) const;
  Point2 AwayFrom(std::size_t column, std::size_t row, const Point2& x) const;
  bool IsNear(const Point2& away, double room) const;

  const std::shared_ptr<const GridSource> Source;
  const double Gradation;
  const ValueRange Range;
  const EdgeBound Edge;
};

} // namespace biting

#endif
