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

// The parts into which segments are divided, and what their lengths forbid. A length is relative:
// in units of the mean spacing of the ends.

/// Whether the edge is a part of a segment and longer than sqrt(2): its halves are nearer to the
/// spacing then, as a ratio.
bool IsTooLongPart(const MutableMesh& mesh, Id edge);

/// Whether the edge is a part of a segment, and its collapse would leave a part that is too long.
bool LeavesLongPart(const MutableMesh& mesh, Id edge);

/// Whether the edge is a part of a segment that is too short for a split: below 1, as one vertex
/// more brings no segment nearer to the spacing whose parts are; or, if it is the whole segment, so
/// short that a half would be farther from the spacing, as a ratio.
bool LeavesShortParts(const MutableMesh& mesh, Id edge);

/// For a vertex that slides by `step` along its segment: the largest share of the step, in [0, 1],
/// after which both parts at it have lengths within [0.73, 1.37], or are no farther from that range
/// than before.
double ShareOfSlide(const MutableMesh& mesh, Id vertex, const Star& star, const Point2& step);

} // namespace biting

#endif
