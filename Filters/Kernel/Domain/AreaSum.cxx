// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "AreaSum.h"

namespace biting
{

namespace
{

/// A value and what its rounding lost (T. J. Dekker, "A floating-point technique for extending the
/// available precision", 1971).
struct RoundedValue
{
  double Value = 0.0;
  double Lost = 0.0;
};

RoundedValue ExactSum(double a, double b)
{
  const double sum = a + b;
  const double partOfB = sum - a;
  return { sum, (a - (sum - partOfB)) + (b - partOfB) };
}

/// The upper and lower 26 bits of a double.
RoundedValue Halves(double a)
{
  constexpr double Splitter = 134217729.0; // 2^27 + 1
  const double scaled = Splitter * a;
  const double upper = scaled - (scaled - a);
  return { upper, a - upper };
}

RoundedValue ExactProduct(double a, double b)
{
  const double product = a * b;
  const RoundedValue p = Halves(a);
  const RoundedValue q = Halves(b);
  const double upper = p.Value * q.Value - product;
  return { product, ((upper + p.Value * q.Lost) + p.Lost * q.Value) + p.Lost * q.Lost };
}

} // namespace

void AreaSum::Add(const Point2& start, const Point2& end)
{
  const RoundedValue startX = ExactSum(start.X, -this->Reference.X);
  const RoundedValue startY = ExactSum(start.Y, -this->Reference.Y);
  const RoundedValue endX = ExactSum(end.X, -this->Reference.X);
  const RoundedValue endY = ExactSum(end.Y, -this->Reference.Y);
  this->AddProduct(startX.Value, endY.Value);
  this->AddProduct(-startY.Value, endX.Value);
  this->Error += startX.Value * endY.Lost + startX.Lost * endY.Value;
  this->Error -= startY.Value * endX.Lost + startY.Lost * endX.Value;
}

void AreaSum::AddMagnitude(const AreaSum& other)
{
  const double sign = other.Area() < 0.0 ? -1.0 : 1.0;
  this->AddTerm(sign * other.Sum);
  this->Error += sign * other.Error;
}

void AreaSum::AddProduct(double a, double b)
{
  const RoundedValue product = ExactProduct(a, b);
  this->AddTerm(product.Value);
  this->Error += product.Lost;
}

void AreaSum::AddTerm(double term)
{
  const RoundedValue sum = ExactSum(this->Sum, term);
  this->Sum = sum.Value;
  this->Error += sum.Lost;
}

} // namespace biting
