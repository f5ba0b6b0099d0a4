// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "ResolveCrossings.h"

#include "SmallCrossings.h"
#include "SurfaceUnion.h"
#include "WindingNumber.h"

#include <algorithm> // for max, min
#include <cstdint>   // for marks
#include <utility>   // for move
#include <vector>    // for marks

namespace biting
{

namespace
{

bool IsCrossing(ProblemCode code)
{
  return code == ProblemCode::SelfCrossings || code == ProblemCode::Folds;
}

// What was told before, and crossings as `told`; of what is found again what is new.
ProblemList Together(const ProblemList& before, const ProblemList& again, ProblemCode told)
{
  ProblemList all;
  for (ProblemGroup group : before.Groups())
  {
    group.Code = IsCrossing(group.Code) ? told : group.Code;
    for (Problem& problem : group.First)
    {
      problem.Code = group.Code;
    }
    all.Add(group);
  }
  for (const ProblemGroup& group : again.Groups())
  {
    if (!before.Has(group.Code) && group.Code != ProblemCode::ClosedHoles)
    {
      all.Add(group);
    }
  }
  return all;
}

// Of triangles: whether their shell crosses another one, or itself.
std::vector<std::uint8_t> CrossingOnes(const CheckedSurface& surface)
{
  std::vector<std::uint8_t> isCrossing(surface.Shells.Shells.size(), 0);
  for (const SurfaceContact& contact : surface.Crossings)
  {
    isCrossing[At(surface.Shells.ShellOf[At(contact.First)])] = 1;
    isCrossing[At(surface.Shells.ShellOf[At(contact.Second)])] = 1;
  }
  std::vector<std::uint8_t> marks;
  for (const Id shell : surface.Shells.ShellOf)
  {
    marks.push_back(isCrossing[At(shell)]);
  }
  return marks;
}

// Whether both have the same inside, on both sides of all their triangles that are wider than what
// vertices may have moved; and no shell that crosses nothing is within others that cross: it could
// be a cavity as well.
bool IsUnion(const CheckedSurface& given, const SurfaceMesh& made, Pulse& pulse)
{
  const double away = 1e-6 * given.Figures.Diagonal; // ten times the tolerance of UniteSurfaces
  const std::vector<std::uint8_t> isCrossing = CrossingOnes(given);
  const BoxTree<SurfaceItem, 3> givenTree = MakeSurfaceTree(given.Mesh, pulse);
  const BoxTree<SurfaceItem, 3> madeTree = MakeSurfaceTree(made, pulse);
  const WindingNumber givenWinding(given.Mesh, givenTree);
  const WindingNumber madeWinding(made, madeTree);
  const auto skipNone = [](std::size_t) { return false; };
  bool isUnion = true;
  for (const SurfaceMesh* mesh : { &given.Mesh, &made })
  {
    for (std::size_t t = 0; t < mesh->NumberOfTriangles() && isUnion && pulse.Beat(64); ++t)
    {
      const auto [a, b, c] = mesh->Triangle(t);
      const double side = std::max(Distance(a, b), std::max(Distance(b, c), Distance(c, a)));
      const Point3 normal = mesh->Normal(t);
      const double area = Length(normal);
      const bool isWide = area > 4.0 * away * side;
      const std::size_t axis = LongestAxis(normal);
      for (std::size_t k = 0; k < 2 && isWide; ++k)
      {
        const Point3 place = mesh->Middle(t) + ((k == 0 ? away : -away) / area) * normal;
        const int winding = givenWinding.At(place, axis, skipNone);
        const bool isDeep = mesh == &given.Mesh && isCrossing[t] == 0 && winding > 1;
        isUnion =
          isUnion && !isDeep && (winding > 0) == (madeWinding.At(place, axis, skipNone) > 0);
      }
    }
  }
  return isUnion;
}

} // namespace

void ResolveCrossings(
  CheckedSurface& surface, const SurfaceCheckOptions& options, ProblemList& found, Monitor& monitor)
{
  Pulse pulse(monitor);
  const PulsePart part(pulse, 1.0, 1.0);
  PulseMonitor within(pulse); // its stages are none of the monitor
  for (const bool isSmall : { true, false })
  {
    if (surface.Crossings.empty() || !pulse.Ask())
    {
      return;
    }
    SurfaceMesh mesh = isSmall ? CutOutCrossings(surface, options.Spacing, pulse)
                               : UniteSurfaces(surface, options.Noise, pulse);
    if (mesh.NumberOfTriangles() == 0)
    {
      continue;
    }
    ProblemList again;
    CheckedSurface resolved = CheckSurface(std::move(mesh), options, again, within);
    if (resolved.Crossings.empty() && resolved.Figures.OpenEdges == 0 &&
      !again.Has(ProblemCode::NotOrientable) && (isSmall || IsUnion(surface, resolved.Mesh, pulse)))
    {
      surface = std::move(resolved);
      found =
        Together(found, again, isSmall ? ProblemCode::SmallCrossings : ProblemCode::UnitedSurfaces);
    }
  }
}

} // namespace biting
