// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingRegionEdges_h
#define BitingRegionEdges_h

#include "../Base/Ids.h"
#include "ChangedRegion.h"
#include "OldMesh.h"

#include <cstdint> // for flags
#include <vector>  // for the arrays

namespace biting
{

/// An edge that the region must keep as a line, with what lies beside it.
struct RegionEdge
{
  Id Start = NoId; ///< vertices of the region
  Id End = NoId;
  Id Mark = OldMesh::Untagged; ///< as in OldMesh
  Id LeftRegion = NoId;        ///< of the old mesh; NoId where there are no changed triangles
  Id RightRegion = NoId;
  Id RimSlot = NoId; ///< on the rim: the slot of the unchanged triangle across; NoId elsewhere
};

/// The edges that bound the region, on its rim and on the boundary of the mesh, and the marked ones
/// within it, as they are made anew: where vertices of straight parts go, an edge stands for
/// several of the old ones.
struct RegionEdges
{
  std::vector<RegionEdge> Edges;
  std::vector<std::uint8_t> IsKept; ///< one a vertex of the region: on edges, and not gone
  std::vector<std::uint8_t> IsGone; ///< on edges, and not kept; the others lie on none

  // The vertices that edge k stands for, besides its ends: Gone[GoneOffsets[k]] ..
  std::vector<Id> GoneOffsets{ 0 };
  std::vector<Id> Gone;
};

/// The largest straight pieces: vertices on them are gone, so that their lengths are those of the
/// drawing. For the limit by feature size.
RegionEdges StraightPieces(const OldMesh& mesh, const ChangedRegion& region, EdgePolicy policy);

/// The edges between the vertices that `left` marks, one flag a vertex of the region: straight
/// pieces or not, all others go. Those that may not go must be marked (EdgeSimplification.h).
RegionEdges PiecesBetween(
  const OldMesh& mesh, const ChangedRegion& region, const std::vector<std::uint8_t>& left);

/// The edges with the vertices that `spacings`, one a vertex of the region, ask for: where these
/// lie closer than the band of `rules`, those stay that divide their run well.
///
/// A vertex may go where two edges with equal tags and equal sides meet in a straight line, to
/// rounding; not on the rim, and not where it, or one of them, is fixed. Where `left` is not null
/// it says instead which must stay, as for PiecesBetween.
RegionEdges ThinnedEdges(const OldMesh& mesh, const ChangedRegion& region,
  const std::vector<double>& spacings, const KeepRules& rules, EdgePolicy policy,
  const std::vector<std::uint8_t>* left = nullptr);

} // namespace biting

#endif
