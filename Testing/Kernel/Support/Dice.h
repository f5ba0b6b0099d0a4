// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingDice_h
#define BitingDice_h

#include <cstdint> // for the generator

namespace biting
{

/// Numbers that look random and are the same everywhere.
class Dice
{
public:
  explicit Dice(std::uint64_t seed)
    : State(seed)
  {
  }

  /// In 0 .. 2^31 - 1.
  std::uint32_t Roll()
  {
    this->State = this->State * 6364136223846793005u + 1442695040888963407u;
    return static_cast<std::uint32_t>(this->State >> 33);
  }

  /// In 0 .. bound - 1.
  int Below(int bound)
  {
    return static_cast<int>(this->Roll() % static_cast<std::uint32_t>(bound));
  }

  /// In [0, 1).
  double Unit() { return this->Roll() * 0x1p-31; }

  double Between(double low, double high) { return low + (high - low) * this->Unit(); }

private:
  std::uint64_t State;
};

} // namespace biting

#endif
