// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingCheckSums_h
#define BitingCheckSums_h

#include "../Base/Point.h"
#include "../Predicates/CompensatedSum.h"

#include <algorithm> // for min
#include <cmath>     // for abs
#include <cstddef>   // for slots
#include <cstdint>   // for counts
#include <limits>    // for none
#include <vector>    // for the boundary

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

/// Of vertices.
struct UseSum
{
  std::int64_t Inner = 0;
  FirstDefect Unused;

  void Join(const UseSum& other)
  {
    this->Inner += other.Inner;
    this->Unused.Join(other.Unused);
  }
};

/// Of what lies across edges.
struct LinkSum
{
  FirstDefect Wrong;
  FirstDefect Bent; ///< edges that are not locally Delaunay
  std::int64_t Unanswered = 0;
  std::vector<std::size_t> BoundarySlots;

  void Join(const LinkSum& other)
  {
    this->Wrong.Join(other.Wrong);
    this->Bent.Join(other.Bent);
    this->Unanswered += other.Unanswered;
    this->BoundarySlots.insert(
      this->BoundarySlots.end(), other.BoundarySlots.begin(), other.BoundarySlots.end());
  }
};

/// Of triangles, and of what lies across their edges.
struct TriangleSum
{
  FirstDefect Invalid; ///< triangles with ids out of range: the sums leave them out
  TurnSum Turns;
  LinkSum Links;

  void Join(const TriangleSum& other)
  {
    this->Invalid.Join(other.Invalid);
    this->Turns.Join(other.Turns);
    this->Links.Join(other.Links);
  }
};

} // namespace biting

#endif
