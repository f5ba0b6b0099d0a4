// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "CutFrame.h"

#include "../Base/Ids.h"

#include <algorithm> // for partial_sort_copy, min, max
#include <cmath>     // for abs
#include <vector>    // for segments

namespace biting
{

namespace
{

constexpr std::size_t MostDirections = 16;
constexpr double ParallelWithin = 1e-3;  // sine of an angle: half a row over five hundred
constexpr double FarMore = 3.0;          // along one axis than along the other
constexpr double LeastAlongAxes = 0.3;   // of the boundary
constexpr double OverCoordinates = 1.25; // so much more than along the axes of the coordinates

// Segments of the boundary as vectors.
std::vector<Point2> WaysOf(const Domain& domain)
{
  std::vector<Point2> ways;
  for (Id segment = 0; segment < domain.NumberOfSegments(); ++segment)
  {
    if (domain.IsBoundary[segment] != 0)
    {
      ways.push_back(
        domain.Vertices[domain.Ends[segment]] - domain.Vertices[domain.Starts[segment]]);
    }
  }
  return ways;
}

// How much runs along the axis.
double LengthAlong(const std::vector<Point2>& ways, const Point2& axis)
{
  double sum = 0.0;
  for (const Point2& way : ways)
  {
    const double length = Length(way);
    sum += std::abs(Cross(axis, way)) <= ParallelWithin * length ? length : 0.0;
  }
  return sum;
}

double LengthAlongBoth(const std::vector<Point2>& ways, const Point2& axis)
{
  return LengthAlong(ways, axis) + LengthAlong(ways, Perpendicular(axis));
}

// Turned by right angles, within 45 degrees of the first axis.
Point2 AxisAlong(const Point2& way)
{
  Point2 axis = (1.0 / Length(way)) * way;
  while (axis.X < std::abs(axis.Y))
  {
    axis = Perpendicular(axis);
  }
  return axis;
}

} // namespace

CutFrame FrameOf(const Domain& domain)
{
  const std::vector<Point2> ways = WaysOf(domain);
  double all = 0.0;
  for (const Point2& way : ways)
  {
    all += Length(way);
  }
  CutFrame frame;
  double most = std::max(LeastAlongAxes * all, OverCoordinates * LengthAlongBoth(ways, frame.Axis));
  std::vector<Point2> longest(std::min(MostDirections, ways.size()));
  std::partial_sort_copy(ways.begin(), ways.end(), longest.begin(), longest.end(),
    [](const Point2& a, const Point2& b)
    {
      const double first = Dot(a, a);
      const double second = Dot(b, b);
      return first != second ? first > second : a < b;
    });
  for (const Point2& way : longest)
  {
    const Point2 axis = AxisAlong(way);
    const double along = LengthAlongBoth(ways, axis);
    if (along > most)
    {
      frame.Axis = axis;
      most = along;
    }
  }
  const double along = LengthAlong(ways, frame.Axis);
  const double across = LengthAlong(ways, Perpendicular(frame.Axis));
  if (std::max(along, across) > std::max(LeastAlongAxes * all, FarMore * std::min(along, across)))
  {
    frame.IsMostlyVertical = across > along;
  }
  return frame;
}

Box2 BoundsIn(const CutFrame& frame, const Domain& domain)
{
  Box2 bounds;
  for (const Point2& vertex : domain.Vertices)
  {
    bounds.Add(frame.To(vertex));
  }
  return bounds;
}

} // namespace biting
