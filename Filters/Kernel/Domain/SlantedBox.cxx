// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SlantedBox.h"

#include <algorithm> // for min, max

namespace biting
{

void SlantedBox::SlantAround(const SlantedBox& first, const SlantedBox& second)
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

} // namespace biting
