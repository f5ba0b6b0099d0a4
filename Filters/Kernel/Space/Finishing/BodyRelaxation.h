// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingBodyRelaxation_h
#define BitingBodyRelaxation_h

#include "../../Base/Pulse.h"
#include "../Features/SurfaceGround.h"

#include <functional> // for f
#include <vector>     // for the arrays

namespace biting
{

/// A tetrahedral mesh of a body that is relaxed. Its vertices: first corners, then those of chains,
/// then others of the boundary, then those inside.
struct RelaxedBody
{
  std::vector<Point3> Points;
  std::vector<double> Sizes;      ///< f at points
  Id NumberOfCorners = 0;         ///< vertices that stay
  Id NumberOnLines = 0;           ///< and those that slide on their chain, together
  Id NumberOnBoundary = 0;        ///< and those that slide on their patch
  std::vector<Id> BoundaryPlaces; ///< of vertices of the boundary: a triangle of the ground there

  std::vector<Id> Corners; ///< four vertices a tetrahedron, positive by Orient3D
  std::vector<Id> Twins; ///< of its facets (TetMesh): the same one beyond, or CodeOf(k) at facet k
  std::vector<Id> Regions; ///< of tetrahedra

  static Id CodeOf(Id facet) { return -2 - facet; }

  /// Three vertices each: all facets with a tetrahedron on one side only, oriented away from it;
  /// and those between different regions, once, oriented away from the lower one.
  std::vector<Id> Facets;
  std::vector<Id> FacetPlaces; ///< of facets: a triangle of the ground near it, of its patch

  /// Edges on feature lines, two vertices each: they bound the patches.
  std::vector<Id> PieceEnds;
  std::vector<Id> PieceChains; ///< of pieces; empty: all vertices on lines stay

  /// Set when it is relaxed, of vertices: their numbers before; NoId of new ones.
  std::vector<Id> Origins;
};

/// Makes its tetrahedra better: vertices of thin facets are merged; vertices move to where the
/// errors of interpolation are least (ODT, density of f), those on the boundary on the ground;
/// flips and the removal of edges take slivers away; then the vertices of the worst tetrahedra move
/// by trial, those on lines along their chains. Around angles that stay below 30 degrees also the
/// other tetrahedra are improved, vertices are merged with neighbors or inserted, on the boundary
/// too. Where that does not help, steps that make tetrahedra worse are made on trial, what is near
/// is improved, and all is taken back that does not end better. Vertices stay sorted by kind;
/// inserted ones come last of theirs.
/// Laws: no step, and no trial as a whole, makes the worst dihedral angle of the tetrahedra that it
/// changes worse, unless all stay above 35 degrees; tetrahedra stay positive, exactly; the boundary
/// stays closed, of the same topology and within its patches, as near to the ground as
/// GroundNormals says; pieces cover the chains; corners stay; regions keep their facets. A stopped
/// relaxation keeps these laws, too.
/// Target: every dihedral angle at least 30 degrees where the input's are 90 and f fits.
/// Does not depend on the number of threads.
void RelaxBody(const SurfaceGround& ground, const std::function<double(const Point3&)>& f,
  RelaxedBody& body, Pulse& pulse);

/// Flips and the removal of edges alone, for dihedral angles below 1 degree: a tetrahedron of four
/// vertices on a plane face may be positive by rounding only, and lose that when the body is moved.
void RemoveFlatTetrahedra(const SurfaceGround& ground, RelaxedBody& body, Pulse& pulse);

} // namespace biting

#endif
