// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Predicates3.h"

#include "DoubleDouble.h"
#include "Expansion.h"

#include <algorithm> // for max
#include <array>     // for five points
#include <cmath>     // for abs, floor, ilogb, ldexp

namespace biting
{
namespace
{

using detail::InSphereUnderflow;
using detail::UnitRoundoff;

/// The errors of DoubleDouble's operators: a cross product (9 + 4)u^2 of its magnitude, its product
/// with an exact difference 22u^2, two sums 30u^2 of at most 6 mx my mz; with the roundings of
/// those this stays below 181u^2 mx my mz.
constexpr double Orient3DWideBound = 192.0 * UnitRoundoff * UnitRoundoff;

/// A squared length is off by (9 + 4 + 4)u^2, less an exact difference of weights by 21u^2; the
/// determinant of three vectors by 30u^2 as above; their product by (21 + 30 + 9)u^2; two levels of
/// sums make it 68u^2 of at most 24 mx my mz L, 1632u^2; with the roundings below 1633u^2.
constexpr double InSphereWideBound = 2048.0 * UnitRoundoff * UnitRoundoff;

/// Scales coordinates so that products of five keep all their bits. A coordinate is a multiple of
/// 2^-219 and at most 2^167 in magnitude (LeastCoordinate3, GreatestCoordinate3). Scaled, a product
/// of five is a multiple of 2^-995, and the determinant is below 2^950; a weight is a multiple of
/// 2^-386, so its product with three coordinates is one of 2^-943. Weights take the square.
constexpr double InSphereScale = 1048576.0; // 2^20

/// How many components an exact number has that is compressed: each is less than 2^-52 of the next,
/// the least is a multiple of 2^-995 and the greatest is below 2^950.
constexpr int PackedCapacity = 40;
using PackedNumber = Expansion<PackedCapacity>;

/// The same number, which is compressed. Of what is not finite something.
template <int Capacity>
PackedNumber Packed(const Expansion<Capacity>& number)
{
  PackedNumber packed;
  for (int i = std::max(0, number.Size() - PackedCapacity); i < number.Size(); ++i)
  {
    packed.Grow(number.begin()[i]);
  }
  return packed;
}

} // namespace

// What SphereDeterminant multiplies with: found by the kinds of the numbers, so in their namespace.

static DoubleDouble Product(const DoubleDouble& x, const DoubleDouble& y)
{
  return x * y;
}

/// Keeps the stack small.
template <int N, int M>
static PackedNumber Product(const Expansion<N>& x, const Expansion<M>& y)
{
  return Packed(x * Packed(y));
}

namespace
{

/// A vector of numbers wider than double, so that one text serves both stages.
template <class Number>
struct WideVector3
{
  Number X;
  Number Y;
  Number Z;
};

/// The vector from `origin` to p: exact in both kinds of numbers.
template <class Number>
WideVector3<Number> WideVectorTo(const Point3& p, const Point3& origin)
{
  return { Number(TwoDifference(p.X, origin.X)), Number(TwoDifference(p.Y, origin.Y)),
    Number(TwoDifference(p.Z, origin.Z)) };
}

template <class Number>
auto VolumeDeterminant(const Point3& a, const Point3& b, const Point3& c, const Point3& d)
{
  const auto p = WideVectorTo<Number>(b, a);
  const auto q = WideVectorTo<Number>(c, a);
  const auto r = WideVectorTo<Number>(d, a);
  return p.X * (q.Y * r.Z - q.Z * r.Y) + p.Y * (q.Z * r.X - q.X * r.Z) +
    p.Z * (q.X * r.Y - q.Y * r.X);
}

/// The squared distance less the difference of the weights: exact in exact numbers.
template <class Number>
auto LiftOf(const WideVector3<Number>& v, double weight, double weightOfOrigin)
{
  return v.X * v.X + v.Y * v.Y + v.Z * v.Z - Number(TwoDifference(weight, weightOfOrigin));
}

using FivePoints = std::array<WeightedPoint, 5>;

template <class Number>
auto PowerDeterminant(const FivePoints& p)
{
  const auto a = WideVectorTo<Number>(p[0].Place, p[4].Place);
  const auto b = WideVectorTo<Number>(p[1].Place, p[4].Place);
  const auto c = WideVectorTo<Number>(p[2].Place, p[4].Place);
  const auto d = WideVectorTo<Number>(p[3].Place, p[4].Place);
  return detail::SphereDeterminant(a, b, c, d, LiftOf(a, p[0].Weight, p[4].Weight),
    LiftOf(b, p[1].Weight, p[4].Weight), LiftOf(c, p[2].Weight, p[4].Weight),
    LiftOf(d, p[3].Weight, p[4].Weight));
}

/// The stages after double arithmetic.
int PowerTestOf(FivePoints points, double magnitude)
{
  const double determinant = PowerDeterminant<DoubleDouble>(points).High;
  if (std::abs(determinant) > InSphereWideBound * magnitude + InSphereUnderflow)
  {
    return determinant > 0.0 ? 1 : -1;
  }
  detail::CountStage(detail::Stage::Exact);
  for (WeightedPoint& point : points)
  {
    point = { InSphereScale * point.Place, InSphereScale * InSphereScale * point.Weight };
  }
  return PowerDeterminant<Expansion<2>>(points).Sign();
}

/// Numerators and denominator of PowerCenter: the vector is the solution x of v . x = lift / 2 for
/// the three vectors v.
template <class Vector, class Lift>
auto PowerNumerator(const std::array<Vector, 3>& v, const std::array<Lift, 3>& lifts)
{
  const auto term = [&v, &lifts](std::size_t i, auto first, auto second)
  {
    const Vector& p = v[(i + 1) % 3];
    const Vector& q = v[(i + 2) % 3];
    return lifts[i] * (p.*first * (q.*second) - p.*second * (q.*first));
  };
  return [term](auto first, auto second)
  { return term(0, first, second) + term(1, first, second) + term(2, first, second); };
}

DoubleDouble Rounded(const DoubleDouble& x)
{
  return x;
}

template <int Capacity>
DoubleDouble Rounded(const Expansion<Capacity>& x)
{
  return x.Rounded();
}

/// The quotient in the numbers. False where the determinant is not above `least`.
template <class Number>
bool WidePowerCenter(const std::array<WeightedPoint, 4>& p, double least, Point3& center)
{
  using Vector = WideVector3<Number>;
  std::array<Vector, 3> v;
  std::array<decltype(LiftOf(v[0], 0.0, 0.0)), 3> lifts;
  for (std::size_t k = 0; k < 3; ++k)
  {
    v[k] = WideVectorTo<Number>(p[k + 1].Place, p[0].Place);
    lifts[k] = LiftOf(v[k], p[k + 1].Weight, p[0].Weight);
  }
  const DoubleDouble denominator =
    Rounded(VolumeDeterminant<Number>(p[0].Place, p[1].Place, p[2].Place, p[3].Place));
  if (!(std::abs(denominator.High) > least))
  {
    return false;
  }
  const auto numerator = PowerNumerator(v, lifts);
  center = 0.5 *
    Point3{ Quotient(Rounded(numerator(&Vector::Y, &Vector::Z)), denominator),
      Quotient(Rounded(numerator(&Vector::Z, &Vector::X)), denominator),
      Quotient(Rounded(numerator(&Vector::X, &Vector::Y)), denominator) };
  return true;
}

/// Whether all vectors from the origin to the points are exact and whole multiples of one number,
/// up to 2^9 times along each axis: so they are on lattices. Then the determinants of Orient3D and
/// InSphere are exact in double arithmetic, which makes 2^-9 times this number the unit: a lift is
/// below 2^20, a determinant of three vectors below 2^30, the sum of four products below 2^52.
template <class Points>
bool AreFewSteps(const Points& points, const Point3& origin, const detail::Extents& extents)
{
  constexpr double LeastWithoutUnderflow = 1e-50; // five factors of 2^-9 times it are above 2^-890
  const double largest = std::max(extents.X, std::max(extents.Y, extents.Z));
  if (!(largest > LeastWithoutUnderflow && largest <= GreatestCoordinate3 * 2.0))
  {
    return false;
  }
  const double perUnit = std::ldexp(1.0, 8 - std::ilogb(largest));
  for (const auto& point : points)
  {
    for (std::size_t d = 0; d < 3; ++d)
    {
      const DoubleDouble difference = TwoDifference(point[d], origin[d]);
      const double steps = difference.High * perUnit;
      if (difference.Low != 0.0 || steps != std::floor(steps))
      {
        return false;
      }
    }
  }
  return true;
}

/// Whether the five are corners of one box along the axes: then a sphere goes through them. So are
/// most of those that come here from lattices whose steps are rounded.
bool AreOfOneBox(const std::array<const Point3*, 5>& points)
{
  for (std::size_t d = 0; d < 3; ++d)
  {
    const double first = (*points[0])[d];
    double other = first;
    for (const Point3* point : points)
    {
      const double value = (*point)[d];
      if (value != first && value != other && other != first)
      {
        return false;
      }
      other = value == first ? other : value;
    }
  }
  return true;
}

int SignOf(double value)
{
  return (value > 0.0) - (value < 0.0);
}

} // namespace

int detail::Orient3DWidened(
  const Point3& a, const Point3& b, const Point3& c, const Point3& d, double magnitude)
{
  CountStage(Stage::Wide);
  if (magnitude == 0.0) // nothing underflows in range: the four have a coordinate in common
  {
    return 0;
  }
  const std::array<Point3, 3> points{ b, c, d };
  const std::array<Point3, 3> v{ b - a, c - a, d - a };
  detail::Extents extents;
  for (const Point3& vector : v)
  {
    extents.Add(vector);
  }
  if (AreFewSteps(points, a, extents))
  {
    return SignOf(Dot(v[0], Cross(v[1], v[2])));
  }
  const double determinant = VolumeDeterminant<DoubleDouble>(a, b, c, d).High;
  if (std::abs(determinant) > Orient3DWideBound * magnitude)
  {
    return determinant > 0.0 ? 1 : -1;
  }
  CountStage(Stage::Exact);
  return VolumeDeterminant<Expansion<2>>(a, b, c, d).Sign();
}

int detail::InSphereWidened(const Point3& a, const Point3& b, const Point3& c, const Point3& d,
  const Point3& e, double magnitude)
{
  CountStage(Stage::Wide);
  if (AreOfOneBox({ &a, &b, &c, &d, &e }))
  {
    return 0;
  }
  const std::array<Point3, 4> others{ a, b, c, d };
  std::array<Point3, 4> v;
  detail::Extents extents;
  for (std::size_t k = 0; k < 4; ++k)
  {
    v[k] = others[k] - e;
    extents.Add(v[k]);
  }
  if (AreFewSteps(others, e, extents))
  {
    return SignOf(SphereDeterminant(
      v[0], v[1], v[2], v[3], Dot(v[0], v[0]), Dot(v[1], v[1]), Dot(v[2], v[2]), Dot(v[3], v[3])));
  }
  return PowerTestOf({ { { a, 0.0 }, { b, 0.0 }, { c, 0.0 }, { d, 0.0 }, { e, 0.0 } } }, magnitude);
}

int PowerTest(const WeightedPoint& a, const WeightedPoint& b, const WeightedPoint& c,
  const WeightedPoint& d, const WeightedPoint& e)
{
  detail::CountStage(detail::Stage::First);
  const WeightedPoint* points[4] = { &a, &b, &c, &d };
  Point3 v[4];
  double lifts[4];
  detail::Extents extents;
  double greatest = 0.0; // difference of weights
  for (int k = 0; k < 4; ++k)
  {
    const double weight = points[k]->Weight - e.Weight;
    v[k] = points[k]->Place - e.Place;
    lifts[k] = Dot(v[k], v[k]) - weight;
    extents.Add(v[k]);
    greatest = std::max(greatest, std::abs(weight));
  }
  const double determinant =
    detail::SphereDeterminant(v[0], v[1], v[2], v[3], lifts[0], lifts[1], lifts[2], lifts[3]);
  const double magnitude = extents.Product() * (extents.Squares() + greatest);
  if (std::abs(determinant) > detail::InSphereBound * magnitude + InSphereUnderflow)
  {
    return determinant > 0.0 ? 1 : -1;
  }
  if (greatest == 0.0)
  {
    return detail::InSphereWidened(a.Place, b.Place, c.Place, d.Place, e.Place, magnitude);
  }
  detail::CountStage(detail::Stage::Wide);
  return PowerTestOf({ a, b, c, d, e }, magnitude);
}

int TieInSphere(const Point3& a, const Point3& b, const Point3& c, const Point3& d, const Point3& e)
{
  // Mostly the first place decides: no sorting.
  std::array<const Point3*, 5> left{ &a, &b, &c, &d, &e };
  for (;;)
  {
    std::size_t k = 4;
    for (std::size_t i = 0; i < 4; ++i)
    {
      k = left[i] != nullptr && *left[k] < *left[i] ? i : k;
    }
    if (k == 4) // its lift grows most: it rises out of the sphere
    {
      return -1;
    }
    // The factor of the lift of point k in the determinant of InSphere.
    std::array<const Point3*, 4> others{ &a, &b, &c, &d };
    others[k] = &e;
    const int sign = Orient3D(*others[0], *others[1], *others[2], *others[3]);
    if (sign != 0)
    {
      return sign;
    }
    left[k] = nullptr;
  }
}

// With m the greatest difference along an axis, a determinant above 2^-10 m^3 is off by 2^-37 of
// its value. A lift is at most 4 m^2, a numerator off by less than 2^-43 m^4: the quotient by
// 2^-33 m. In DoubleDouble one above 2^-40 m^3 is off by 2^-58 of its value (Orient3DWideBound), a
// numerator by less than 2^-95 m^4 (InSphereWideBound): the quotient by 2^-56 m and its rounding.
Point3 PowerCenter(
  const WeightedPoint& a, const WeightedPoint& b, const WeightedPoint& c, const WeightedPoint& d)
{
  constexpr double LeastShare = 1.0 / 1024.0;
  constexpr double LeastWideShare = LeastShare * LeastShare * LeastShare * LeastShare;
  const std::array<Point3, 3> v{ b.Place - a.Place, c.Place - a.Place, d.Place - a.Place };
  const std::array<double, 3> lifts{ Dot(v[0], v[0]) - (b.Weight - a.Weight),
    Dot(v[1], v[1]) - (c.Weight - a.Weight), Dot(v[2], v[2]) - (d.Weight - a.Weight) };
  detail::Extents extents;
  for (const Point3& vector : v)
  {
    extents.Add(vector);
  }
  const double determinant = Dot(v[0], Cross(v[1], v[2]));
  const double largest = std::max(extents.X, std::max(extents.Y, extents.Z));
  const double cube = largest * largest * largest;
  if (!(std::abs(determinant) > LeastShare * cube))
  {
    Point3 center;
    if (!WidePowerCenter<DoubleDouble>({ a, b, c, d }, LeastWideShare * cube, center))
    {
      WidePowerCenter<Expansion<2>>({ a, b, c, d }, -1.0, center);
    }
    return center;
  }
  return 0.5 / determinant *
    (lifts[0] * Cross(v[1], v[2]) + lifts[1] * Cross(v[2], v[0]) + lifts[2] * Cross(v[0], v[1]));
}

} // namespace biting
