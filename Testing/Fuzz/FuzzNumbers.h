// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingFuzzNumbers_h
#define BitingFuzzNumbers_h

#include <cmath>   // for ldexp
#include <cstddef> // for size_t
#include <cstdint> // for states

namespace biting
{

/// Choices, the same on every platform: drawn from a seed (G. Steele, D. Lea, C. Flood, "Fast
/// splittable pseudorandom number generators", 2014), or from bytes that somebody else makes up.
/// Where bytes end, every choice is 0.
class FuzzNumbers
{
public:
  explicit FuzzNumbers(std::uint64_t seed)
    : State(seed)
  {
  }

  FuzzNumbers(const std::uint8_t* bytes, std::size_t size)
    : Bytes(bytes)
    , End(bytes + size)
  {
  }

  /// In [0, bound).
  int Below(int bound)
  {
    const std::uint64_t number = this->Bytes ? this->Take(bound <= 256 ? 1 : 4) : this->Next() >> 8;
    return static_cast<int>(number % static_cast<std::uint64_t>(bound));
  }

  /// In [low, high].
  int Between(int low, int high) { return low + this->Below(high - low + 1); }

  /// The rarer, the larger `bound`; never where bytes have ended.
  bool OneIn(int bound) { return this->Below(bound) == bound - 1; }

  /// In [0, 1).
  double Unit()
  {
    constexpr int Bits = 32;
    const std::uint64_t number = this->Bytes ? this->Take(4) : this->Next() >> Bits;
    return std::ldexp(static_cast<double>(number), -Bits);
  }

  /// In [2^low, 2^high), evenly by magnitude.
  double Power(int low, int high)
  {
    const int exponent = this->Between(low, high - 1);
    return std::ldexp(1.0 + this->Unit(), exponent);
  }

private:
  std::uint64_t Next()
  {
    this->State += 0x9E3779B97F4A7C15u;
    std::uint64_t z = this->State;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
  }

  std::uint64_t Take(int count)
  {
    std::uint64_t number = 0;
    for (; count > 0 && this->Bytes != this->End; --count)
    {
      number = number << 8 | *this->Bytes++;
    }
    return number;
  }

  std::uint64_t State = 0;
  const std::uint8_t* Bytes = nullptr;
  const std::uint8_t* End = nullptr;
};

} // namespace biting

#endif
