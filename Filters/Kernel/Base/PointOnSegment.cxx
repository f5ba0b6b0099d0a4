// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "PointOnSegment.h"

#include <algorithm> // for max, min
#include <cmath>     // for abs, nextafter
#include <limits>    // for epsilon, infinity

namespace biting
{

namespace
{

constexpr double FewDigits = 1e-12; // of its length: rounding that a segment does not notice
constexpr int Steps = 8;            // to either side
constexpr double LeastRoom = 16.0;  // of these

double MagnitudeOf(const Point2& p)
{
  return std::max(std::abs(p.X), std::abs(p.Y));
}

/// The place on the line ab with that x, for lines that are not steep.
double HeightAt(double x, const Point2& a, const Point2& b)
{
  return a.Y + (x - a.X) * ((b.Y - a.Y) / (b.X - a.X));
}

double OffLine(const Point2& p, const Point2& a, const Point2& b)
{
  return std::abs(Cross(b - a, p - a));
}

/// Walks along the line ab, which is not steep, by units of rounding.
Point2 LeastOff(const Point2& start, const Point2& a, const Point2& b)
{
  const double magnitude = std::abs(start.X);
  const double unit =
    std::nextafter(magnitude, std::numeric_limits<double>::infinity()) - magnitude;
  Point2 best = start;
  double least = OffLine(start, a, b);
  for (const double step : { -unit, unit })
  {
    for (int k = 1; k <= Steps; ++k)
    {
      const double x = start.X + k * step;
      const Point2 p{ x, HeightAt(x, a, b) };
      const double off = OffLine(p, a, b);
      best = off < least ? p : best;
      least = std::min(off, least);
    }
  }
  return best;
}

Point2 Swapped(const Point2& p)
{
  return { p.Y, p.X };
}

} // namespace

Point2 PointOnSegment(const Point2& a, const Point2& b, double t, double room)
{
  const Point2 direction = b - a;
  const Point2 rounded = t < 0.5 ? a + t * direction : b + (t - 1.0) * direction;
  const double rounding = std::numeric_limits<double>::epsilon() * MagnitudeOf(rounded);
  const bool isSteep = std::abs(direction.Y) > std::abs(direction.X);
  const double length = MagnitudeOf(direction);
  if (rounding <= FewDigits * length || room <= LeastRoom * Steps * rounding)
  {
    return rounded;
  }
  return isSteep ? Swapped(LeastOff(Swapped(rounded), Swapped(a), Swapped(b)))
                 : LeastOff(rounded, a, b);
}

} // namespace biting
