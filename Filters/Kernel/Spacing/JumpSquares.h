// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingJumpSquares_h
#define BitingJumpSquares_h

#include "../Base/Pulse.h"
#include "ConeCollector.h"
#include "TriangleInterpolator.h"

namespace biting
{

/// A gradation above this one counts as this one, as nobody sees such slopes on a part of f.
constexpr double LargestSeenGradation = 1.0;

/// Jumps by less than this share of f do not matter.
constexpr double LeastJump = 0.002;

/// Adds to `cones` the low sides of the lines along which the nearest border value of triangles
/// jumps, within `bounds`. Squares of 1/64 of the bounds, whose corners have values from two parts
/// of the border, are cut down to half of f / g, where the jump through a square is one straight
/// segment; and where jumps meet or bend, down to .03 of it, where points stand for them. After
/// 65536 squares no more are cut; segments are still straight ones, but points are lowered by what
/// f could rise across their square, to no less than a quarter. Nothing is found within a square
/// whose corners have values from one part.
/// Without meaning if the pulse stops. Cost: some twenty searches of the border for a square.
void AddJumpSquares(const TriangleInterpolator& field, const Box2& bounds, double gradation,
  ConeCollector& cones, Pulse& pulse);

} // namespace biting

#endif
