// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingWholeNumbers_h
#define BitingWholeNumbers_h

#include "Base/Point.h"

#include <boost/multiprecision/cpp_int.hpp> // for whole numbers of any length

#include <algorithm> // for min
#include <cmath>     // for frexp, ldexp
#include <cstdint>   // for mantissas

namespace biting
{

using Whole = boost::multiprecision::cpp_int;

constexpr int MantissaBits = 53;
constexpr int GreatestUnit = 2000; ///< of 0, which every unit divides

struct WholePoint
{
  Whole X;
  Whole Y;
};

inline WholePoint operator-(const WholePoint& a, const WholePoint& b)
{
  return { a.X - b.X, a.Y - b.Y };
}

inline Whole Cross(const WholePoint& a, const WholePoint& b)
{
  return a.X * b.Y - a.Y * b.X;
}

/// The exponent of a power of two that divides the coordinate.
inline int UnitOf(double coordinate)
{
  int exponent = 0;
  std::frexp(coordinate, &exponent);
  return coordinate == 0.0 ? GreatestUnit : exponent - MantissaBits;
}

inline int UnitOf(const Point2& p)
{
  return std::min(UnitOf(p.X), UnitOf(p.Y));
}

/// The coordinate in units of 2^unit, which divides it.
inline Whole ToWhole(double coordinate, int unit)
{
  int exponent = 0;
  const double mantissa = std::frexp(coordinate, &exponent);
  const Whole digits(static_cast<std::int64_t>(std::ldexp(mantissa, MantissaBits)));
  return coordinate == 0.0 ? Whole(0) : Whole(digits << (exponent - MantissaBits - unit));
}

inline WholePoint ToWhole(const Point2& p, int unit)
{
  return { ToWhole(p.X, unit), ToWhole(p.Y, unit) };
}

} // namespace biting

#endif
