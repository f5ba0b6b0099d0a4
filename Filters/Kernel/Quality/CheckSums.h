// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingCheckSums_h
#define BitingCheckSums_h

#include "../Base/Point.h"
#include "../Predicates/CompensatedSum.h"

#include <algorithm> // for min
#include <cmath>     // for abs
#include <cstddef>   // for slots
#include <limits>    // for none

// What the check of a mesh adds up over parts of it, for SumAtOnce.

namespace biting
{

/// The first slot that is not as it must be.
struct FirstDefect
{
  static constexpr std::size_t None = std::numeric_limits<std::size_t>::max();
  std::size_t Slot = None;

  bool Exists() const { return this->Slot != None; }
  void Add(std::size_t slot, bool isDefect)
  {
    if (isDefect)
    {
      this->Slot = std::min(this->Slot, slot);
    }
  }
  void Join(const FirstDefect& other) { this->Slot = std::min(this->Slot, other.Slot); }
};

/// Of triangles.
struct TurnSum
{
  FirstDefect Wrong;
  CompensatedSum DoubledArea;
  double AreaMagnitude = 0.0; ///< sum of the terms of DoubledArea, all taken positive

  void AddArea(const Point2& a, const Point2& b, const Point2& c)
  {
    const Point2 u = b - a;
    const Point2 v = c - a;
    this->DoubledArea.Add(u.X * v.Y - u.Y * v.X);
    this->AreaMagnitude += std::abs(u.X * v.Y) + std::abs(u.Y * v.X);
  }

  void Join(const TurnSum& other)
  {
    this->Wrong.Join(other.Wrong);
    this->DoubledArea.Join(other.DoubledArea);
    this->AreaMagnitude += other.AreaMagnitude;
  }
};

} // namespace biting

#endif
