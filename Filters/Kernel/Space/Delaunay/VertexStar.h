// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingVertexStar_h
#define BitingVertexStar_h

#include "../../Base/Ids.h"
#include "TetMesh.h"

#include <array>  // for corners
#include <vector> // for lists

namespace biting
{

/// The cells around a vertex that is to be removed, and how they are replaced
/// (O. Devillers, M. Teillaud, 2011).
class VertexStar
{
public:
  VertexStar(const TetMesh& mesh, Id vertex);

  std::vector<Id> Link; ///< the neighbours of the vertex, in ascending order

  /// A corner of a tetrahedron that shares a triangle with the star and does not belong to it;
  /// NoId if the star has all tetrahedra.
  Id Beyond = NoId;

  /// Replaces the star by the cells of `part` that lie in it; `part` is the regular triangulation
  /// of `vertices`, which are the link and may be more: each triangle of the link is in it.
  void Fill(TetMesh& mesh, const TetMesh& part, const std::vector<Id>& vertices) const;

private:
  /// A facet opposite the vertex.
  struct Wall
  {
    std::array<Id, 3> Corners; ///< in ascending order
    bool IsOdd;                ///< that order against the one of FacetCorners
    Id Outside;                ///< its twin
  };

  static Wall WallOf(std::array<Id, 3> corners, Id outside);

  /// The wall that is facet k of the cell, seen from the same side; null if there is none.
  const Wall* FindWall(const std::array<Id, 4>& corners, int k) const;

  Id Vertex;
  std::vector<Id> Cells;   ///< in ascending order
  std::vector<Wall> Walls; ///< by their corners
};

} // namespace biting

#endif
