// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "CutFrame.h"

#include "../Base/Tasks.h"

#include <algorithm> // for partial_sort_copy, min, max
#include <cmath>     // for abs
#include <cstddef>   // for counts
#include <vector>    // for segments

namespace biting
{

namespace
{

constexpr std::size_t MostDirections = 16;
constexpr double ParallelWithin = 1e-3;  // sine of an angle: half a row over five hundred
constexpr double FarMore = 3.0;          // along one axis than along the other
constexpr double LeastAlongAxes = 0.3;   // of the boundary
constexpr double LeastOfWidth = 0.25;    // of the domain's box, for a side
constexpr double OverCoordinates = 1.25; // so much more than along the axes of the coordinates

// Segments of the boundary as vectors.
std::vector<Point2> WaysOf(const Domain& domain, Pulse& pulse)
{
  std::vector<Point2> ways;
  pulse.ForEach(static_cast<std::size_t>(domain.NumberOfSegments()),
    [&domain, &ways](std::size_t segment)
    {
      if (domain.IsBoundary[segment] != 0)
      {
        ways.push_back(
          domain.Vertices[domain.Ends[segment]] - domain.Vertices[domain.Starts[segment]]);
      }
    });
  return ways;
}

// How much runs along an axis, and along the one across.
struct LengthsAlong
{
  double Axis = 0.0;
  double Across = 0.0;

  void Add(const Point2& axis, const Point2& way)
  {
    const double length = Length(way);
    this->Axis += std::abs(Cross(axis, way)) <= ParallelWithin * length ? length : 0.0;
    this->Across += std::abs(Dot(axis, way)) <= ParallelWithin * length ? length : 0.0;
  }

  double Both() const { return this->Axis + this->Across; }
};

// Of several axes at once.
struct LengthsAlongAxes
{
  double All = 0.0;
  std::vector<LengthsAlong> Along;

  void Join(const LengthsAlongAxes& other)
  {
    this->All += other.All;
    for (std::size_t axis = 0; axis < this->Along.size(); ++axis)
    {
      this->Along[axis].Axis += other.Along[axis].Axis;
      this->Along[axis].Across += other.Along[axis].Across;
    }
  }
};

LengthsAlongAxes LengthsOf(
  const std::vector<Point2>& ways, const std::vector<Point2>& axes, Pulse& pulse)
{
  LengthsAlongAxes none;
  none.Along.resize(axes.size());
  return SumAtOnce(pulse, ways.size(), none,
    [&ways, &axes](LengthsAlongAxes& sum, std::size_t k)
    {
      sum.All += Length(ways[k]);
      for (std::size_t axis = 0; axis < axes.size(); ++axis)
      {
        sum.Along[axis].Add(axes[axis], ways[k]);
      }
    });
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

// The axes of the coordinates come first, then those of the longest segments.
std::vector<Point2> AxesAlong(const std::vector<Point2>& ways)
{
  std::vector<Point2> longest(std::min(MostDirections, ways.size()));
  std::partial_sort_copy(ways.begin(), ways.end(), longest.begin(), longest.end(),
    [](const Point2& a, const Point2& b)
    {
      const double first = Dot(a, a);
      const double second = Dot(b, b);
      return first != second ? first > second : a < b;
    });
  std::vector<Point2> axes{ CutFrame().Axis };
  for (const Point2& way : longest)
  {
    axes.push_back(AxisAlong(way));
  }
  return axes;
}

} // namespace

CutFrame FrameOf(const Domain& domain, Pulse& pulse)
{
  const std::vector<Point2> ways = WaysOf(domain, pulse);
  const std::vector<Point2> axes = AxesAlong(ways);
  const LengthsAlongAxes lengths = LengthsOf(ways, axes, pulse);
  const double least = LeastAlongAxes * lengths.All;
  std::size_t best = 0;
  double most = std::max(least, OverCoordinates * lengths.Along[0].Both());
  for (std::size_t axis = 1; axis < axes.size(); ++axis)
  {
    if (lengths.Along[axis].Both() > most)
    {
      best = axis;
      most = lengths.Along[axis].Both();
    }
  }
  CutFrame frame;
  frame.Axis = axes[best];
  const auto [along, across] = lengths.Along[best];
  if (std::max(along, across) > std::max(least, FarMore * std::min(along, across)))
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

Box2 LongestSidesIn(const CutFrame& frame, const Domain& domain, Pulse& pulse)
{
  Box2 sides = BoundsIn(frame, domain);
  double level = LeastOfWidth * sides.Width();
  double upright = LeastOfWidth * sides.Height();
  pulse.ForEach(static_cast<std::size_t>(domain.NumberOfSegments()),
    [&frame, &domain, &sides, &level, &upright](std::size_t segment)
    {
      const Point2 start = frame.To(domain.Vertices[domain.Starts[segment]]);
      const Point2 end = frame.To(domain.Vertices[domain.Ends[segment]]);
      const double width = std::abs(end.X - start.X);
      const double height = std::abs(end.Y - start.Y);
      if (domain.IsBoundary[segment] != 0 && width > level && height <= ParallelWithin * width)
      {
        level = width;
        sides.Low.X = std::min(start.X, end.X);
        sides.High.X = std::max(start.X, end.X);
      }
      if (domain.IsBoundary[segment] != 0 && height > upright && width <= ParallelWithin * height)
      {
        upright = height;
        sides.Low.Y = std::min(start.Y, end.Y);
        sides.High.Y = std::max(start.Y, end.Y);
      }
    });
  return sides;
}

} // namespace biting
