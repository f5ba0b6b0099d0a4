// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SourceSlopes.h"

#include "../Base/Pulse.h"

#include <algorithm> // for max

namespace biting
{
namespace
{

/// 0 where the slope is not known: a hole, or a step of no length.
double SlopeOf(double from, double to, double step)
{
  const double slope = std::abs(to - from) / step;
  return step > 0.0 && std::isfinite(slope) ? slope : 0.0;
}

/// The slope of the piece of row j (or column i) that starts at node (i, j); 0 past the end.
double SlopeAlongX(const GridSource& source, std::size_t i, std::size_t j)
{
  const std::size_t columns = source.XNodes.size();
  if (i + 1 >= columns || j >= source.YNodes.size())
  {
    return 0.0;
  }
  const std::size_t node = i + j * columns;
  return SlopeOf(
    source.Values[node], source.Values[node + 1], source.XNodes[i + 1] - source.XNodes[i]);
}

double SlopeAlongY(const GridSource& source, std::size_t i, std::size_t j)
{
  const std::size_t columns = source.XNodes.size();
  if (i >= columns || j + 1 >= source.YNodes.size())
  {
    return 0.0;
  }
  const std::size_t node = i + j * columns;
  return SlopeOf(
    source.Values[node], source.Values[node + columns], source.YNodes[j + 1] - source.YNodes[j]);
}

const Point2& PointOf(const TriangulatedSource& source, std::size_t corner)
{
  return source.Points[static_cast<std::size_t>(source.Triangles[corner])];
}

double ValueOf(const TriangulatedSource& source, std::size_t corner)
{
  return source.Values[static_cast<std::size_t>(source.Triangles[corner])];
}

} // namespace

double LargestSlope(const GridSource& source, Monitor& monitor)
{
  Pulse pulse(monitor);
  double largest = 0.0;
  for (std::size_t j = 0; j < source.YNodes.size() && pulse.Beat(4 * source.XNodes.size()); ++j)
  {
    for (std::size_t i = 0; i < source.XNodes.size(); ++i)
    {
      const double alongX = std::max(SlopeAlongX(source, i, j), SlopeAlongX(source, i, j + 1));
      const double alongY = std::max(SlopeAlongY(source, i, j), SlopeAlongY(source, i + 1, j));
      largest = std::max(largest, Length({ alongX, alongY }));
    }
  }
  return largest;
}

double LargestSlope(const TriangulatedSource& source, Monitor& monitor)
{
  Pulse pulse(monitor);
  double largest = 0.0;
  for (std::size_t first = 0; first + 2 < source.Triangles.size() && pulse.Beat(); first += 3)
  {
    largest = std::max(largest, Length(GradientOfTriangle(source, first)));
  }
  return largest;
}

Point2 GradientOfTriangle(const TriangulatedSource& source, std::size_t first)
{
  const Point2 firstSide = PointOf(source, first + 1) - PointOf(source, first);
  const Point2 secondSide = PointOf(source, first + 2) - PointOf(source, first);
  const double firstRise = ValueOf(source, first + 1) - ValueOf(source, first);
  const double secondRise = ValueOf(source, first + 2) - ValueOf(source, first);
  const Point2 gradient = (-1.0 / Cross(firstSide, secondSide)) *
    Perpendicular(firstRise * secondSide - secondRise * firstSide);
  return std::isfinite(gradient.X) && std::isfinite(gradient.Y) ? gradient : Point2{};
}

double AreaOfTriangle(const TriangulatedSource& source, std::size_t first)
{
  const Point2& corner = PointOf(source, first);
  return 0.5 *
    std::abs(Cross(PointOf(source, first + 1) - corner, PointOf(source, first + 2) - corner));
}

double LargestSlope(const SegmentSource& source)
{
  double largest = 0.0;
  for (std::size_t first = 0; first + 1 < source.Segments.size(); first += 2)
  {
    const auto a = static_cast<std::size_t>(source.Segments[first]);
    const auto b = static_cast<std::size_t>(source.Segments[first + 1]);
    largest = std::max(largest,
      SlopeOf(source.Values[a], source.Values[b], Distance(source.Points[a], source.Points[b])));
  }
  return largest;
}

} // namespace biting
