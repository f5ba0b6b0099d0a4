// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingCavityCones_h
#define BitingCavityCones_h

#include "../../Base/Ids.h"
#include "TetMesh.h"

#include <array>   // for corners
#include <cstdint> // for short numbers
#include <utility> // for pairs
#include <vector>  // for scratch

namespace biting
{

/// A cavity of a mesh, and its filling by the cones from one vertex over its walls.
class CavityCones
{
public:
  /// A facet of the cavity's border as seen from inside, in the order of FacetCorners, and the
  /// facet of the cell outside.
  struct Wall
  {
    std::array<Id, 3> Corners;
    Id Outside;
  };

  std::vector<Id> Zone; ///< the cells of the cavity
  std::vector<Wall> Walls;

  void Clear()
  {
    this->Zone.clear();
    this->Walls.clear();
  }

  /// The wall that is the facet of a cell of the zone.
  void AddWall(const TetMesh& mesh, Id facet)
  {
    this->Walls.push_back(
      { { mesh.FacetCorner(facet, 0), mesh.FacetCorner(facet, 1), mesh.FacetCorner(facet, 2) },
        mesh.Twins[TetMesh::Index(facet)] });
  }

  std::vector<Id> Hidden; ///< by Fill, ascending: vertices of the zone that no wall has

  /// Replaces the cells of the zone by the cones. Links, VertexCells and the free list follow.
  /// `mayHide`: whether the zone can have vertices inside.
  /// Precondition: the walls are a sphere, which is star-shaped as seen from the vertex; the cells
  /// outside are no longer needed to find the zone. Cost linear in the walls, up to 64 corners.
  void Fill(TetMesh& mesh, Id vertex, bool mayHide);

private:
  static constexpr Id FewCorners = 64;

  void MakeCones(TetMesh& mesh, Id vertex);
  void NumberCorners(TetMesh& mesh);
  Id NumberOf(TetMesh& mesh, Id vertex);
  void HideInside(TetMesh& mesh);
  void LinkFew(TetMesh& mesh);
  void LinkMany(TetMesh& mesh);

  std::vector<Id> Cones;                       ///< cells, one a wall
  std::vector<std::array<Id, 3>> LocalCorners; ///< of walls: numbers within the cavity
  Id NumberOfLocals = 0;
  std::array<std::uint16_t, FewCorners * FewCorners> EdgeFacets{};
  std::vector<std::pair<std::pair<Id, Id>, Id>> SortedEdges; ///< and the facets of cones at them
};

} // namespace biting

#endif
