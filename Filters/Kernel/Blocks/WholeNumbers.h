// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingWholeNumbers_h
#define BitingWholeNumbers_h

#include "../Base/Ids.h"
#include "BlockCollar.h"
#include "CutStrip.h"
#include "JoinedBlocks.h"

#include <cstdint> // for numbers in the whole
#include <vector>  // for the maps

namespace biting
{

/// Number of a vertex or triangle in a mesh of any size.
using WholeId = std::int64_t;

/// Where the vertices and triangles of one block are in the whole mesh.
struct BlockNumbers
{
  WholeId FirstVertex = 0;        ///< of the unshared vertices that are not gone
  std::vector<Id> GoneVertices;   ///< unshared vertices that relaxation along cuts removed, rising
  WholeId FirstTriangle = 0;      ///< of the triangles that are not taken
  std::vector<Id> TakenTriangles; ///< triangles of the block that strips replaced, rising
  Id FirstOrder = 0;
  std::vector<Id> Regions; ///< of its faces
};

/// The numbers of vertices and triangles in the mesh that JoinBlocks would make of all blocks with
/// their cores, without unused vertices: found from the sizes of the blocks and the changes of
/// their collars.
struct WholeNumbers
{
  std::vector<BlockNumbers> Blocks;
  std::vector<WholeId> Vertices;  ///< of the collars' mesh; NoId: unused
  std::vector<WholeId> Triangles; ///< of the collars' mesh
  WholeId NumberOfVertices = 0;   ///< of the whole
  std::vector<Id> VertexBlocks;   ///< the one block that has the vertex; NoId: shared, or new
  std::vector<Id> TriangleBlocks; ///< the block that the triangle comes from; NoId: of a strip
};

/// `joined` has the meshes of `collars`, which are empty, after `change` along the cuts.
WholeNumbers NumberWhole(
  const std::vector<BlockCollar>& collars, const JoinedMesh& joined, const StripChange& change);

/// The owner of each triangle of the collars' mesh: the member of the crew that holds the block of
/// the triangle. A triangle from a strip belongs to the first block that has one of its corners
/// alone, or else to the block of a triangle nearby, across edges.
std::vector<Id> OwnersOfTriangles(
  const Triangulation& mesh, const WholeNumbers& numbers, const std::vector<Id>& holders);

/// Whether the mesh has all `rings` rings around the vertices that triangles of different owners
/// share: no vertex of these rings is at an edge without a second triangle and a constraint.
bool HasRingsAround(const Triangulation& mesh, const std::vector<Id>& owners,
  std::size_t numberOfVertices, int rings);

/// The data of one member of a crew once all blocks are relaxed, where each block stays with the
/// member that made it. The meshes of collars are empty then.
struct KeptBlocks
{
  BlockDomains Parts;
  std::vector<BlockMesh> Meshes;    ///< of its own blocks; the others are empty
  std::vector<BlockCollar> Collars; ///< of its own blocks, and on the first member of all

  // On the first member.
  bool AreSpread = false;       ///< else it has the whole mesh
  std::vector<Id> Holders;      ///< members, of the blocks
  std::vector<bool> AreHolding; ///< of the members: they have given collars, and wait for the rest
  WholeNumbers Numbers;
  std::vector<Id> Owners; ///< members, of the triangles of the collars' mesh
};

} // namespace biting

#endif
