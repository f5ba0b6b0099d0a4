// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SurfaceMesher.h"

#include "../Relaxation/SurfaceRelaxation.h"
#include "CertifiedSurface.h"

#include <algorithm> // for fill_n
#include <utility>   // for exchange, move

namespace biting
{

namespace
{

/// Of solids all triangles have the body behind them.
std::vector<TriangleSides> SidesOf(const CheckedSurface& surface)
{
  const std::size_t triangles = surface.Mesh.NumberOfTriangles();
  bool isSolid = true;
  for (std::size_t t = 0; t < triangles && isSolid; ++t)
  {
    isSolid = surface.Shells.IsSolid(t);
  }
  return std::vector<TriangleSides>(isSolid ? triangles : 0, TriangleSides{ 1, 0 });
}

RelaxedSurface Bitten(const CertifiedSurface& certified)
{
  const SurfaceBites& bites = certified.Bites;
  RelaxedSurface relaxed{ bites.Centers, bites.Sizes, bites.Triangles, {}, {},
    certified.Boundary.Corners };
  relaxed.IsFree.assign(relaxed.Points.size(), 1);
  std::fill_n(relaxed.IsFree.begin(), bites.NumberOnLines, std::uint8_t{ 0 });
  relaxed.Chains.assign(relaxed.Points.size(), NoId);
  for (std::size_t end = 0; end < bites.PieceEnds.size(); ++end)
  {
    const Id bite = bites.PieceEnds[end];
    relaxed.Chains[At(bite)] = bite < bites.NumberOfCorners ? NoId : bites.PieceChains[end / 2];
  }
  return relaxed;
}

/// Keeps of the ground what DescribeMesh asks for.
void Release(SurfaceGround& ground)
{
  SurfaceGround kept;
  kept.Chains = std::move(ground.Chains);
  kept.Mesh.Cells = std::move(ground.Mesh.Cells);
  kept.Mesh.PointIds = std::move(ground.Mesh.PointIds);
  ground = std::move(kept);
}

void Relax(CertifiedSurface& certified, bool isWanted, BitingSurface& mesh, Pulse& pulse)
{
  RelaxedSurface relaxed = Bitten(certified);
  if (isWanted)
  {
    RelaxSurface(certified.Ground, certified.Bites.PieceEnds, relaxed, pulse);
    Release(certified.Ground);
    if (CrossesItself(relaxed.Points, relaxed.Corners, pulse))
    {
      relaxed = Bitten(certified); // facets of one triangulation cross nowhere
    }
  }
  mesh.Points = std::move(relaxed.Points);
  mesh.Spacing = std::move(relaxed.Sizes);
  mesh.Corners = std::move(relaxed.Corners);
  certified.Bites.Triangles = std::move(relaxed.Triangles);
}

/// With f halved at sharp turns; without, where that does not suit.
bool Certify(const CheckedSurface& surface, const SurfaceMesherOptions& options,
  CertifiedSurface& certified, ProblemList& problems, Monitor& monitor)
{
  const ProblemList before = problems;
  bool isDone = false;
  int rounds = options.BoundaryTolerance > 0.0 ? 2 : 0;
  do
  {
    problems = before;
    certified = {};
    certified.RoundsForTurns = std::exchange(rounds, 0);
    certified.HasBalls = false;
    isDone = CertifySurface(surface, options, SidesOf(surface), certified, problems, monitor);
  } while (certified.RoundsForTurns > 0 && !isDone && !problems.Has(ProblemCode::Aborted));
  return isDone;
}

BitingSurface MeshSurface(const CheckedSurface& surface, const SurfaceMesherOptions& options,
  ProblemList& problems, Monitor& monitor)
{
  Pulse pulse(monitor);
  CertifiedSurface certified;
  BitingSurface mesh;
  if (Certify(surface, options, certified, problems, monitor))
  {
    monitor.BeginStage("Relaxing");
    std::vector<TriangleSides>().swap(certified.Boundary.Sides);
    Relax(certified, options.Relaxation, mesh, pulse);
    DescribeMesh(surface, certified, options, mesh, problems, pulse);
  }
  return MayGoOn(problems, pulse) ? mesh : BitingSurface();
}

} // namespace

BitingSurface MakeBitingSurface(const CheckedSurface& surface, const SurfaceMesherOptions& options,
  ProblemList& problems, Monitor& monitor)
{
  if (surface.Mesh.NumberOfTriangles() == 0)
  {
    return {};
  }
  return MeshNearOrigin(
    surface, options, problems,
    [&monitor](const CheckedSurface& s, const SurfaceMesherOptions& o, ProblemList& p)
    { return MeshSurface(s, o, p, monitor); },
    [](BitingSurface& mesh, const Point3& origin)
    {
      MovePoints(mesh.Points, origin);
      MovePoints(mesh.BiteCenters, origin);
    });
}

} // namespace biting
