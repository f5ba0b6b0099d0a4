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

} // namespace biting

#endif
