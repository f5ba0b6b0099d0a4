// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSegmentWalk_h
#define BitingSegmentWalk_h

#include "../Base/Pulse.h"
#include "Domain.h"

namespace biting
{

/// Numbers vertices and segments of `domain` along walks over the segments, and directs boundary
/// segments so that the inside lies on their left, interfaces as they are walked.
///
/// A walk begins at the first vertex, by place, that has segments left. It goes along the one that
/// leads to the last vertex, by place, and so on until it comes to a vertex that has none left.
/// Vertices without segments come after all others, by place. Law: the numbers depend on the places
/// of vertices and what is inside only, not on the numbers before. Cost O(n log n). Where the
/// monitor asks to stop `domain` has no meaning.
void NumberAlongSegments(Domain& domain, Pulse& pulse);

} // namespace biting

#endif
