// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SourceSlopes.h"

#include "../Base/Pulse.h"

#include <algorithm> // for max
#include <limits>    // for what is finite

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

/// 1 / step; 0 where there is none.
std::vector<double> InverseSteps(const std::vector<double>& nodes)
{
  std::vector<double> inverse;
  for (std::size_t node = 1; node < nodes.size(); ++node)
  {
    const double step = nodes[node] - nodes[node - 1];
    inverse.push_back(step > 0.0 ? 1.0 / step : 0.0);
  }
  return inverse;
}

/// 0 where the slope is not known.
double KnownSlope(double rise, double inverseStep)
{
  const double slope = std::abs(rise) * inverseStep;
  return slope <= std::numeric_limits<double>::max() ? slope : 0.0;
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

GridSlopes::GridSlopes(const GridSource& source)
  : Source(source)
  , Columns(InverseSteps(source.XNodes))
  , Rows(InverseSteps(source.YNodes))
  , Low(source.XNodes.size() + 1, 0.0)
  , High(source.XNodes.size() + 1, 0.0)
  , Across(source.XNodes.size() + 1, 0.0)
  , Squares(source.XNodes.size(), 0.0)
{
  this->FindAlong(0, this->High);
}

const std::vector<double>& GridSlopes::SquaresOfRow(std::size_t row)
{
  this->Low.swap(this->High);
  this->FindAlong(row + 1, this->High);
  this->FindAcross(row);
  for (std::size_t k = 0; k < this->Squares.size(); ++k)
  {
    const double alongX = this->Low[k] < this->High[k] ? this->High[k] : this->Low[k];
    const double alongY =
      this->Across[k] < this->Across[k + 1] ? this->Across[k + 1] : this->Across[k];
    this->Squares[k] = alongX * alongX + alongY * alongY;
  }
  return this->Squares;
}

void GridSlopes::FindAlong(std::size_t row, std::vector<double>& slopes) const
{
  if (row > this->Rows.size())
  {
    slopes.assign(slopes.size(), 0.0);
    return;
  }
  const double* values = &this->Source.Values[row * this->Source.XNodes.size()];
  for (std::size_t k = 0; k < this->Columns.size(); ++k)
  {
    slopes[k] = KnownSlope(values[k + 1] - values[k], this->Columns[k]);
  }
}

void GridSlopes::FindAcross(std::size_t row)
{
  if (row == this->Rows.size())
  {
    this->Across.assign(this->Across.size(), 0.0);
    return;
  }
  const std::size_t columns = this->Source.XNodes.size();
  const double* values = &this->Source.Values[row * columns];
  for (std::size_t k = 0; k < columns; ++k)
  {
    this->Across[k] = KnownSlope(values[k + columns] - values[k], this->Rows[row]);
  }
}

double LargestSlope(const GridSource& source, Monitor& monitor)
{
  Pulse pulse(monitor);
  GridSlopes slopes(source);
  std::vector<double> largest(source.XNodes.size(), 0.0);
  for (std::size_t row = 0; row < source.YNodes.size() && pulse.Beat(2 * largest.size()); ++row)
  {
    const std::vector<double>& squares = slopes.SquaresOfRow(row);
    for (std::size_t k = 0; k < largest.size(); ++k)
    {
      largest[k] = largest[k] < squares[k] ? squares[k] : largest[k];
    }
  }
  return std::sqrt(*std::max_element(largest.begin(), largest.end()));
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
