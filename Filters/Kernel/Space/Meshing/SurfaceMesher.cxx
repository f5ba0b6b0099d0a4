// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SurfaceMesher.h"

#include "../Boundary/BodySides.h"
#include "../Relaxation/SurfaceRelaxation.h"
#include "CertifiedSurface.h"

#include <algorithm> // for all_of, fill_n
#include <utility>   // for exchange, move

namespace biting
{

namespace
{

/// The labels of space behind and in front of each triangle; none where one has the same part on
/// both sides. Walls between parts are turned as FindBodies has it, in a copy.
std::vector<TriangleSides> SidesOf(
  const CheckedSurface& surface, CheckedSurface& turned, Pulse& pulse)
{
  const std::vector<SurfaceShell>& shells = surface.Shells.Shells;
  const auto isSolid = [](const SurfaceShell& shell)
  { return shell.IsClosed && shell.IsOrientable; };
  if (surface.Figures.OpenEdges > 0)
  {
    return {};
  }
  if (std::all_of(shells.begin(), shells.end(), isSolid))
  {
    return std::vector<TriangleSides>(surface.Mesh.NumberOfTriangles(), TriangleSides{ 1, 0 });
  }
  turned = surface;
  turned.Mesh.Regions.clear(); // by values two cavities may share a wall
  return FindBodies(turned.Mesh, pulse).Sides;
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
  const std::vector<TriangleSides>& sides, CertifiedSurface& certified, ProblemList& problems,
  Monitor& monitor)
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
    isDone = CertifySurface(surface, options, sides, certified, problems, monitor);
  } while (certified.RoundsForTurns > 0 && !isDone && !problems.Has(ProblemCode::Aborted));
  return isDone;
}

BitingSurface MeshSurface(const CheckedSurface& given, const SurfaceMesherOptions& options,
  ProblemList& problems, Monitor& monitor)
{
  Pulse pulse(monitor);
  CheckedSurface turned;
  const std::vector<TriangleSides> sides = SidesOf(given, turned, pulse);
  const CheckedSurface& surface = turned.Mesh.Cells.empty() ? given : turned;
  CertifiedSurface certified;
  BitingSurface mesh;
  if (Certify(surface, options, sides, certified, problems, monitor))
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
