// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingCertifiedSurface_h
#define BitingCertifiedSurface_h

#include "../Biting/SurfaceBites.h"
#include "../Boundary/SurfaceBoundary.h"
#include "SurfaceMesher.h"

#include <functional> // for f
#include <vector>     // for the arrays

// What meshing a surface and meshing a body have in common: the surface divided, bitten, and its
// boundary in the triangulation of the bites, certified.

namespace biting
{

struct CertifiedSurface
{
  SurfaceGround Ground;
  std::function<double(const Point3&)> Spacing; ///< f as given, or what stands for it
  SurfaceBites Bites;
  BoxTree<SurfaceItem, 3> Tree; ///< of the ground
  SurfaceBoundary Boundary;     ///< without offences
};

/// Finds it, in rounds: where certificates fail, f is lowered or turning lines are given up. Where
/// edges stay too sharp for f, facets may be turned and points of the surface be up to f / 2 from
/// the mesh: told as LostFeatures.
/// `sides`: of each triangle of the surface, the labels of space behind and in front; empty where
/// it bounds nothing. False where it cannot be or the monitor asks to stop: problems are told.
bool CertifySurface(const CheckedSurface& surface, const SurfaceMesherOptions& options,
  std::vector<TriangleSides> sides, CertifiedSurface& result, ProblemList& problems,
  Monitor& monitor);

/// Whether nothing was refused up to now; that the pulse has stopped is told.
bool MayGoOn(ProblemList& problems, Pulse& pulse);

/// All of the mesh that Points, Spacing and Corners leave open.
void DescribeMesh(const CertifiedSurface& certified, const SurfaceMesherOptions& options,
  BitingSurface& mesh, Pulse& pulse);

/// Of facets of the boundary, the triangles of CheckedSurface::Mesh below.
std::vector<Id> TrianglesBelow(const CertifiedSurface& certified);

/// Whether triangles cross or touch beside what they share.
bool CrossesItself(const std::vector<Point3>& points, const std::vector<Id>& corners, Pulse& pulse);

/// A place near the middle of the surface from which differences to its points are exact: along
/// axes on which the surface is farther from the origin than its size, the middle, so that points
/// and it are within a factor of two (Sterbenz); else 0.
Point3 OriginFor(const SurfaceMesh& mesh);

void MovePoints(std::vector<Point3>& points, const Point3& way);

/// Calls `make(surface, options, problems)`, which meshes a surface. One far from the origin is
/// meshed near it, where what is computed has smaller roundings; `move(mesh, way)` takes it back.
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
  if (options.Spacing)
  {
    movedOptions.Spacing = [&options, origin](const Point3& x)
    { return options.Spacing(x + origin); };
  }
  ProblemList found;
  auto mesh = make(moved, movedOptions, found);
  for (const ProblemGroup& group : found.Groups())
  {
    for (Problem problem : group.First)
    {
      problem.Place = problem.Place + origin;
      problems.Add(problem);
    }
  }
  move(mesh, origin);
  return mesh;
}

} // namespace biting

#endif
