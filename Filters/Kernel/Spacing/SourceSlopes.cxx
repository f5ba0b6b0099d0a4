// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SourceSlopes.h"

#include "../Base/Tasks.h"

#include <algorithm> // for max
#include <limits>    // for what is finite

namespace biting
{
namespace
{

/// 0 where there is none.
double Inverse(double step)
{
  return step > 0.0 ? 1.0 / step : 0.0;
}

/// For each cell. A single node is a cell of no width.
std::vector<double> InverseSteps(const std::vector<double>& nodes)
{
  std::vector<double> inverse;
  for (std::size_t node = 1; node < nodes.size(); ++node)
  {
    inverse.push_back(Inverse(nodes[node] - nodes[node - 1]));
  }
  inverse.resize(std::max<std::size_t>(inverse.size(), 1), 0.0);
  return inverse;
}

/// 0 where the slope is not known: a hole, or a step of no length.
double KnownSlope(double rise, double inverseStep)
{
  const double slope = std::abs(rise) * inverseStep;
  return slope <= std::numeric_limits<double>::max() ? slope : 0.0;
}

struct Largest
{
  double Value = 0.0;

  void Join(const Largest& other) { this->Value = std::max(this->Value, other.Value); }
};

} // namespace

double LargestSlope(const GridSource& source, Monitor& monitor)
{
  Pulse pulse(monitor);
  const std::vector<double> inverseWidths = InverseSteps(source.XNodes);
  const std::vector<double> inverseHeights = InverseSteps(source.YNodes);
  const std::size_t toRight = source.XNodes.size() > 1 ? 1 : 0;
  const std::size_t toNextRow = source.YNodes.size() > 1 ? source.XNodes.size() : 0;
  std::vector<double> largest(inverseHeights.size(), 0.0); // of some rows each
  const auto measure = [&](std::size_t firstRow, std::size_t lastRow)
  {
    std::vector<double> squares(inverseWidths.size(), 0.0);
    for (std::size_t row = firstRow; row < lastRow; ++row)
    {
      const double* low = &source.Values[row * source.XNodes.size()];
      const double* high = low + toNextRow;
      for (std::size_t k = 0; k < squares.size(); ++k)
      {
        const double alongX = std::max(KnownSlope(low[k + toRight] - low[k], inverseWidths[k]),
          KnownSlope(high[k + toRight] - high[k], inverseWidths[k]));
        const double alongY = std::max(KnownSlope(high[k] - low[k], inverseHeights[row]),
          KnownSlope(high[k + toRight] - low[k + toRight], inverseHeights[row]));
        squares[k] = std::max(squares[k], alongX * alongX + alongY * alongY);
      }
    }
    largest[firstRow] = *std::max_element(squares.begin(), squares.end());
  };
  ForRowsAtOnce(pulse, largest.size(), source.XNodes.size(), measure);
  return std::sqrt(*std::max_element(largest.begin(), largest.end()));
}

double LargestSlope(const TriangulatedSource& source, Monitor& monitor)
{
  Pulse pulse(monitor);
  return SumAtOnce(pulse, source.Triangles.size() / 3, Largest{},
    [&source](Largest& largest, std::size_t triangle)
    { largest.Join({ Length(GradientOfTriangle(source, &source.Triangles[3 * triangle])) }); })
    .Value;
}

Point2 GradientOfTriangle(const TriangulatedSource& source, const Id* corners)
{
  const auto id = [corners](std::size_t k) { return static_cast<std::size_t>(corners[k]); };
  const Point2 firstSide = source.Points[id(1)] - source.Points[id(0)];
  const Point2 secondSide = source.Points[id(2)] - source.Points[id(0)];
  const double firstRise = source.Values[id(1)] - source.Values[id(0)];
  const double secondRise = source.Values[id(2)] - source.Values[id(0)];
  const Point2 gradient = (-1.0 / Cross(firstSide, secondSide)) *
    Perpendicular(firstRise * secondSide - secondRise * firstSide);
  return std::isfinite(gradient.X) && std::isfinite(gradient.Y) ? gradient : Point2{};
}

double LargestSlope(const SegmentSource& source)
{
  double largest = 0.0;
  for (std::size_t first = 0; first + 1 < source.Segments.size(); first += 2)
  {
    const auto a = static_cast<std::size_t>(source.Segments[first]);
    const auto b = static_cast<std::size_t>(source.Segments[first + 1]);
    largest = std::max(largest,
      KnownSlope(source.Values[b] - source.Values[a],
        Inverse(Distance(source.Points[a], source.Points[b]))));
  }
  return largest;
}

} // namespace biting
