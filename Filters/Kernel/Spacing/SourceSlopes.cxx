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

/// Of the pieces of row j from node to node; none past the last row.
void FindSlopesAlong(const GridSource& source, std::size_t row, std::vector<double>& slopes)
{
  const std::size_t columns = source.XNodes.size();
  if (row >= source.YNodes.size())
  {
    slopes.assign(columns, 0.0);
    return;
  }
  const double* values = source.Values.data() + row * columns;
  for (std::size_t k = 0; k + 1 < columns; ++k)
  {
    slopes[k] = SlopeOf(values[k], values[k + 1], source.XNodes[k + 1] - source.XNodes[k]);
  }
}

/// From the nodes of a row to those of the next one.
void FindSlopesAcross(const GridSource& source, std::size_t row, std::vector<double>& slopes)
{
  const std::size_t columns = source.XNodes.size();
  const double* values = source.Values.data() + row * columns;
  for (std::size_t k = 0; k < columns && row + 1 < source.YNodes.size(); ++k)
  {
    slopes[k] =
      SlopeOf(values[k], values[k + columns], source.YNodes[row + 1] - source.YNodes[row]);
  }
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
  const std::size_t columns = source.XNodes.size();
  std::vector<double> low(columns, 0.0);
  std::vector<double> high(columns, 0.0);
  std::vector<double> across(columns + 1, 0.0);
  FindSlopesAlong(source, 0, low);
  for (std::size_t row = 0; row < source.YNodes.size() && pulse.Beat(4 * columns); ++row)
  {
    FindSlopesAlong(source, row + 1, high);
    across.assign(columns + 1, 0.0);
    FindSlopesAcross(source, row, across);
    for (std::size_t k = 0; k < columns; ++k)
    {
      const double alongX = std::max(low[k], high[k]);
      const double alongY = std::max(across[k], across[k + 1]);
      largest = std::max(largest, alongX * alongX + alongY * alongY);
    }
    low.swap(high);
  }
  return std::sqrt(largest);
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
