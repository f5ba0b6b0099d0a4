// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingPredicateFilters3_h
#define BitingPredicateFilters3_h

#include "Predicates.h"
#include "Predicates3.h"

#include <algorithm> // for max
#include <cmath>     // for abs

/// The first stages of the predicates of space, inline; the notation is that of PredicateFilters.h.
///
/// The magnitudes of the terms are bounded by the greatest differences along the axes, mx, my and
/// mz: the six terms of a determinant of three vectors are at most 6 mx my mz together.
namespace biting
{
namespace detail
{

/// Orient3D. A difference is (1), a product of two (3), the difference of two products (4), its
/// product with a difference (6), the sum of two of the three such products (7); the last rounding
/// cannot change the sign. So the determinant is off by at most ((1 - u)^-7 - 1) 6 Mx My Mz, where
/// M are the exact differences: (1) as computed. Their product and that with the bound are (3), the
/// determinant is enlarged by (1): with (1 - u)^-7 - 1 = 7u + 28u^2 this makes
/// 42u + 168u^2 + 42u * 7u = 42u + 462u^2, and terms in u^3.
constexpr double Orient3DBound = (42.0 + 512.0 * UnitRoundoff) * UnitRoundoff;

/// PowerTest, and InSphere without weights. A squared length is (5), less a difference of weights
/// (6). The determinant of three vectors is (8), one more than above for the second sum. Their
/// product is (15), the first sum of two of the four products (16); the last rounding cannot change
/// the sign. The magnitudes are at most 24 Mx My Mz L together, L = Mx^2 + My^2 + Mz^2 + Mw. As
/// computed L is (6), My and the others (1), and four more roundings as above:
/// 24 (16u + 136u^2) + 384u * 14u = 384u + 8640u^2, and terms in u^3.
constexpr double InSphereBound = (384.0 + 9000.0 * UnitRoundoff) * UnitRoundoff;

/// What products of five tiny differences lose by underflow: in any stage less than a thousand
/// times the smallest subnormal number, 2^-1074. Differences are multiples of 2^-219, because
/// coordinates are not below LeastCoordinate3; products of three are multiples of 2^-657, weights
/// of 2^-386 and products of a weight and three differences of 2^-1043: these lose nothing.
constexpr double InSphereUnderflow = std::numeric_limits<double>::min();

/// The greatest magnitudes of several vectors along each axis.
struct Extents
{
  double X = 0.0;
  double Y = 0.0;
  double Z = 0.0;

  void Add(const Point3& v)
  {
    this->X = std::max(this->X, std::abs(v.X));
    this->Y = std::max(this->Y, std::abs(v.Y));
    this->Z = std::max(this->Z, std::abs(v.Z));
  }

  double Product() const { return this->X * this->Y * this->Z; }
  double Squares() const { return this->X * this->X + this->Y * this->Y + this->Z * this->Z; }
};

/// The stages after the first. `magnitude` is mx my mz, for the second function times L.
int Orient3DWidened(
  const Point3& a, const Point3& b, const Point3& c, const Point3& d, double magnitude);
int InSphereWidened(const Point3& a, const Point3& b, const Point3& c, const Point3& d,
  const Point3& e, double magnitude);

/// What an exact product of factors has in place of a rounded one (Predicates3.cxx).
inline double Product(double x, double y)
{
  return x * y;
}

/// The determinant of InSphere: rows p.X, p.Y, p.Z and its lift for p = a to d, with the sign
/// turned. One text for all stages: numbers are double or wider. `Vector` has X, Y and Z.
template <class Vector, class Lift>
auto SphereDeterminant(const Vector& a, const Vector& b, const Vector& c, const Vector& d,
  const Lift& liftA, const Lift& liftB, const Lift& liftC, const Lift& liftD)
{
  const auto ab = a.X * b.Y - a.Y * b.X;
  const auto ac = a.X * c.Y - a.Y * c.X;
  const auto ad = a.X * d.Y - a.Y * d.X;
  const auto bc = b.X * c.Y - b.Y * c.X;
  const auto bd = b.X * d.Y - b.Y * d.X;
  const auto cd = c.X * d.Y - c.Y * d.X;
  const auto abc = a.Z * bc - b.Z * ac + c.Z * ab;
  const auto abd = a.Z * bd - b.Z * ad + d.Z * ab;
  const auto acd = a.Z * cd - c.Z * ad + d.Z * ac;
  const auto bcd = b.Z * cd - c.Z * bd + d.Z * bc;
  return (Product(liftA, bcd) - Product(liftB, acd)) + (Product(liftC, abd) - Product(liftD, abc));
}

} // namespace detail

inline int Orient3D(const Point3& a, const Point3& b, const Point3& c, const Point3& d)
{
  detail::CountStage(detail::Stage::First);
  const Point3 p = b - a;
  const Point3 q = c - a;
  const Point3 r = d - a;
  const double determinant =
    p.X * (q.Y * r.Z - q.Z * r.Y) + p.Y * (q.Z * r.X - q.X * r.Z) + p.Z * (q.X * r.Y - q.Y * r.X);
  detail::Extents extents;
  extents.Add(p);
  extents.Add(q);
  extents.Add(r);
  const double magnitude = extents.Product();
  if (std::abs(determinant) > detail::Orient3DBound * magnitude)
  {
    return determinant > 0.0 ? 1 : -1;
  }
  return detail::Orient3DWidened(a, b, c, d, magnitude);
}

inline int InSphere(
  const Point3& a, const Point3& b, const Point3& c, const Point3& d, const Point3& e)
{
  detail::CountStage(detail::Stage::First);
  const Point3 ea = a - e;
  const Point3 eb = b - e;
  const Point3 ec = c - e;
  const Point3 ed = d - e;
  const double determinant =
    detail::SphereDeterminant(ea, eb, ec, ed, Dot(ea, ea), Dot(eb, eb), Dot(ec, ec), Dot(ed, ed));
  detail::Extents extents;
  extents.Add(ea);
  extents.Add(eb);
  extents.Add(ec);
  extents.Add(ed);
  const double magnitude = extents.Product() * extents.Squares();
  if (std::abs(determinant) > detail::InSphereBound * magnitude + detail::InSphereUnderflow)
  {
    return determinant > 0.0 ? 1 : -1;
  }
  return detail::InSphereWidened(a, b, c, d, e, magnitude);
}

} // namespace biting

#endif
