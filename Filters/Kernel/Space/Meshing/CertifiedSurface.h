// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingCertifiedSurface_h
#define BitingCertifiedSurface_h

#include "../Biting/SurfaceBites.h"
#include "../Boundary/SurfaceBoundary.h"
#include "SurfaceMesher.h"

#include <vector> // for the arrays

// The steps common to meshing surfaces and bodies: the surface is divided and bitten, its boundary
// in the triangulation of the bites is found and certified.

namespace biting
{

struct CertifiedSurface
{
  SurfaceGround Ground;
  SurfaceBites Bites;
  BoxTree<SurfaceItem, 3> Tree; ///< of the surface
  SurfaceBoundary Boundary;     ///< without offences
  double AskedVertices = 0.0;   ///< about how many f as given asks for
  int RoundsForTurns = 0;       ///< as given: most calls of HalveAtTurns; then, those that halve f
  bool HasBalls = true;         ///< as given: the boundary has BallCenters
};

/// Fills `result`, in rounds: where certificates fail, f is lowered or turning lines are given up.
/// Where only parts differ from those of the surface (CheckWhole), f is halved at facets far from
/// it, in four rounds at most. Where edges stay too sharp for f, facets may be turned and points of
/// the surface be up to 1.44 f from the mesh, .94 f from a bite that is f / 2 from a vertex: the
/// problem LostFeatures.
/// `sides`: of each triangle of the surface, the labels of space behind and in front; empty where
/// it bounds nothing. False, with problems, where this fails or the monitor asks to stop.
bool CertifySurface(const CheckedSurface& surface, const SurfaceMesherOptions& options,
  std::vector<TriangleSides> sides, CertifiedSurface& result, ProblemList& problems,
  Monitor& monitor);

/// Whether there is no error yet. A stopped pulse is added as the error Aborted.
bool MayGoOn(ProblemList& problems, Pulse& pulse);

/// Fills the other arrays of `mesh` from its Points, Spacing and Corners. Where triangles are
/// farther than f / 4, and than twice a tolerance above 0, from the surface: LostFeatures.
void DescribeMesh(const CheckedSurface& surface, const CertifiedSurface& certified,
  const SurfaceMesherOptions& options, BitingSurface& mesh, ProblemList& problems, Pulse& pulse);

/// Whether triangles cross, or touch outside of the corners and edges that they share.
bool CrossesItself(const std::vector<Point3>& points, const std::vector<Id>& corners, Pulse& pulse);

/// A place from which differences to the points of the surface are exact. Along each axis: the
/// middle m of the surface's box, of diagonal d, where |m| > d, so that m and each point are within
/// a factor of two (Sterbenz); else 0.
Point3 OriginFor(const SurfaceMesh& mesh);

void MovePoints(std::vector<Point3>& points, const Point3& way);

/// Calls `make(surface, options, problems)`, which meshes a surface. A surface far from the origin
/// is moved to it first, where roundings are smaller; `move(mesh, way)` moves the mesh back.
template <typename Make, typename Move>
auto MeshNearOrigin(const CheckedSurface& surface, const SurfaceMesherOptions& options,
  ProblemList& problems, const Make& make, const Move& move)
{
  const Point3 origin = OriginFor(surface.Mesh);
  if (origin == Point3())
  {
    return make(surface, options, problems);
  }
  CheckedSurface moved = surface;
  MovePoints(moved.Mesh.Points, -1.0 * origin);
  SurfaceMesherOptions movedOptions = options;
  movedOptions.Origin = origin;
  movedOptions.Spacing = [&options, origin](const Point3& x)
  { return options.Spacing(x + origin); };
  ProblemList found;
  auto mesh = make(moved, movedOptions, found);
  for (ProblemGroup group : found.Groups())
  {
    for (Problem& problem : group.First)
    {
      problem.Place = problem.Place + origin;
    }
    problems.Add(group);
  }
  move(mesh, origin);
  return mesh;
}

} // namespace biting

#endif
