// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingExactOracle_h
#define BitingExactOracle_h

#include "Predicates/Predicates.h"

#include <boost/multiprecision/cpp_int.hpp> // for exact numbers to compare with

#include <algorithm> // for min, max
#include <array>     // for quadruples
#include <cmath>     // for frexp, ldexp, nextafter
#include <limits>    // for infinity

namespace predicates_test
{

using biting::Meeting;
using biting::Point2;
using Integer = boost::multiprecision::cpp_int;
using Quadruple = std::array<Point2, 4>;

// The truth, in integers.

/// All coordinates in range are multiples of 2^-LatticeBits, all doubles of 2^-FinestBits.
constexpr int LatticeBits = 285;
constexpr int FinestBits = 1074;

/// x in units of 2^-bits; it must be a multiple of that.
inline Integer Exactly(double x, int bits)
{
  int exponent = 0;
  const Integer mantissa(std::ldexp(std::frexp(x, &exponent), 53));
  const int shift = exponent - 53 + bits;
  return shift >= 0 ? Integer(mantissa << shift) : Integer(mantissa / (Integer(1) << -shift));
}

struct ExactPoint
{
  Integer X;
  Integer Y;
};

inline ExactPoint Exactly(const Point2& p)
{
  return { Exactly(p.X, LatticeBits), Exactly(p.Y, LatticeBits) };
}

inline ExactPoint operator-(const ExactPoint& p, const ExactPoint& q)
{
  return { p.X - q.X, p.Y - q.Y };
}

inline Integer Cross(const ExactPoint& p, const ExactPoint& q)
{
  return p.X * q.Y - p.Y * q.X;
}

inline Integer Dot(const ExactPoint& p, const ExactPoint& q)
{
  return p.X * q.X + p.Y * q.Y;
}

inline int TrueOrient2D(const Point2& a, const Point2& b, const Point2& c)
{
  return Cross(Exactly(b) - Exactly(a), Exactly(c) - Exactly(a)).sign();
}

inline int TrueInCircle(const Point2& a, const Point2& b, const Point2& c, const Point2& d)
{
  const ExactPoint da = Exactly(a) - Exactly(d);
  const ExactPoint db = Exactly(b) - Exactly(d);
  const ExactPoint dc = Exactly(c) - Exactly(d);
  const Integer determinant =
    Dot(da, da) * Cross(db, dc) + Dot(db, db) * Cross(dc, da) + Dot(dc, dc) * Cross(da, db);
  return determinant.sign();
}

/// How the interval [0, length] meets the one from c to d.
inline Meeting TrueMeetOnLine(const Integer& length, const Integer& c, const Integer& d)
{
  const Integer begin = std::max(Integer(0), std::min(c, d));
  const Integer end = std::min(length, std::max(c, d));
  return begin > end ? Meeting::None : begin == end ? Meeting::Endpoint : Meeting::Overlap;
}

/// A fraction whose denominator is positive.
struct Fraction
{
  Fraction(const Integer& numerator, const Integer& denominator)
    : Numerator(numerator * denominator.sign())
    , Denominator(abs(denominator))
  {
  }

  bool IsInUnitInterval() const
  {
    return this->Numerator >= 0 && this->Numerator <= this->Denominator;
  }
  bool IsZeroOrOne() const { return this->Numerator == 0 || this->Numerator == this->Denominator; }

  Integer Numerator;
  Integer Denominator;
};

/// By the parameters of the common point on both lines.
inline Meeting TrueMeet(const Quadruple& q)
{
  const ExactPoint ab = Exactly(q[1]) - Exactly(q[0]);
  const ExactPoint cd = Exactly(q[3]) - Exactly(q[2]);
  const ExactPoint ac = Exactly(q[2]) - Exactly(q[0]);
  const Integer denominator = Cross(ab, cd);
  if (denominator == 0)
  {
    const Integer c = Dot(ac, ab);
    return Cross(ac, ab) != 0 ? Meeting::None : TrueMeetOnLine(Dot(ab, ab), c, c + Dot(cd, ab));
  }
  const Fraction onAb(Cross(ac, cd), denominator);
  const Fraction onCd(Cross(ac, ab), denominator);
  if (!onAb.IsInUnitInterval() || !onCd.IsInUnitInterval())
  {
    return Meeting::None;
  }
  const int ends = (onAb.IsZeroOrOne() ? 1 : 0) + (onCd.IsZeroOrOne() ? 1 : 0);
  return ends == 2 ? Meeting::Endpoint : ends == 1 ? Meeting::Touch : Meeting::Crossing;
}

struct FractionPoint
{
  Fraction X;
  Fraction Y;
};

/// In units of 2^-LatticeBits.
inline FractionPoint TrueCrossing(const Quadruple& q)
{
  const ExactPoint a = Exactly(q[0]);
  const ExactPoint ab = Exactly(q[1]) - a;
  const ExactPoint cd = Exactly(q[3]) - Exactly(q[2]);
  const Integer denominator = Cross(ab, cd);
  const Integer numerator = Cross(Exactly(q[2]) - a, cd);
  return { Fraction(a.X * denominator + numerator * ab.X, denominator),
    Fraction(a.Y * denominator + numerator * ab.Y, denominator) };
}

inline bool IsWithinOneUlp(double value, const Fraction& truth)
{
  const double infinity = std::numeric_limits<double>::infinity();
  const Integer below = Exactly(std::nextafter(value, -infinity), FinestBits);
  const Integer above = Exactly(std::nextafter(value, infinity), FinestBits);
  const Integer scaledTruth = truth.Numerator << (FinestBits - LatticeBits);
  return below * truth.Denominator <= scaledTruth && scaledTruth <= above * truth.Denominator;
}

} // namespace predicates_test

#endif
