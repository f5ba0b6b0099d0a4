// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingCutDivision_h
#define BitingCutDivision_h

#include "../Base/Ids.h"
#include "../Base/Pulse.h"
#include "../Spacing/Spacing.h"
#include "CutGraph.h"

namespace biting
{

/// The wanted length of the parts of cuts.
struct CutDivision
{
  double BitingConstant = 0.0;
  double PartLength = 1.0;
  Id MostVertices = 0;
};

/// Divides all cuts, as segments of the domain are divided. A folded cut has an odd number of
/// vertices. The first, third, fifth lie half a part's length to its left, in the rows of the
/// lattice that both sides make (CutRows.h). False where more than MostVertices are needed, and
/// where the monitor wants to stop.
bool DivideCuts(const Spacing& spacing, const CutDivision& wanted, CutGraph& graph, Pulse& pulse);

} // namespace biting

#endif
