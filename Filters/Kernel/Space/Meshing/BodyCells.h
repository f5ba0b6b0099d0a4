// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingBodyCells_h
#define BitingBodyCells_h

#include "../../Base/Pulse.h"
#include "../Delaunay/SpaceTriangulation.h"
#include "../Features/SurfaceGround.h"

#include <vector> // for the arrays

namespace biting
{

/// The tetrahedra of a triangulation that bodies consist of.
struct BodyCells
{
  std::vector<Id> Corners; ///< four points each, positive by Orient3D
  std::vector<Id> Twins;   ///< as of RelaxedBody
  std::vector<Id> Labels;  ///< of tetrahedra, not 0
  std::vector<Id> Lost;    ///< facets not in the triangulation; if none: with other labels beside
};

/// Labels each connected part of space between facets by the sides of the facets around it.
/// `facets`: three of the first `boundaryPoints` points each; `sides`: labels behind and in front.
/// Where facets are lost there is nothing else.
BodyCells LabelCells(SpaceTriangulation triangulation, const std::vector<Id>& facets,
  const std::vector<TriangleSides>& sides, std::size_t boundaryPoints, Pulse& pulse);

} // namespace biting

#endif
