// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingPointFamilies_h
#define BitingPointFamilies_h

#include "ExactOracle.h"

#include <gtest/gtest.h>

#include <cmath>   // for ldexp, nextafter, sin, cos
#include <cstdlib> // for abs
#include <limits>  // for infinity
#include <random>  // for mt19937_64, whose output is the same everywhere

namespace predicates_test
{

// Where the points come from.

class Sampler
{
public:
  int Below(int bound)
  {
    return static_cast<int>(this->Generator() % static_cast<unsigned long long>(bound));
  }

  /// In [0, 1), all 53 bits random.
  double Unit() { return std::ldexp(static_cast<double>(this->Generator() >> 11), -53); }
  Point2 UnitPoint() { return { this->Unit(), this->Unit() }; }
  Point2 GridPoint(int size)
  {
    return { static_cast<double>(this->Below(size)), static_cast<double>(this->Below(size)) };
  }

  /// x moved by at most two units in the last place.
  double Nudged(double x)
  {
    const int steps = this->Below(5) - 2;
    for (int i = 0; i < std::abs(steps); ++i)
    {
      x = std::nextafter(x, steps * std::numeric_limits<double>::infinity());
    }
    return x;
  }

  Point2 OnUnitCircle()
  {
    const double angle = 6.28 * this->Unit();
    return { std::cos(angle), std::sin(angle) };
  }

private:
  std::mt19937_64 Generator{ 20240607 };
};

inline Quadruple OrdinaryPoints(Sampler& sampler)
{
  return { sampler.UnitPoint(), sampler.UnitPoint(), sampler.UnitPoint(), sampler.UnitPoint() };
}

inline Quadruple GridPoints(Sampler& sampler)
{
  return { sampler.GridPoint(4), sampler.GridPoint(4), sampler.GridPoint(4), sampler.GridPoint(4) };
}

inline Quadruple NearlyCollinearPoints(Sampler& sampler)
{
  Quadruple q{ sampler.UnitPoint(), sampler.UnitPoint(), {}, {} };
  for (Point2* p : { &q[2], &q[3] })
  {
    *p = q[0] + 2.0 * sampler.Unit() * (q[1] - q[0]);
    *p = { sampler.Nudged(p->X), sampler.Nudged(p->Y) };
  }
  return q;
}

inline Quadruple NearlyCocircularPoints(Sampler& sampler)
{
  const Point2 center = sampler.UnitPoint();
  const double radius = 0.01 * sampler.Unit();
  Quadruple q;
  for (Point2& p : q)
  {
    p = center + radius * sampler.OnUnitCircle();
    p = { sampler.Nudged(p.X), sampler.Nudged(p.Y) };
  }
  return q;
}

/// The corners of a square as biting makes them: center plus and minus a rounded vector.
inline Quadruple TurnedSquare(Sampler& sampler)
{
  const Point2 center = sampler.UnitPoint();
  const Point2 reach = 0.003 * sampler.OnUnitCircle();
  const Point2 side = Perpendicular(reach);
  return { center + reach, center + side, center - reach, center - side };
}

/// Exactly co-circular, with all bits of the coordinates in use.
inline Quadruple FullBitRectangle(Sampler& sampler)
{
  const Point2 low = sampler.UnitPoint();
  const Point2 high = sampler.UnitPoint();
  return { low, Point2{ high.X, low.Y }, high, Point2{ low.X, high.Y } };
}

/// Two pairs that are mirrored at one line along an axis: exactly co-circular.
inline Quadruple MirroredPairs(Sampler& sampler)
{
  const auto multiple = [&sampler] { return std::ldexp(sampler.Below(1 << 26), -26); };
  const double middle = multiple();
  const Point2 first{ multiple(), sampler.Unit() };
  const Point2 second{ multiple(), sampler.Unit() };
  Quadruple q{ Point2{ middle - first.X, first.Y }, Point2{ middle + first.X, first.Y },
    Point2{ middle - second.X, second.Y }, Point2{ middle + second.X, second.Y } };
  if (sampler.Below(2) == 0)
  {
    for (Point2& p : q)
    {
      p = { p.Y, p.X };
    }
  }
  return q;
}

/// The same, but one of the four is off by at most two units in the last place.
inline Quadruple NearlyMirroredPairs(Sampler& sampler)
{
  Quadruple q = MirroredPairs(sampler);
  Point2& p = q[static_cast<std::size_t>(sampler.Below(4))];
  p = { sampler.Nudged(p.X), sampler.Nudged(p.Y) };
  return q;
}

/// Exactly co-circular around the origin.
inline Quadruple FullBitSquare(Sampler& sampler)
{
  const Point2 p = sampler.UnitPoint();
  const Point2 q = Perpendicular(p);
  return { p, q, -1.0 * p, -1.0 * q };
}

/// Exactly collinear, with nearly all bits of the coordinates in use and differences that round.
inline Quadruple SteepLinePoints(Sampler& sampler)
{
  Quadruple q;
  for (Point2& p : q)
  {
    const double x = std::floor(std::ldexp(sampler.Unit(), 50));
    p = std::ldexp(x, -sampler.Below(20)) * Point2{ 1.0, -3.0 };
  }
  return q;
}

inline Quadruple PointsFarAway(Sampler& sampler)
{
  Quadruple q = sampler.Below(2) == 0 ? OrdinaryPoints(sampler) : TurnedSquare(sampler);
  for (Point2& p : q)
  {
    p = Point2{ 1e8, -1e8 } + p;
  }
  return q;
}

inline Quadruple TinyPoints(Sampler& sampler)
{
  Quadruple q =
    sampler.Below(2) == 0 ? NearlyCollinearPoints(sampler) : NearlyCocircularPoints(sampler);
  for (Point2& p : q)
  {
    p = 1e-18 * p;
  }
  return q;
}

inline double OfAnyMagnitude(Sampler& sampler)
{
  const double sign = sampler.Below(2) == 0 ? -1.0 : 1.0;
  return sign * std::ldexp(1.0 + sampler.Unit(), sampler.Below(464) - 232);
}

inline Quadruple MixedMagnitudes(Sampler& sampler)
{
  Quadruple q;
  for (Point2& p : q)
  {
    p = { OfAnyMagnitude(sampler), OfAnyMagnitude(sampler) };
  }
  return q;
}

/// Zero, or about the least or the greatest coordinate in magnitude.
inline double AtLimits(Sampler& sampler)
{
  const double sign = sampler.Below(2) == 0 ? -1.0 : 1.0;
  const double nudge = 1.0 + std::ldexp(sampler.Below(3), -52);
  const double choices[3] = { 0.0, nudge * biting::LeastCoordinate,
    biting::GreatestCoordinate / nudge };
  return sign * choices[sampler.Below(3)];
}

inline Quadruple PointsAtLimits(Sampler& sampler)
{
  Quadruple q;
  for (Point2& p : q)
  {
    p = { AtLimits(sampler), AtLimits(sampler) };
  }
  return q;
}

/// Coordinates of about the least magnitude, whose differences are smaller by up to all their bits.
inline Quadruple LeastPoints(Sampler& sampler)
{
  Quadruple q;
  for (Point2& p : q)
  {
    p = std::ldexp(1.0, -sampler.Below(52)) * sampler.UnitPoint();
    p = std::ldexp(1.0, -232) * (Point2{ 1.0, 1.0 } + p);
  }
  return q;
}

struct Family
{
  const char* Name;
  Quadruple (*Make)(Sampler&);
};

constexpr Family Families[] = {
  { "ordinary", OrdinaryPoints },
  { "grid", GridPoints },
  { "nearly collinear", NearlyCollinearPoints },
  { "nearly co-circular", NearlyCocircularPoints },
  { "turned square", TurnedSquare },
  { "full-bit rectangle", FullBitRectangle },
  { "mirrored pairs", MirroredPairs },
  { "nearly mirrored pairs", NearlyMirroredPairs },
  { "full-bit square", FullBitSquare },
  { "steep line", SteepLinePoints },
  { "far away", PointsFarAway },
  { "tiny", TinyPoints },
  { "mixed magnitudes", MixedMagnitudes },
  { "limits of the range", PointsAtLimits },
  { "least points", LeastPoints },
};

/// Calls check(q) for `count` quadruples of each family; stops at the first failure.
template <class Check>
void ForAllFamilies(int count, Check check)
{
  for (const Family& family : Families)
  {
    SCOPED_TRACE(family.Name);
    Sampler sampler;
    for (int i = 0; i < count && !testing::Test::HasFailure(); ++i)
    {
      check(family.Make(sampler));
    }
  }
}

} // namespace predicates_test

#endif
