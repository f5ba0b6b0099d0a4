// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingCellChange_h
#define BitingCellChange_h

#include "BodyTets.h"

#include <array>  // for corners
#include <vector> // for lists

namespace biting
{

/// Cells of a body, and what fills the space that they took. Facets of the records named are not
/// facets any more; others stay.
class CellChange
{
public:
  /// A facet that takes the place of that of a record.
  struct NewFacet
  {
    Id Record;
    std::array<Id, 3> Corners;
  };

  std::vector<Id> Cells;
  std::vector<BodyTets::Tetrahedron> Filling;
  std::vector<Id> Regions; ///< of the filling
  std::vector<NewFacet> Facets;

  void Clear();
  void Apply(BodyTets& tets);

private:
  /// A facet of a cavity's border or filling: by its corners in ascending order.
  struct Side
  {
    std::array<Id, 3> Corners;
    Id Slot;   ///< NoId where there is none
    Id Record; ///< NoId where there is none
    Id Half;   ///< of the record that this is; NoId: both are anew
  };

  void AddWalls(BodyTets& tets);
  void AddFilling(BodyTets& tets);
  void LinkSides(BodyTets& tets);

  std::vector<Side> Sides;
};

} // namespace biting

#endif
