// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "ExactSigns.h"

#include "WholeNumbers.h"

#include <algorithm> // for min
#include <array>     // for the points
#include <cmath>     // for abs

namespace biting
{

namespace
{

/// Far above the 6 and 16 roundings of the two filters, whose unit is 2^-53.
constexpr double OrientationBound = 0x1p-49;
constexpr double InCircleBound = 0x1p-47;

/// Below it products of four differences may have lost their digits.
constexpr double LeastInCircle = 1e-280;
constexpr double LeastOrientation = 1e-290;

/// All coordinates in one unit that divides them.
template <std::size_t Count>
std::array<WholePoint, Count> ToWhole(const std::array<Point2, Count>& points)
{
  int unit = GreatestUnit;
  for (const Point2& p : points)
  {
    unit = std::min(unit, UnitOf(p));
  }
  std::array<WholePoint, Count> whole;
  for (std::size_t k = 0; k < Count; ++k)
  {
    whole[k] = ToWhole(points[k], unit);
  }
  return whole;
}

/// 0 where the sign of `value` is not certain.
int CertainSign(double value, double magnitude, double bound, double least)
{
  const bool isCertain = std::abs(value) > bound * magnitude && magnitude > least;
  return !isCertain ? 0 : value > 0.0 ? 1 : -1;
}

Whole SquaredLength(const WholePoint& a)
{
  return a.X * a.X + a.Y * a.Y;
}

double CrossMagnitude(const Point2& a, const Point2& b)
{
  return std::abs(a.X * b.Y) + std::abs(a.Y * b.X);
}

} // namespace

int ExactOrientation(const Point2& a, const Point2& b, const Point2& c)
{
  const Point2 u = b - a;
  const Point2 v = c - a;
  const int certain =
    CertainSign(u.X * v.Y - u.Y * v.X, CrossMagnitude(u, v), OrientationBound, LeastOrientation);
  if (certain != 0)
  {
    return certain;
  }
  const auto whole = ToWhole<3>({ a, b, c });
  return Cross(whole[1] - whole[0], whole[2] - whole[0]).sign();
}

int ExactInCircle(const Point2& a, const Point2& b, const Point2& c, const Point2& d)
{
  const Point2 u = a - d;
  const Point2 v = b - d;
  const Point2 w = c - d;
  const double determinant =
    Dot(u, u) * Cross(v, w) + Dot(v, v) * Cross(w, u) + Dot(w, w) * Cross(u, v);
  const double magnitude = Dot(u, u) * CrossMagnitude(v, w) + Dot(v, v) * CrossMagnitude(w, u) +
    Dot(w, w) * CrossMagnitude(u, v);
  const int certain = CertainSign(determinant, magnitude, InCircleBound, LeastInCircle);
  if (certain != 0)
  {
    return certain;
  }
  const auto whole = ToWhole<4>({ a, b, c, d });
  const WholePoint p = whole[0] - whole[3];
  const WholePoint q = whole[1] - whole[3];
  const WholePoint r = whole[2] - whole[3];
  const Whole sum = SquaredLength(p) * Cross(q, r) + SquaredLength(q) * Cross(r, p) +
    SquaredLength(r) * Cross(p, q);
  return sum.sign();
}

} // namespace biting
