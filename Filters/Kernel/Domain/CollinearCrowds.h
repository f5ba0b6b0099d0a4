// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingCollinearCrowds_h
#define BitingCollinearCrowds_h

#include "../Base/Problem.h"
#include "../Base/Pulse.h"
#include "Arrangement.h"

namespace biting
{

/// Replaces edges that lie along one line by the pieces between their ends, each piece once, with
/// the counts of all edges that run along it: what splitting and merging them pair by pair would
/// give, at a cost of n log n where that would be n^2 for n edges that all overlap.
///
/// Edges lie along a line that none of their ends is further from than half of Resolution, so that
/// no edge is bent by more than Resolution. Lines that are hard to tell from each other may be
/// missed: what is left to do is for the pairs.
///
/// Pieces that are drawn more than once are reported, where that is exact.
void MergeCollinearCrowds(Arrangement& arrangement, ProblemList& problems, Pulse& pulse);

} // namespace biting

#endif
