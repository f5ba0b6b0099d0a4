// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "BiteTriangle.h"

#include <algorithm> // for min, max, clamp
#include <cmath>     // for sqrt, abs

namespace biting
{

namespace
{

constexpr double FaultsOfSquares = 0.29; // per slope
constexpr double GreatestSlope = 1.0;    // faults do not grow beyond
// Of circles: half of f's growth to the next bite, which is .8 of the way ahead, as some come
// sideways.
constexpr double ShareOfGrowth = 0.4;
constexpr double GreatestGrowth = 0.5;
constexpr double LeastHeight =
  0.1; // of the bond: in a flatter triangle the slope across is unknown

constexpr double LeastShift = 1e-3; // of an edge

// By what share lengths are greater.
double Faults(BiteShape shape, FrontOrder order, double slope)
{
  return shape == BiteShape::Square ? FaultsOfSquares * slope
                                    : RuleOf(order).FaultsOfCircles * std::sqrt(slope);
}

} // namespace

Point2 BalancedTop(const BiteTriangle& triangle, double lengthPerSpacing)
{
  const Point2 bond = triangle.Right - triangle.Left;
  const double left = 0.5 * lengthPerSpacing * (triangle.LeftSpacing + triangle.TopSpacing);
  const double right = 0.5 * lengthPerSpacing * (triangle.RightSpacing + triangle.TopSpacing);
  // In units of the bond, from Left.
  const double perSquare = 1.0 / Dot(bond, bond);
  const double along = 0.5 + 0.5 * (left - right) * (left + right) * perSquare;
  const double height = left * left * perSquare - along * along;
  if (!(height > 0.0))
  {
    return triangle.Top;
  }
  const Point2 across = Perpendicular(bond);
  const double side = Dot(across, triangle.Top - triangle.Left) < 0.0 ? -1.0 : 1.0;
  const Point2 top = triangle.Left + along * bond + side * std::sqrt(height) * across;
  const Point2 shift = top - triangle.Top;
  return Dot(shift, shift) > LeastShift * LeastShift * left * left ? top : triangle.Top;
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

double LeastReachFactor(double slope)
{
  double faults = 0.0;
  for (const FrontRule& rule : FrontRules)
  {
    faults = std::max(faults, rule.FaultsOfCircles);
  }
  return (1.0 - ShareOfGrowth * std::min(slope, GreatestGrowth)) /
    (1.0 + faults * std::sqrt(std::min(slope, GreatestSlope)));
}

double GreatestReachFactor(double slope)
{
  return 1.0 + ShareOfGrowth * std::min(slope, GreatestGrowth);
}

} // namespace biting
