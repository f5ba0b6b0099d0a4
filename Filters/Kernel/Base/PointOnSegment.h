// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingPointOnSegment_h
#define BitingPointOnSegment_h

#include "Point.h"

namespace biting
{

/// A point of the segment ab with rounded coordinates, near a + t (b - a), t in [0, 1].
///
/// Where the coordinates have few digits left for the length of the segment (an offset of 1e8
/// sizes), rounding them turns the boundary and changes the area of the domain. There the point is
/// the one that is least off the segment of those a few ulp along it, if that is little of `room`,
/// the distance to the next points; elsewhere it is the rounded point.
Point2 PointOnSegment(const Point2& a, const Point2& b, double t, double room);

} // namespace biting

#endif
