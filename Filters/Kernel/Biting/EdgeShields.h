// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingEdgeShields_h
#define BitingEdgeShields_h

#include "BitingState.h"

namespace biting
{

/// The second phase where no segment is divided: instead of vertices on the segments, squares that
/// make none, one for each part of a segment. Their size follows f as that of bites does, so that
/// they hide little of what is behind the segments, and the front rises from the ends of a long one
/// as f does.
void ShieldEdges(BitingState& state);

} // namespace biting

#endif
