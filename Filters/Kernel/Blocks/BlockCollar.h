// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingBlockCollar_h
#define BitingBlockCollar_h

#include "../Base/Ids.h"
#include "BlockDomains.h"
#include "JoinedBlocks.h"

#include <cstddef> // for numbers of blocks
#include <cstdint> // for flags
#include <vector>  // for the maps

namespace biting
{

/// What the first member of a crew needs of a block that stays with another one: what lies around
/// cuts, as far as relaxation there may reach, and all triangles at segments, at vertices of the
/// domain and at those that blocks share. The rest is the core of the block: triangles far from all
/// that, with vertices of the block's own only, on no segment.
struct BlockCollar
{
  BlockMesh Mesh;            ///< with all edges; what lies across to the core is NoId
  std::vector<Id> Vertices;  ///< of those it shares with none: which of these in the block, rising
  std::vector<Id> Triangles; ///< which in the block, rising
  Id NumberOfVertices = 0;   ///< of the block, that it shares with none
  Id NumberOfTriangles = 0;  ///< of the block
};

/// Which vertices of the graph are ends of pieces of cuts.
std::vector<std::uint8_t> VerticesOnCuts(const CutGraph& graph);

/// The triangles that are at most so many steps across edges from one at a cut, and those that are
/// of the collar anyway.
BlockCollar TakeCollar(const BlockDomain& block, const std::vector<std::uint8_t>& isOnCut,
  const BlockMesh& mesh, int steps);

/// The collars of those of all `blocks` that `numbers` names, as bytes of this machine, for another
/// process that has the same blocks: about 115 a vertex. Numbers of vertices stay 32 bits wide, as
/// they are those of a block.
std::vector<char> PackCollars(const BlockDomains& blocks, const std::vector<std::size_t>& numbers,
  const std::vector<BlockCollar>& collars);

/// Puts them where they belong. False where the bytes are none, or of other blocks; then nothing is
/// changed.
bool UnpackCollars(const std::vector<char>& bytes, const BlockDomains& blocks,
  const std::vector<std::size_t>& numbers, std::vector<BlockCollar>& collars);

} // namespace biting

#endif
