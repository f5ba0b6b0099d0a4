// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSurfaceBoundary_h
#define BitingSurfaceBoundary_h

#include "../../Base/BoxTree.h"
#include "../Biting/SurfaceBites.h"

#include <vector> // for the arrays

namespace biting
{

/// What is wrong with the boundary at a bite.
enum class BoundaryFault
{
  Missing,     ///< the bite is no vertex of the boundary
  LostPiece,   ///< the piece of a chain from it to Other is no edge of the boundary
  NonManifold, ///< the edge from it to Other has not two facets, and is no feature
  Pinched,     ///< several fans of facets meet at it
  Turned       ///< a facet at it is turned by more than 60 degrees against the surface
};

struct BoundaryOffence
{
  BoundaryFault Fault;
  Id Bite;
  Id Other = NoId;
};

/// The facets of the regular triangulation of bites that follow the surface.
struct SurfaceBoundary
{
  std::vector<Id> Corners;          ///< three bites a facet, oriented as the surface
  std::vector<Id> Triangles;        ///< of the input, where the dual edge of the facet meets it
  std::vector<TriangleSides> Sides; ///< of facets of solids: labels behind and in front

  /// Of facets: the meeting of dual edge and surface nearest to the facet. The triangulation keeps
  /// the facet as long as no centre is added in the ball about this place that is orthogonal to the
  /// corners.
  std::vector<Point3> BallCenters;
  std::vector<BoundaryOffence> Offences;
};

/// Finds the facets. For a solid (the ground has sides): those between cells whose power centres
/// have different labels, closed by construction, and without self-crossings, as facets of one
/// triangulation. For other surfaces: those whose dual edges meet the surface, or its planes beside
/// a border. Then checks all certificates (CheckBoundary) but those of the whole (CheckWhole):
/// faults are not repaired.
/// `input`: the surface that the ground divides, of which `tree` is.
/// `hasBalls`: BallCenters are wanted, of a solid.
SurfaceBoundary FindBoundary(const SurfaceMesh& input, const SurfaceGround& ground,
  const SurfaceBites& bites, const BoxTree<SurfaceItem, 3>& tree, bool hasBalls, Pulse& pulse);

} // namespace biting

#endif
