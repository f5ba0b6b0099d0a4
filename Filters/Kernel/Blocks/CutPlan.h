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
  std::vector<std::uint8_t> AreTouching; ///< of segments: 1 where in a pair of Touches
};

struct CutOptions
{
  double Vertices = 0.0; ///< of the mesh, expected
  double VerticesPerBlock = 0.0;
  double SideLength = 1.0; ///< of the mesh's lattice, in units of f
};

/// Cuts the domain by a kd-tree until each part has less than 1.5 VerticesPerBlock expected
/// vertices. A domain with less than 2 VerticesPerBlock is not cut.
///
/// 25 lines are tried for a part in each of both directions, at places where each side has at least
/// a quarter of the vertices and lattices fit (CutRows.h). Of the good ones (CutLine.h) the
/// cheapest is taken: cost = vertices on the line, (1 + 0.3 |change of log f across|) each, + 40
/// for each end that is not open; times 2.5 where it is across the first cut. Where no line is
/// good, ends are moved; where no moved line is good either, the part stays whole. No line meets a
/// segment that nearly touches another (NearTouches.h). Depends on the arguments alone. Where the
/// monitor wants to stop the result has no meaning.
CutPlan PlanCuts(const Domain& domain, const DomainLocator& locator, const Spacing& spacing,
  const CutOptions& options, Pulse& pulse);

} // namespace biting

#endif
