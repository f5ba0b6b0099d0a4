// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingCellChange_h
#define BitingCellChange_h

#include "BodyTets.h"

#include <array>  // for corners
#include <vector> // for lists

namespace biting
{

/// The replacement of cells of a body by a filling of the same cavity. Records in Facets get new
/// facets; all other facets of the cavity stay. In a log also a vertex that goes back.
class CellChange
{
public:
  /// The new facet of a record. Without corners (NoId): the record goes.
  struct NewFacet
  {
    Id Record;
    std::array<Id, 3> Corners;
  };

  std::vector<Id> Cells;
  std::vector<BodyTets::Tetrahedron> Filling;
  std::vector<Id> Regions; ///< of the filling
  std::vector<NewFacet> Facets;

  // Where a vertex that moved was; NoId: none moved.
  Id Vertex = NoId;
  Point3 Place{};
  double Size = 0.0;
  Id Triangle = NoId; ///< of BoundaryPlaces
  Id Piece = NoId;    ///< gone by LinePieces::Join at the vertex, which has not moved

  void Clear();
  void Apply(BodyTets& tets);

private:
  /// A facet of a cavity's border or filling: by its corners in ascending order.
  struct Side
  {
    std::array<Id, 3> Corners;
    Id Slot;   ///< NoId where there is none
    Id Record; ///< NoId where there is none
    Id Half;   ///< which of the record's two FacetSlots; NoId: both are set anew
  };

  CellChange Inverse(const BodyTets& tets) const;
  void AddWalls(BodyTets& tets);
  void AddFilling(BodyTets& tets);
  void LinkSides(BodyTets& tets);

  std::vector<Side> Sides;
  std::vector<Id> Made; ///< cells
};

} // namespace biting

#endif
