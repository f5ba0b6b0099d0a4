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

/// The halo of a block: the part that the first member of a crew needs, where the block stays with
/// another member. It has the triangles around cuts, as far as relaxation along the cuts may reach,
/// and all triangles at segments, at vertices of the domain and at vertices that blocks share. The
/// rest is the core of the block. Its triangles have vertices of this block only, none on a
/// segment.
struct BlockCollar
{
  BlockMesh Mesh; ///< with all edges; what lies across to the core is NoId
  std::vector<Id>
    Vertices; ///< numbers in the block of the collar's vertices that no other block has, rising
  std::vector<Id> Triangles; ///< numbers in the block of the collar's triangles, rising
  Id NumberOfVertices = 0;   ///< of the block, without those that it shares
  Id NumberOfTriangles = 0;  ///< of the block
};

/// Which vertices of the graph are ends of pieces of cuts.
std::vector<std::uint8_t> VerticesOnCuts(const CutGraph& graph);

/// The collar of a block, with the triangles at most `steps` across edges from one at a cut.
BlockCollar TakeCollar(const BlockDomain& block, const std::vector<std::uint8_t>& isOnCut,
  const BlockMesh& mesh, int steps);

/// The collars of those of all `blocks` that `numbers` names, as bytes of this machine, for another
/// process that has the same blocks: about 115 a vertex. Numbers of vertices stay 32 bits wide, as
/// they are those of a block.
std::vector<char> PackCollars(const BlockDomains& blocks, const std::vector<std::size_t>& numbers,
  const std::vector<BlockCollar>& collars);

/// Puts packed collars where they belong. False, and nothing is changed, where the bytes are no
/// packed collars or those of other blocks.
bool UnpackCollars(const std::vector<char>& bytes, const BlockDomains& blocks,
  const std::vector<std::size_t>& numbers, std::vector<BlockCollar>& collars);

} // namespace biting

#endif
