// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingTrialSteps_h
#define BitingTrialSteps_h

#include "../../Base/Point.h"

namespace biting
{

/// Compass search: calls goes(step) for 14 steps, towards a cube's faces and corners, until one
/// returns true; then anew, with half the length if none did: from `longest` down to `shortest`.
template <typename Goes>
void TryInSteps(double longest, double shortest, const Goes& goes)
{
  constexpr double Corner = 0.5773502691896258; // 1 / sqrt(3)
  static constexpr Point3 Directions[7] = { { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, { 0.0, 0.0, 1.0 },
    { Corner, Corner, Corner }, { -Corner, Corner, Corner }, { Corner, -Corner, Corner },
    { Corner, Corner, -Corner } };
  double length = longest;
  while (length > shortest)
  {
    bool hasGone = false;
    for (int k = 0; k < 14 && !hasGone; ++k)
    {
      hasGone = goes((k % 2 == 0 ? length : -length) * Directions[k / 2]);
    }
    length *= hasGone ? 1.0 : 0.5;
  }
}

} // namespace biting

#endif
