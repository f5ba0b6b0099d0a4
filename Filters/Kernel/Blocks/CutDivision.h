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

/// What parts of cuts are long.
struct CutDivision
{
  double BitingConstant = 0.0;
  double PartLength = 1.0;
  Id MostVertices = 0;
};

/// Divides all cuts, as segments of the domain are. Folded ones have an odd number of vertices, of
/// which the first, third, and so on are half a part's length to the left, in rows of the lattice
/// that both sides make (CutRows.h). False where more vertices are needed than there may be, and
/// where the monitor wants to stop.
bool DivideCuts(const Spacing& spacing, const CutDivision& wanted, CutGraph& graph, Pulse& pulse);

} // namespace biting

#endif
