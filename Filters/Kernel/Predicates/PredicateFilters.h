// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingPredicateFilters_h
#define BitingPredicateFilters_h

#include "Predicates.h"

#include <cmath>  // for abs
#include <limits> // for the smallest normal number

/// The first stages of the predicates, inline because they are called tens of times per vertex.
///
/// Notation of the derivations: u = 2^-53 bounds the relative error of one operation, and (k)
/// stands for any factor between (1 - u)^k and (1 - u)^-k. A fused multiply-add only leaves out a
/// rounding, so the bounds hold with and without it.
namespace biting
{
namespace detail
{

constexpr double UnitRoundoff = std::numeric_limits<double>::epsilon() / 2;

/// Orient2D. A difference is (1), a product of two of them (3), so left - right before its own
/// rounding is off by at most ((1 - u)^-3 - 1) M, where M = |left| + |right| as computed. The last
/// rounding cannot change the sign. It enlarges |determinant| by (1), M is rounded by (1) and so is
/// the product with the bound: 3u + 6u^2 + 3u * 3u = 3u + 15u^2, and terms in u^3.
constexpr double OrientBound = (3.0 + 16.0 * UnitRoundoff) * UnitRoundoff;

/// InCircle. A squared length is (4): products of differences (3), one sum. A cross product is off
/// by (4) of the sum of its two terms' magnitudes. Their product is (9), the first sum of two of
/// the three products makes it (10); the last rounding cannot change the sign. The sum M of the
/// magnitudes of all terms is at most S, that of the products of two squared lengths: the two terms
/// of a cross product are together at most half the sum of the squared lengths. S is (11) as
/// computed, and two more roundings as above: with (1 - u)^-10 - 1 = 10u + 55u^2 this makes
/// 10u + 55u^2 + 10u * 13u = 10u + 185u^2, and terms in u^3.
constexpr double InCircleBound = (10.0 + 200.0 * UnitRoundoff) * UnitRoundoff;

/// What products of four tiny differences lose by underflow: in any stage less than fifty times the
/// smallest subnormal number, 2^-1074. Differences are multiples of 2^-285, because coordinates are
/// not below LeastCoordinate; products of two are multiples of 2^-570 and lose nothing.
constexpr double InCircleUnderflow = std::numeric_limits<double>::min();

enum class Stage
{
  First,
  Wide,
  Exact
};

#ifdef BITING_COUNT_PREDICATES
void CountStage(Stage stage);
#else
inline void CountStage(Stage) {}
#endif

/// The stages after the first.
int Orient2DWidened(const Point2& a, const Point2& b, const Point2& c);

/// The stages after the first; `magnitude` is the bound of the terms' magnitudes that it computed.
int InCircleWidened(
  const Point2& a, const Point2& b, const Point2& c, const Point2& d, double magnitude);

} // namespace detail

inline int Orient2D(const Point2& a, const Point2& b, const Point2& c)
{
  detail::CountStage(detail::Stage::First);
  const double left = (a.X - c.X) * (b.Y - c.Y);
  const double right = (a.Y - c.Y) * (b.X - c.X);
  const double determinant = left - right;
  const double magnitude = std::abs(left) + std::abs(right);
  if (std::abs(determinant) > detail::OrientBound * magnitude)
  {
    return determinant > 0.0 ? 1 : -1;
  }
  return detail::Orient2DWidened(a, b, c);
}

inline int InCircle(const Point2& a, const Point2& b, const Point2& c, const Point2& d)
{
  detail::CountStage(detail::Stage::First);
  const Point2 da = a - d;
  const Point2 db = b - d;
  const Point2 dc = c - d;
  const double aa = Dot(da, da);
  const double bb = Dot(db, db);
  const double cc = Dot(dc, dc);
  const double determinant = aa * Cross(db, dc) + bb * Cross(dc, da) + cc * Cross(da, db);
  const double magnitude = aa * bb + bb * cc + cc * aa;
  if (std::abs(determinant) > detail::InCircleBound * magnitude + detail::InCircleUnderflow)
  {
    return determinant > 0.0 ? 1 : -1;
  }
  return detail::InCircleWidened(a, b, c, d, magnitude);
}

} // namespace biting

#endif
