// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSegmentSides_h
#define BitingSegmentSides_h

#include "../Base/Box.h"
#include "../Base/Ids.h"
#include "../Base/Point.h"
#include "Domain.h"

namespace biting
{

/// Whether the segment of the domain passes through the box, or by it within the domain's
/// resolution and a small part of the box.
bool PassesBox(const Domain& domain, Id segment, const Box2& box);

/// Whether the segment of the domain crosses pq, whose ends are not on it, exactly. A segment's end
/// on the line pq counts as left of it, for both segments that share that end: so a point is inside
/// where an odd number of boundary segments separates it from one outside.
bool Separates(const Domain& domain, Id segment, const Point2& p, const Point2& q);

} // namespace biting

#endif
