// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingEdgeProtection_h
#define BitingEdgeProtection_h

#include "BitingState.h"

namespace biting
{

/// The second phase (paper, section 3.1): bites on the segments of the domain, aligned with them,
/// at vertices spread by equal integrals of 1/f. Where biting stops before, the segments that are
/// left stay undivided.
void ProtectEdges(BitingState& state);

/// The same of segments that must stay one edge: squares that make no vertex, one for each part of
/// a segment. Their size follows f as that of bites does, so that they hide little of what is
/// behind the segments, and the front rises from the ends of a long one as f does.
void ShieldEdges(BitingState& state);

} // namespace biting

#endif
