// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingDistanceToSegment_h
#define BitingDistanceToSegment_h

#include "Point.h"

#include <algorithm> // for clamp

namespace biting
{

/// The place of the segment ab, whose ends may be equal, that is nearest to p.
template <std::size_t D>
Point<D> NearestOnSegment(const Point<D>& p, const Point<D>& a, const Point<D>& b)
{
  const Point<D> side = b - a;
  const double square = Dot(side, side);
  const double share = square > 0.0 ? std::clamp(Dot(p - a, side) / square, 0.0, 1.0) : 0.0;
  return a + share * side;
}

/// From p to that place.
template <std::size_t D>
double DistanceToSegment(const Point<D>& p, const Point<D>& a, const Point<D>& b)
{
  return Distance(p, NearestOnSegment(p, a, b));
}

} // namespace biting

#endif
