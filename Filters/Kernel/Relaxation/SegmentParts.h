// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSegmentParts_h
#define BitingSegmentParts_h

#include "../Base/Ids.h"
#include "../Base/Point.h"
#include "MutableMesh.h"
#include "Star.h"

namespace biting
{

// Rules for the lengths of the parts into which segments are divided. A length l is relative: in
// units of the mean spacing of the ends. Its ratio to the spacing is max(l, 1 / l).

/// Whether the edge is a part of a segment and longer than sqrt(2): then its halves have the lower
/// ratio.
bool IsTooLongPart(const MutableMesh& mesh, Id edge);

/// Whether the edge is a part of a segment, and its collapse would leave a part that is too long.
bool LeavesLongPart(const MutableMesh& mesh, Id edge);

/// Whether the edge is a part of a segment that is too short for a split: l < 1; or, where both
/// ends are fixed, l h < 1 with h the length of the shorter half, whose ratio would be larger, or
/// not MutableMesh::MayDivide.
bool LeavesShortParts(const MutableMesh& mesh, Id edge);

/// For a vertex that slides by `step` along its segment: the largest share of the step, in [0, 1],
/// after which both parts at it have lengths within [0.73, 1.37], or are no farther from that range
/// than before.
double ShareOfSlide(const MutableMesh& mesh, Id vertex, const Star& star, const Point2& step);

} // namespace biting

#endif
