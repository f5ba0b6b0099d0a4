// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "ReachFactor.h"

#include <algorithm> // for min, clamp
#include <cmath>     // for sqrt, abs

namespace biting
{

namespace
{

constexpr double FaultsOfSquares = 0.29; // per slope
constexpr double FaultsOfCircles = 0.2;  // per root of the slope
constexpr double FaultsOfBestCircles = 0.25;
constexpr double GreatestSlope = 1.0; // faults do not grow beyond
// Of circles: half of f's growth to the next bite, which is .8 of the way ahead, as some come
// sideways.
constexpr double ShareOfGrowth = 0.4;
constexpr double GreatestGrowth = 0.5;
constexpr double LeastHeight =
  0.1; // of the bond: in a flatter triangle the slope across is unknown

// By what share lengths are greater.
double Faults(BiteShape shape, FrontOrder order, double slope)
{
  if (shape == BiteShape::Square)
  {
    return FaultsOfSquares * slope;
  }
  return (order == FrontOrder::BestFirst ? FaultsOfBestCircles : FaultsOfCircles) *
    std::sqrt(slope);
}

} // namespace

double LeastReachFactor(double slope)
{
  return (1.0 - ShareOfGrowth * std::min(slope, GreatestGrowth)) /
    (1.0 + FaultsOfBestCircles * std::sqrt(std::min(slope, GreatestSlope)));
}

double GreatestReachFactor(double slope)
{
  return 1.0 + ShareOfGrowth * std::min(slope, GreatestGrowth);
}

double ReachFactor(BiteShape shape, FrontOrder order, const BiteTriangle& triangle)
{
  if (triangle.LeftSpacing == triangle.TopSpacing && triangle.RightSpacing == triangle.TopSpacing)
  {
    return 1.0;
  }
  const double bond = Distance(triangle.Left, triangle.Right);
  const Point2 axis = 1.0 / bond * (triangle.Right - triangle.Left);
  const Point2 offset = triangle.Top - 0.5 * (triangle.Left + triangle.Right);
  const double height = std::abs(Cross(axis, offset));
  const double along = (triangle.RightSpacing - triangle.LeftSpacing) / bond;
  const double level =
    0.5 * (triangle.LeftSpacing + triangle.RightSpacing) + along * Dot(axis, offset);
  const double ahead = height > LeastHeight * bond ? (triangle.TopSpacing - level) / height : 0.0;
  const double slope = std::min(std::sqrt(along * along + ahead * ahead), GreatestSlope);
  const double share = shape == BiteShape::Circle ? ShareOfGrowth : 0.0;
  const double growth = std::clamp(ahead, -GreatestGrowth, GreatestGrowth);
  return (1.0 + share * growth) / (1.0 + Faults(shape, order, slope));
}

} // namespace biting
