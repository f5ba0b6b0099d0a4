// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "GridCells.h"

#include <cmath>  // for abs
#include <limits> // for infinity

namespace biting
{
namespace
{

/// A cell is steep where its mean gradient or one of its sides is above the gradation by more than
/// this share of it, or where its twist adds more than this share of f to what is linear. Otherwise
/// a field that somebody has limited already would be limited again, cell by cell: the gradient at
/// a corner of a cell of a distance function exceeds that of the function itself.
constexpr double SteepnessMargin = 0.005;

/// Least value and what grows from there over twice the diagonal: so a cell that leads above it is
/// still steep where its values are cut off.
double CapOf(const GridSource& source, double gradation, const ValueRange& range)
{
  double least = std::numeric_limits<double>::infinity();
  for (double value : source.Values)
  {
    least = value < least ? value : least;
  }
  const Point2 extent{ source.XNodes.back() - source.XNodes.front(),
    source.YNodes.back() - source.YNodes.front() };
  return std::min(range.Most, range(least) + 2.0 * gradation * Length(extent));
}

} // namespace

GridCells::GridCells(const GridSource& source, double gradation, const ValueRange& range)
  : Source(source)
  , Slope(gradation)
  , Range(range)
  , ColumnCount(static_cast<Id>(source.XNodes.size()))
  , RowCount(static_cast<Id>(source.YNodes.size()))
  , Cap(CapOf(source, gradation, range))
{
}

std::array<double, 4> GridCells::Corners(Id column, Id row) const
{
  const Id right = this->Right(column);
  const Id above = this->Above(row);
  return { this->Given(this->Node(column, row)), this->Given(this->Node(right, row)),
    this->Given(this->Node(column, above)), this->Given(this->Node(right, above)) };
}

bool GridCells::IsSteep(Id column, Id row, double times) const
{
  const auto [a, b, c, d] = this->Corners(column, row);
  const double width = this->X(this->Right(column)) - this->X(column);
  const double height = this->Y(this->Above(row)) - this->Y(row);
  const double most = (1.0 + SteepnessMargin) * times * this->Slope;
  if (!(width > 0.0 && height > 0.0))
  {
    return std::max({ a, b, c, d }) - std::min({ a, b, c, d }) > most * std::max(width, height);
  }
  const double both = most * width * height;
  const auto isAbove = [both, width, height](double alongX, double alongY)
  {
    const Point2 slope{ alongX * height, alongY * width };
    return Dot(slope, slope) > both * both;
  };
  const double alongX = std::max(std::abs(b - a), std::abs(d - c));
  const double alongY = std::max(std::abs(c - a), std::abs(d - b));
  if (!isAbove(alongX, alongY))
  {
    return false;
  }
  const double added = 0.25 * std::abs(a - b - c + d);
  return isAbove(0.5 * (b - a + d - c), 0.5 * (c - a + d - b)) || isAbove(alongX, 0.0) ||
    isAbove(0.0, alongY) || added > SteepnessMargin * std::min({ a, b, c, d });
}

} // namespace biting
