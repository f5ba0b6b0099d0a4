// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingDoubleDouble_h
#define BitingDoubleDouble_h

#include <cfloat> // for FLT_EVAL_METHOD
#include <cmath>  // for fma

#ifdef __FAST_MATH__
#error "The predicates need IEEE arithmetic: compile without -ffast-math."
#endif
static_assert(FLT_EVAL_METHOD == 0, "the predicates need doubles that are rounded as doubles");

namespace biting
{

/// The unevaluated sum High + Low, where |Low| <= u |High| and u = 2^-53: about 106 bits.
///
/// TwoSum, TwoDifference and TwoProduct are exact (Knuth; Dekker and Veltkamp). The operators are
/// short forms whose errors are bounded by the magnitudes of the operands, not by that of the
/// result; see each. They suit determinants, whose filters are bounded in just that way.
struct DoubleDouble
{
  double High = 0.0;
  double Low = 0.0;
};

/// Exactly a + b.
inline DoubleDouble TwoSum(double a, double b)
{
  const double sum = a + b;
  const double fromB = sum - a;
  const double fromA = sum - fromB;
  return { sum, (a - fromA) + (b - fromB) };
}

/// Exactly a - b.
inline DoubleDouble TwoDifference(double a, double b)
{
  return TwoSum(a, -b);
}

/// Exactly a + b, provided that |a| >= |b| or a is zero.
inline DoubleDouble FastTwoSum(double a, double b)
{
  const double sum = a + b;
  return { sum, b - (sum - a) };
}

/// The upper and lower half of the bits of a.
inline DoubleDouble Split(double a)
{
  constexpr double Splitter = 134217729.0; // 2^27 + 1: leaves 26 bits to each half
  const double scaled = Splitter * a;
  const double high = scaled - (scaled - a);
  return { high, a - high };
}

/// Exactly a * b.
inline DoubleDouble TwoProduct(double a, double b)
{
  const double product = a * b;
#ifdef FP_FAST_FMA
  return { product, std::fma(a, b, -product) };
#else
  const DoubleDouble x = Split(a);
  const DoubleDouble y = Split(b);
  const double rest = ((x.High * y.High - product) + x.High * y.Low) + x.Low * y.High;
  return { product, rest + x.Low * y.Low };
#endif
}

inline DoubleDouble operator-(const DoubleDouble& x)
{
  return { -x.High, -x.Low };
}

/// x + y, off by less than 4u^2 (|x| + |y|): with m = |x.High| + |y.High|, the sum of the low
/// parts is at most um and rounded by u^2 m; with the low part of the sum it is at most 2um and
/// rounded by 2u^2 m; 3u^2 m and terms in u^3.
inline DoubleDouble operator+(const DoubleDouble& x, const DoubleDouble& y)
{
  const DoubleDouble sum = TwoSum(x.High, y.High);
  return TwoSum(sum.High, sum.Low + (x.Low + y.Low));
}

inline DoubleDouble operator-(const DoubleDouble& x, const DoubleDouble& y)
{
  return x + -y;
}

/// x * y, off by less than 9u^2 |x y|: with m = |x.High * y.High|, Low * Low is left out, u^2 m;
/// the two mixed products, each at most um, are rounded by u^2 m each and their sum by 2u^2 m; that
/// and the low part of the product are at most 3um and rounded by 3u^2 m; 8u^2 m and terms in u^3.
inline DoubleDouble operator*(const DoubleDouble& x, const DoubleDouble& y)
{
  const DoubleDouble product = TwoProduct(x.High, y.High);
  return FastTwoSum(product.High, product.Low + (x.High * y.Low + x.Low * y.High));
}

/// x / y rounded to a double, off by little more than half a unit in the last place.
inline double Quotient(const DoubleDouble& x, const DoubleDouble& y)
{
  const double quotient = x.High / y.High;
  const DoubleDouble rest = x - DoubleDouble{ quotient, 0.0 } * y;
  return quotient + rest.High / y.High;
}

} // namespace biting

#endif
