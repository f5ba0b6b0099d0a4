// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingJoinedBlocks_h
#define BitingJoinedBlocks_h

#include "../Base/Ids.h"
#include "../Base/Pulse.h"
#include "../Biting/BitingScheme.h"
#include "../Delaunay/Triangulation.h"
#include "../Domain/Domain.h"
#include "BlockDomains.h"

#include <cstdint> // for counts
#include <vector>  // for the blocks

namespace biting
{

/// The mesh of a block. The triangles refer to the vertices and edges of the bites.
struct BlockMesh
{
  BitingResult Bites;
  Triangulation Triangles;
  std::int64_t Bitten = 0; ///< vertices, before relaxation
  Id NumberOfOrders = 0;   ///< of the block, where this is a part of it (BlockCollar.h)
};

/// The first numbers of a block in the joined mesh.
struct BlockPlace
{
  Id Vertex = 0; ///< of the vertices that no other block has
  Id Order = 0;
  Id Triangle = 0;
  Id Face = 0; ///< a region of the block
};

/// The mesh of the whole domain. Cuts are no constraints of it.
struct JoinedMesh
{
  BitingResult Bites;
  Triangulation Triangles;
  std::vector<Id> NearCuts; ///< triangles at cuts, and those around them (StripParts.h), rising
  std::vector<BlockPlace> Places; ///< one a block, and one past the last
  std::vector<Id> FaceRegions;    ///< the region of each face of a block
  bool IsSound = true;            ///< false: the sides of a cut do not fit
};

/// Joins the meshes of all blocks. Vertices: those of the domain, in their order, those of cuts,
/// then those of the blocks, block by block; triangles block by block; constraints and regions as
/// in a triangulation of the whole. Bite orders go on from block to block; a vertex of several
/// blocks has the order from the first. Takes the blocks' memory. Where the monitor wants to stop
/// the result has no meaning.
JoinedMesh JoinBlocks(
  const Domain& domain, const BlockDomains& blocks, std::vector<BlockMesh> meshes, Pulse& pulse);

} // namespace biting

#endif
