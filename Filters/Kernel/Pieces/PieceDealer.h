// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingPieceDealer_h
#define BitingPieceDealer_h

#include "../Base/IdLists.h"
#include "../Base/Ids.h"
#include "../Blocks/WholeNumbers.h"
#include "../Mesh/BitingMesh.h"

#include <vector> // for the arrays

namespace biting
{

/// The part of the collars' mesh that one member of a crew gets: its own triangles, rings of ghosts
/// around them, and the numbers of the cores of its blocks in the whole.
struct CollarPart
{
  BitingMesh Mesh; ///< vertices, triangles and Piece only
  std::vector<Id> Constraints;
  std::vector<BlockNumbers> Blocks; ///< of its own, rising
  int GhostLevels = 0;
  bool CountsAsked = false; ///< vertices that the spacing asks for (FineDrawing.h)
};

std::vector<char> PackPart(const CollarPart& part);

/// False where the bytes are none.
bool UnpackPart(const std::vector<char>& bytes, CollarPart& part);

/// The collars' mesh, and which member of a crew is to have each triangle.
struct DealtMesh
{
  const BitingMesh& Mesh; ///< its Piece has the numbers in the whole
  const std::vector<Id>& Constraints;
  const std::vector<Id>& Owners;
  Id NumberOfMembers;
};

/// Divides a mesh among members: each gets its own triangles, and those of others level by level
/// across their vertices. A vertex is owned by the first member that has a triangle at it.
class PieceDealer
{
public:
  PieceDealer(const DealtMesh& dealt, int levels);

  CollarPart Make(Id member);

private:
  using Numbers = std::vector<Id>;

  void OwnVertices();
  Numbers TrianglesOf(Id member);
  void AddLevel(std::uint8_t level, Numbers& front, Numbers& triangles);
  Numbers VerticesOf(const Numbers& triangles) const;
  void CopyVertices(Id member, const Numbers& vertices, CollarPart& part) const;
  void CopyTriangles(const Numbers& triangles, CollarPart& part) const;

  const DealtMesh& Dealt;
  int Levels;
  Numbers Owners;                        ///< of the vertices
  IdLists Uses;                          ///< triangles at each vertex
  std::vector<Numbers> Own;              ///< triangles of the members
  std::vector<std::uint8_t> LevelsSoFar; ///< of the triangles in the part that is made, one more
  Numbers NewVertices;                   ///< numbers in the part that is made
  Numbers NewTriangles;                  ///< or NoId
};

} // namespace biting

#endif
