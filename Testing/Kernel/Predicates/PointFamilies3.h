// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingPointFamilies3_h
#define BitingPointFamilies3_h

#include "PointFamilies.h"
#include "Predicates/Predicates3.h"

#include <array>   // for five points
#include <cmath>   // for ldexp
#include <utility> // for swap

namespace predicates_test
{

using biting::Point3;
using biting::WeightedPoint;
using Five = std::array<WeightedPoint, 5>;

// The truth, in integers.

/// Coordinates are multiples of 2^-SpaceBits, weights of its square.
constexpr int SpaceBits = 220;

using ExactRow = std::array<Integer, 4>;

/// The vector from `origin` to p, and its lift.
inline ExactRow RowOf(const WeightedPoint& p, const WeightedPoint& origin)
{
  ExactRow row;
  for (std::size_t d = 0; d < 3; ++d)
  {
    row[d] = Exactly(p.Place[d], SpaceBits) - Exactly(origin.Place[d], SpaceBits);
    row[3] += row[d] * row[d];
  }
  row[3] -= Exactly(p.Weight, 2 * SpaceBits) - Exactly(origin.Weight, 2 * SpaceBits);
  return row;
}

inline Integer Determinant3(const ExactRow& p, const ExactRow& q, const ExactRow& r)
{
  return p[0] * (q[1] * r[2] - q[2] * r[1]) + p[1] * (q[2] * r[0] - q[0] * r[2]) +
    p[2] * (q[0] * r[1] - q[1] * r[0]);
}

inline int TrueOrient3D(const Point3& a, const Point3& b, const Point3& c, const Point3& d)
{
  return Determinant3(
    RowOf({ b, 0 }, { a, 0 }), RowOf({ c, 0 }, { a, 0 }), RowOf({ d, 0 }, { a, 0 }))
    .sign();
}

inline int TruePowerTest(const Five& p)
{
  const ExactRow rows[4] = { RowOf(p[0], p[4]), RowOf(p[1], p[4]), RowOf(p[2], p[4]),
    RowOf(p[3], p[4]) };
  const Integer determinant = rows[0][3] * Determinant3(rows[1], rows[2], rows[3]) -
    rows[1][3] * Determinant3(rows[0], rows[2], rows[3]) +
    rows[2][3] * Determinant3(rows[0], rows[1], rows[3]) -
    rows[3][3] * Determinant3(rows[0], rows[1], rows[2]);
  return determinant.sign();
}

/// A fraction of whole units.
inline double LengthOf(const Integer& numerator, const Integer& denominator)
{
  constexpr int MoreBits = 120;
  const Integer quotient((numerator << MoreBits) / denominator);
  return std::ldexp(quotient.convert_to<double>(), -MoreBits - SpaceBits);
}

// Where the points come from.

inline Point3 UnitPoint3(Sampler& sampler)
{
  return { sampler.Unit(), sampler.Unit(), sampler.Unit() };
}

inline Point3 Nudged3(Sampler& sampler, const Point3& p)
{
  return { sampler.Nudged(p.X), sampler.Nudged(p.Y), sampler.Nudged(p.Z) };
}

template <class Make>
Five FiveOf(Make make)
{
  Five five;
  for (WeightedPoint& point : five)
  {
    point.Place = make();
  }
  return five;
}

inline Five OrdinaryFive(Sampler& sampler)
{
  return FiveOf([&sampler] { return UnitPoint3(sampler); });
}

inline Five LatticeFive(Sampler& sampler)
{
  const int size = 2 + sampler.Below(3);
  return FiveOf(
    [&sampler, size]
    {
      return Point3{ static_cast<double>(sampler.Below(size)),
        static_cast<double>(sampler.Below(size)), static_cast<double>(sampler.Below(size)) };
    });
}

/// Corners of a box with all bits in use: exactly on one sphere.
inline Five BoxFive(Sampler& sampler)
{
  const Point3 corners[2] = { UnitPoint3(sampler), UnitPoint3(sampler) };
  return FiveOf(
    [&sampler, &corners]
    {
      return Point3{ corners[sampler.Below(2)].X, corners[sampler.Below(2)].Y,
        corners[sampler.Below(2)].Z };
    });
}

inline Five NearlyCoplanarFive(Sampler& sampler)
{
  const Point3 origin = UnitPoint3(sampler);
  const Point3 p = UnitPoint3(sampler) - origin;
  const Point3 q = UnitPoint3(sampler) - origin;
  return FiveOf([&sampler, &origin, &p, &q]
    { return Nudged3(sampler, origin + sampler.Unit() * p + sampler.Unit() * q); });
}

inline Five NearlyCosphericalFive(Sampler& sampler)
{
  const Point3 center = UnitPoint3(sampler);
  const double radius = 0.01 * sampler.Unit();
  return FiveOf(
    [&sampler, &center, radius]
    {
      const Point3 v = UnitPoint3(sampler) - Point3{ 0.5, 0.5, 0.5 };
      return Nudged3(sampler, center + radius / Length(v) * v);
    });
}

/// A point and its images under signs and turns of the axes: exactly on a sphere.
inline Five SymmetricFive(Sampler& sampler)
{
  const Point3 p = UnitPoint3(sampler);
  return FiveOf(
    [&sampler, &p]
    {
      const int turn = sampler.Below(3);
      const auto sign = [&sampler] { return sampler.Below(2) == 0 ? -1.0 : 1.0; };
      const auto axis = [turn](int d) { return static_cast<std::size_t>((d + turn) % 3); };
      return Point3{ sign() * p[axis(0)], sign() * p[axis(1)], sign() * p[axis(2)] };
    });
}

inline Five FarFive(Sampler& sampler)
{
  Five five = sampler.Below(2) == 0 ? OrdinaryFive(sampler) : NearlyCosphericalFive(sampler);
  for (WeightedPoint& point : five)
  {
    point.Place = Point3{ 1e8, -1e8, 3e7 } + point.Place;
  }
  return five;
}

inline Five FlatFive(Sampler& sampler)
{
  Five five = OrdinaryFive(sampler);
  for (WeightedPoint& point : five)
  {
    point.Place.Z *= 1e-12;
  }
  return five;
}

/// Of any magnitude in range.
inline Five MixedFive(Sampler& sampler)
{
  const auto any = [&sampler]
  {
    const double sign = sampler.Below(2) == 0 ? -1.0 : 1.0;
    return sign * std::ldexp(1.0 + sampler.Unit(), sampler.Below(332) - 166);
  };
  return FiveOf([&any] { return Point3{ any(), any(), any() }; });
}

inline Five LimitFive(Sampler& sampler)
{
  const auto any = [&sampler]
  {
    const double choices[4] = { 0.0, biting::LeastCoordinate3 * (1.0 + sampler.Unit()),
      -biting::LeastCoordinate3, biting::GreatestCoordinate3 * sampler.Unit() };
    return choices[sampler.Below(4)];
  };
  return FiveOf([&any] { return Point3{ any(), any(), any() }; });
}

/// Coordinates of about the least magnitude, whose differences are smaller by up to all bits.
inline Five LeastFive(Sampler& sampler)
{
  return FiveOf(
    [&sampler]
    {
      const Point3 p = std::ldexp(1.0, -sampler.Below(52)) * UnitPoint3(sampler);
      return std::ldexp(1.0, -166) * (Point3{ 1.0, 1.0, 1.0 } + p);
    });
}

using MakeFive = Five (*)(Sampler&);

constexpr MakeFive FamiliesOfFive[] = { OrdinaryFive, LatticeFive, BoxFive, NearlyCoplanarFive,
  NearlyCosphericalFive, SymmetricFive, FarFive, FlatFive, MixedFive, LimitFive, LeastFive };

/// Weights: none, alike, as large as the squared distances, or as makes the five nearly or
/// exactly orthogonal to one sphere around a lattice point.
inline void AddWeights(Sampler& sampler, Five& five)
{
  const int kind = sampler.Below(4);
  const double alike = sampler.Unit();
  const Point3 origin = five[static_cast<std::size_t>(sampler.Below(5))].Place;
  for (WeightedPoint& point : five)
  {
    const Point3 v = point.Place - origin;
    const double weight = kind == 3 ? Dot(v, v) + (sampler.Below(2) == 0 ? 0.0 : alike)
                                    : (kind == 2 ? sampler.Unit() * Dot(v, v) : alike);
    point.Weight = kind == 0 || weight < 1e-100 ? 0.0 : std::fmin(weight, 1e100);
  }
}

/// Calls check(five) for `count` of each family, oriented as they come; stops at the first failure.
template <class Check>
void ForAllFives(int count, Check check)
{
  int number = 0;
  for (const MakeFive make : FamiliesOfFive)
  {
    SCOPED_TRACE(number++);
    Sampler sampler;
    for (int i = 0; i < count && !testing::Test::HasFailure(); ++i)
    {
      Five five = make(sampler);
      AddWeights(sampler, five);
      check(five);
    }
  }
}

} // namespace predicates_test

#endif
