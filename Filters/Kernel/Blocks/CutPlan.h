// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingCutPlan_h
#define BitingCutPlan_h

#include "../Base/Pulse.h"
#include "../Domain/Domain.h"
#include "../Domain/DomainLocator.h"
#include "../Spacing/Spacing.h"
#include "CutGraph.h"
#include "CutTree.h"
#include "NearTouches.h"

#include <cstdint> // for flags
#include <vector>  // for factors

namespace biting
{

/// Where a domain is cut.
struct CutPlan
{
  CutTree Tree;
  CutGraph Graph; ///< with undivided cuts

  /// By which factor sides are longer in a leaf than elsewhere (CutRows.h), one a node.
  std::vector<double> Stretches;

  // Of the domain, where it was cut.
  NearTouches Touches;
  std::vector<std::uint8_t> AreTouching; ///< segments that are of such a pair
};

struct CutOptions
{
  double Vertices = 0.0; ///< of the mesh, expected
  double VerticesPerBlock = 0.0;
  double SideLength = 1.0; ///< of the mesh's lattice, in units of f
};

/// Cuts the domain by a kd-tree until less than 1.5 blocks' worth of vertices are expected in each
/// part; not at all where these are less than 2 in all. Each line divides its part nearly equally,
/// in the direction and at the place where fewest vertices lie on it, and its ends are open, of
/// those at which it is good (CutLine.h). Where there is none, ends of lines are moved; where that
/// does not help the part stays whole. What nearly touches others (NearTouches.h) stays uncut.
/// Along f counts less than across, where f changes, and the direction of the first cut less than
/// the other. Lines are where lattices fit (CutRows.h). Depends on the arguments alone. Where the
/// monitor wants to stop the result has no meaning.
CutPlan PlanCuts(const Domain& domain, const DomainLocator& locator, const Spacing& spacing,
  const CutOptions& options, Pulse& pulse);

} // namespace biting

#endif
