// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingDistanceToSegment_h
#define BitingDistanceToSegment_h

#include "Point.h"

#include <algorithm> // for clamp

namespace biting
{

/// The place of the segment ab, whose ends may be equal, that is nearest to p.
inline Point2 NearestOnSegment(const Point2& p, const Point2& a, const Point2& b)
{
  const Point2 side = b - a;
  const double square = Dot(side, side);
  const double share = square > 0.0 ? std::clamp(Dot(p - a, side) / square, 0.0, 1.0) : 0.0;
  return a + share * side;
}

/// From p to that place.
inline double DistanceToSegment(const Point2& p, const Point2& a, const Point2& b)
{
  return Distance(p, NearestOnSegment(p, a, b));
}

} // namespace biting

#endif
