// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingExpansion_h
#define BitingExpansion_h

#include "DoubleDouble.h"

#include <algorithm> // for copy_n

namespace biting
{

/// An exact number: the sum of up to Capacity doubles (Shewchuk 1997, section 2).
///
/// Invariant: the components are not zero, grow in magnitude, and do not overlap (each is smaller
/// than the last set bit of the next). Hence the last one has the sign of the number, and few-bit
/// numbers have one component, whatever they were computed from.
/// Everything is made by Grow (his theorem 10, which keeps the invariant) and by Compress (his
/// theorem 23, which packs the bits into few components). Both cost time linear in the size.
/// Exact as long as nothing overflows or underflows.
template <int Capacity>
class Expansion
{
public:
  Expansion() = default;

  explicit Expansion(const DoubleDouble& value)
  {
    static_assert(Capacity >= 2, "a double-double has two components");
    this->Append(value.Low);
    this->Append(value.High);
  }

  template <int Other>
  explicit Expansion(const Expansion<Other>& other)
    : Count(other.Size())
  {
    static_assert(Capacity >= Other, "too small for the other");
    std::copy_n(other.begin(), other.Size(), this->Components);
  }

  int Size() const { return this->Count; }
  const double* begin() const { return this->Components; }
  const double* end() const { return this->Components + this->Count; }

  int Sign() const
  {
    const double last = this->Count > 0 ? this->Components[this->Count - 1] : 0.0;
    return (last > 0.0) - (last < 0.0);
  }

  /// The number, rounded to about 106 bits. Compress before.
  DoubleDouble Rounded() const
  {
    DoubleDouble sum;
    for (const double component : *this)
    {
      sum = TwoSum(component, sum.High);
    }
    return sum;
  }

  /// Adds one double.
  void Grow(double value)
  {
    const int oldCount = this->Count;
    this->Count = 0;
    for (int i = 0; i < oldCount; ++i)
    {
      const DoubleDouble sum = TwoSum(value, this->Components[i]);
      this->Append(sum.Low);
      value = sum.High;
    }
    this->Append(value);
  }

  /// Rewrites the components so that each holds as many bits as it can.
  void Compress()
  {
    if (this->Count > 2)
    {
      this->CompressUpwards(this->CompressDownwards());
    }
  }

private:
  void Append(double component)
  {
    if (component != 0.0)
    {
      this->Components[this->Count++] = component;
    }
  }

  /// From the largest to the smallest; leaves the packed ones at the end of the array, says where.
  int CompressDownwards()
  {
    int first = this->Count - 1;
    double carry = this->Components[first];
    for (int i = this->Count - 2; i >= 0; --i)
    {
      const DoubleDouble sum = TwoSum(carry, this->Components[i]);
      carry = sum.High;
      if (sum.Low != 0.0)
      {
        this->Components[first--] = sum.High;
        carry = sum.Low;
      }
    }
    this->Components[first] = carry;
    return first;
  }

  /// From the smallest, at `first`, to the largest, moving all to the front of the array.
  void CompressUpwards(int first)
  {
    const int oldCount = this->Count;
    double carry = this->Components[first];
    this->Count = 0;
    for (int i = first + 1; i < oldCount; ++i)
    {
      const DoubleDouble sum = TwoSum(this->Components[i], carry);
      this->Append(sum.Low);
      carry = sum.High;
    }
    this->Append(carry);
  }

  int Count = 0;
  double Components[Capacity];
};

template <int N, int M>
Expansion<N + M> operator+(const Expansion<N>& x, const Expansion<M>& y)
{
  Expansion<N + M> sum(x);
  for (const double component : y)
  {
    sum.Grow(component);
  }
  sum.Compress();
  return sum;
}

template <int N, int M>
Expansion<N + M> operator-(const Expansion<N>& x, const Expansion<M>& y)
{
  Expansion<N + M> difference(x);
  for (const double component : y)
  {
    difference.Grow(-component);
  }
  difference.Compress();
  return difference;
}

template <int N, int M>
Expansion<2 * N * M> operator*(const Expansion<N>& x, const Expansion<M>& y)
{
  Expansion<2 * N * M> product;
  for (const double factor : y)
  {
    for (const double component : x)
    {
      const DoubleDouble part = TwoProduct(factor, component);
      product.Grow(part.Low);
      product.Grow(part.High);
    }
    product.Compress();
  }
  return product;
}

} // namespace biting

#endif
