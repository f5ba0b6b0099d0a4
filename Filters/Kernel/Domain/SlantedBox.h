// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSlantedBox_h
#define BitingSlantedBox_h

#include "../Base/Box.h"
#include "../Base/Point.h"

#include <algorithm> // for min, max
#include <cmath>     // for abs

namespace biting
{

/// A box along the axes, and a slanted one around the same.
struct SlantedBox
{
  Box2 Bounds;
  Point2 Center;           ///< of the slanted box
  Point2 Axis{ 1.0, 0.0 }; ///< of length one
  double Along = 0.0;      ///< half of the extent along the axis
  double Across = 0.0;     ///< half of the extent across it

  SlantedBox() = default;

  /// As the box; a conversion.
  SlantedBox(const Box2& bounds)
    : Bounds(bounds)
    , Center(bounds.Center())
    , Along(0.5 * bounds.Width())
    , Across(0.5 * bounds.Height())
  {
  }

  /// Around a segment.
  SlantedBox(const Point2& start, const Point2& end)
    : Bounds(Box2::Around(start, end))
    , Center(Midpoint(start, end))
    , Along(0.5 * Distance(start, end))
  {
    this->Axis = this->Along > 0.0 ? (0.5 / this->Along) * (end - start) : this->Axis;
  }

  double Size() const { return this->Bounds.Width() + this->Bounds.Height(); }

  /// Half of the extent of the slanted box in a direction of length one.
  double ReachIn(const Point2& direction) const
  {
    return this->Along * std::abs(Dot(direction, this->Axis)) +
      this->Across * std::abs(Cross(direction, this->Axis));
  }

  /// Whether the other slanted box lies on one side of this one, seen along its axis, by more than
  /// `slack`.
  bool IsBeside(const SlantedBox& other, double slack) const
  {
    const Point2 normal = Perpendicular(this->Axis);
    const double distance = std::abs(Dot(normal, other.Center - this->Center));
    return distance > this->Across + other.ReachIn(normal) + slack;
  }

  /// Makes the slanted box the smallest around those of both, along the axis of the longer one; the
  /// box along the axes is left as it is.
  void SlantAround(const SlantedBox& first, const SlantedBox& second)
  {
    const Point2 axis = first.Along >= second.Along ? first.Axis : second.Axis;
    const Point2 normal = Perpendicular(axis);
    const Point2 gap = second.Center - first.Center;
    const auto span = [&first, &second, &gap](const Point2& direction)
    {
      const double place = Dot(direction, gap);
      const double reach = first.ReachIn(direction);
      const double other = second.ReachIn(direction);
      const double low = std::min(-reach, place - other);
      const double high = std::max(reach, place + other);
      return Point2{ 0.5 * (low + high), 0.5 * (high - low) };
    };
    const Point2 along = span(axis);
    const Point2 across = span(normal);
    this->Center = first.Center + along.X * axis + across.X * normal;
    this->Axis = axis;
    this->Along = along.Y;
    this->Across = across.Y;
  }
};

} // namespace biting

#endif
