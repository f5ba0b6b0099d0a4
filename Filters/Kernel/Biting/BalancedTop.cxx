// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "BalancedTop.h"

#include <cmath> // for sqrt

namespace biting
{

namespace
{

constexpr double LeastShift = 1e-3; // of an edge

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

} // namespace biting
