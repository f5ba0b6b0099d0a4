// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingBoundaryProtection_h
#define BitingBoundaryProtection_h

#include "BitingState.h"

namespace biting
{

/// The first phase (paper, section 3.1): a bite at each vertex of the domain, which are added as
/// the first vertices of the mesh, turned by the rule of figure 7.
void AddDomainVertices(BitingState& state);
void ProtectVertices(BitingState& state);

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
