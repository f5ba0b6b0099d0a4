// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingBlockDomains_h
#define BitingBlockDomains_h

#include "../Base/Ids.h"
#include "../Base/Monitor.h"
#include "../Base/Pulse.h"
#include "../Domain/Domain.h"
#include "../Spacing/Spacing.h"
#include "CutGraph.h"
#include "CutPlan.h"

#include <cstddef> // for numbers of blocks
#include <cstdint> // for flags
#include <vector>  // for the maps

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

/// A part of a domain as a domain of its own. Its cuts are boundary, and preserved: parts of the
/// length that the mesh wants, with vertices that both sides share.
struct BlockDomain
{
  Domain Geometry;
  std::vector<Id> Vertices; ///< of the graph, one a vertex of the geometry
  std::vector<Id> Pieces;   ///< of the graph, one a segment of the geometry
  double ExpectedVertices = 0.0;
  double Stretch = 1.0; ///< of inner edges (CutRows.h)
  Id Leaf = NoId;       ///< of the tree, that it lies in: the first one
};

struct BlockDomains
{
  CutGraph Graph; ///< with divided cuts
  std::vector<BlockDomain> Blocks;
  std::vector<std::uint8_t> AreTouching; ///< segments of the domain (CutPlan.h)
};

/// Divides the cuts, and the domain along them. A block is a face enclosed by cuts, or the union of
/// several: of those in one leaf of the tree, and of leaves with segments that nearly touch each
/// other (NearTouches.h). No blocks where there are less than two, where parts of cuts would meet
/// by rounding, and where the monitor wants to stop.
BlockDomains MakeBlockDomains(const Domain& domain, const Spacing& spacing, const CutPlan& plan,
  const CutDivision& division, Monitor& monitor);

/// The blocks of each of `members`, as numbers: `dealtLeaves` (DealLeaves) says to whom each leaf
/// goes, and with it the blocks that lie there. A member's share begins with its largest block:
/// while that is at work, other threads do several of the others. Depends on the blocks alone.
std::vector<std::vector<std::size_t>> ShareBlocks(
  const std::vector<BlockDomain>& blocks, const std::vector<Id>& dealtLeaves, std::size_t members);

} // namespace biting

#endif
