// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingLevelLine_h
#define BitingLevelLine_h

#include "../Base/Box2.h"

#include <array>  // for corners
#include <limits> // for infinity

namespace biting
{

/// The line within a cell of a grid along which what is bilinear there is 0.
class LevelLine
{
public:
  /// `values` are those at the corners, counterclockwise from the low one. `slope` is positive.
  LevelLine(const Box2& cell, const std::array<double, 4>& values, double slope);

  /// `slope` times the distance to about the nearest point of the line, and what is bilinear there,
  /// where that is not 0 but above: so it is never too low. Infinite where there is no line.
  double Bound(const Point2& x) const;

private:
  struct Local
  {
    double Value;
    Point2 Gradient; ///< 0 in a cell without an area
  };

  Point2 CornerAt(std::size_t corner) const;
  double BoundFromPart(const Point2& start, const Point2& end, const Point2& x, int halvings) const;
  Point2 MiddleOf(const Point2& start, const Point2& end) const;
  Point2 AlongAxis(const Point2& place) const;
  Local At(const Point2& place) const;

  Box2 Cell;
  std::array<double, 4> Values;
  double Slope;
};

} // namespace biting

#endif
