// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingRingCover_h
#define BitingRingCover_h

#include "../Base/Ids.h"
#include "../Base/Point2.h"
#include "Bites.h"

#include <algorithm> // for max
#include <array>     // for the rays
#include <cmath>     // for cos, sin

namespace biting
{

/// Tells of most bites whose outline is covered that it is, at a fraction of the cost of
/// OutlineCover: the outline lies in a ring, between the circles in and about the bite, and each
/// other bite counts as the circle in it. The ring is cut by rays: of the sector between two of
/// them, a disc covers all or counts for nothing. In a triangular lattice six discs cover all
/// sectors. Law: where IsFull, each place of the outline lies in another bite.
class RingCover
{
public:
  RingCover(const Bites& bites, Id bite)
    : All(bites)
    , Center(bites.Centers[bite])
    , PerHalfWidth(1.0 / bites.HalfWidths[bite])
    , Outer(bites.IsCircle(bite) ? 1.0f : RootOfTwo)
  {
  }

  void Cover(Id other);
  bool IsFull() const;

private:
  static constexpr int NumberOfRays = 24;
  static constexpr float RootOfTwo = 1.4142137f; // rounded up
  // Of squares of lengths, in half-widths: more than the rounding of a level to single precision.
  static constexpr float Margin = 4e-6f;

  struct Fan
  {
    std::array<float, NumberOfRays> X;
    std::array<float, NumberOfRays> Y;
    std::array<float, NumberOfRays> NextX;
    std::array<float, NumberOfRays> NextY;
  };

  static Fan MakeRays();

  const Bites& All;
  Point2 Center;
  double PerHalfWidth;
  float Outer;                             ///< radius of the ring, whose inner one is 1
  std::array<int, NumberOfRays> Covered{}; ///< the sectors between each ray and the next
};

inline RingCover::Fan RingCover::MakeRays()
{
  constexpr double Step = 2.0 * 3.14159265358979323846 / NumberOfRays;
  Fan rays;
  for (int k = 0; k < NumberOfRays; ++k)
  {
    rays.X[k] = static_cast<float>(std::cos(k * Step));
    rays.Y[k] = static_cast<float>(std::sin(k * Step));
    rays.NextX[k] = static_cast<float>(std::cos((k + 1) % NumberOfRays * Step));
    rays.NextY[k] = static_cast<float>(std::sin((k + 1) % NumberOfRays * Step));
  }
  return rays;
}

// A ray runs inside the disc about c with radius h from 1 to Outer where both places r are:
// r^2 + |c|^2 - h^2 < 2 r (ray . c). Rays that do so point into a cone of less than half a turn.
inline void RingCover::Cover(Id other)
{
  static const Fan Rays = MakeRays();
  const Point2 offset = this->PerHalfWidth * (this->All.Centers[other] - this->Center);
  const float x = static_cast<float>(offset.X);
  const float y = static_cast<float>(offset.Y);
  const float reach = static_cast<float>(this->PerHalfWidth * this->All.HalfWidths[other]);
  const float away = x * x + y * y;
  const float rest = away - reach * reach + Margin * (1.0f + away + reach * reach);
  const float atOuter = 0.5f * (this->Outer + rest / this->Outer);
  const float level = std::max({ 0.5f * (1.0f + rest), atOuter, 0.0f });
  for (int k = 0; k < NumberOfRays; ++k)
  {
    const float first = Rays.X[k] * x + Rays.Y[k] * y;
    const float last = Rays.NextX[k] * x + Rays.NextY[k] * y;
    this->Covered[k] |= (first < last ? first : last) > level ? 1 : 0;
  }
}

inline bool RingCover::IsFull() const
{
  int isFull = 1;
  for (const int isCovered : this->Covered)
  {
    isFull &= isCovered;
  }
  return isFull != 0;
}

} // namespace biting

#endif
