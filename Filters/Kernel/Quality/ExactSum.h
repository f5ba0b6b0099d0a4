// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingExactSum_h
#define BitingExactSum_h

#include <array>   // for the digits
#include <cmath>   // for isfinite, ldexp
#include <cstdint> // for digits
#include <cstring> // for memcpy

namespace biting
{

/// A sum of numbers that are not negative, without rounding: so it is the same in whatever order,
/// and by however many, they are added up. At most 2^29 terms between two joins.
class ExactSum
{
public:
  /// The 53 bits of a term, shifted by less than a digit of 32 bits, cover at most three digits.
  void Add(double term)
  {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &term, sizeof bits);
    const std::uint64_t exponent = bits >> 52;
    if (exponent >= 2047)
    {
      this->Infinite += term;
      return;
    }
    const std::uint64_t fraction = bits & ((std::uint64_t{ 1 } << 52) - 1);
    const std::uint64_t mantissa = exponent == 0 ? fraction : fraction | (std::uint64_t{ 1 } << 52);
    const std::uint64_t place = exponent == 0 ? 1 : exponent;
    const std::uint64_t low = (mantissa & Digit) << place % 32;
    const std::uint64_t high = (mantissa >> 32) << place % 32;
    this->Digits[place / 32] += low & Digit;
    this->Digits[place / 32 + 1] += (low >> 32) + (high & Digit);
    this->Digits[place / 32 + 2] += high >> 32;
  }

  void Join(const ExactSum& other)
  {
    this->Infinite += other.Infinite;
    for (std::size_t k = 0; k < this->Digits.size(); ++k)
    {
      this->Digits[k] += other.Digits[k];
    }
    this->Carry();
  }

  /// Rounded in the same way whatever the terms were: from the first three digits that are not 0.
  double Value() const
  {
    ExactSum sum = *this;
    sum.Carry();
    std::size_t first = sum.Digits.size() - 1;
    while (first > 2 && sum.Digits[first] == 0)
    {
      --first;
    }
    double value = 0.0;
    for (std::size_t k = first - 2; k <= first; ++k)
    {
      // Digit 0 counts 2^-1075, as exponents begin with 1 at 2^-1074.
      value += std::ldexp(static_cast<double>(sum.Digits[k]), static_cast<int>(32 * k) - 1075);
    }
    return this->Infinite + value;
  }

private:
  static constexpr std::uint64_t Digit = 0xFFFFFFFFu;

  void Carry()
  {
    std::uint64_t carry = 0;
    for (std::uint64_t& digit : this->Digits)
    {
      digit += carry;
      carry = digit >> 32;
      digit &= Digit;
    }
  }

  std::array<std::uint64_t, 68> Digits{}; ///< to the base 2^32, the lowest first
  double Infinite = 0.0;                  ///< terms that are no finite numbers, or negative
};

} // namespace biting

#endif
