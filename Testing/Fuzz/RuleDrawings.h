// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingRuleDrawings_h
#define BitingRuleDrawings_h

#include "Oracle.h"

#include <vector> // for loops

namespace biting
{

/// Loops over each other, as closed chains, segments or faces, and a DomainRule.
struct RuleCase
{
  FuzzCase Case;
  std::vector<std::vector<Point2>> Loops;
};

/// Loops of three to six corners, some of which cross themselves; half of them on a coarse grid,
/// where they touch and run along each other.
RuleCase MakeRuleCase(FuzzNumbers& numbers);

/// The laws of DomainRule, by rays that share nothing with the kernel:
/// - the area of the mesh is that of the rule; only where that is nearly nothing there is no mesh;
/// - each triangle lies within, and all of a region in one part;
/// - each triangle has the face that its middle shows (CoveringFaces.h).
FuzzOutcome RunRuleCase(const RuleCase& ruleCase);

} // namespace biting

#endif
