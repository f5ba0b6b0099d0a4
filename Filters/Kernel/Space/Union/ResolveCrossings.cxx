// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "ResolveCrossings.h"

#include "SmallCrossings.h"
#include "SurfaceUnion.h"
#include "WindingNumber.h"

#include <algorithm> // for any_of, max
#include <cstdint>   // for marks
#include <utility>   // for move
#include <vector>    // for marks

namespace biting
{

namespace
{

// What was told before, crossings, or touches if there are none, as `told`; and what is new.
ProblemList Together(const ProblemList& before, const ProblemList& again, ProblemCode told)
{
  ProblemList all;
  const bool isCrossing = before.Has(ProblemCode::SelfCrossings) || before.Has(ProblemCode::Folds);
  for (ProblemGroup group : before.Groups())
  {
    const bool isMeant = isCrossing
      ? group.Code == ProblemCode::SelfCrossings || group.Code == ProblemCode::Folds
      : group.Code == ProblemCode::SurfaceTouches;
    group.Code = isMeant ? told : group.Code;
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

// Of shells: whether they cross another one, or themselves, or touch one where none crosses; none
// where one does not bound by itself: nesting did not see that.
std::vector<std::uint8_t> CrossingOnes(const CheckedSurface& surface)
{
  std::vector<std::uint8_t> isCrossing(surface.Shells.Shells.size(), 0);
  for (const SurfaceContact& contact :
    surface.Crossings.empty() ? surface.Touches : surface.Crossings)
  {
    isCrossing[At(surface.Shells.ShellOf[At(contact.First)])] = 1;
    isCrossing[At(surface.Shells.ShellOf[At(contact.Second)])] = 1;
  }
  const std::vector<SurfaceShell>& shells = surface.Shells.Shells;
  if (std::any_of(
        shells.begin(), shells.end(), [](const auto& shell) { return !shell.IsBounding; }))
  {
    isCrossing.assign(shells.size(), 0);
  }
  return isCrossing;
}

// Whether both have the same inside, on both sides of all their triangles that are wider than what
// vertices may have moved; and no shell that crosses nothing is within others that cross: it could
// be a cavity as well.
bool IsUnion(const CheckedSurface& given, const SurfaceMesh& made, double noise, Pulse& pulse)
{
  const double away = std::max(40.0 * noise, 1e-6 * given.Figures.Diagonal); // ten tolerances
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
      // Middles may be on other triangles, where these are on a lattice.
      const Point3 inner = 0.2847 * a + 0.3376 * b + 0.3777 * c;
      const Point3 normal = mesh->Normal(t);
      const double area = Length(normal);
      const bool isWide = area > 2.0 * away * mesh->BoxOf(t).Diagonal();
      const std::size_t axis = LongestAxis(normal);
      for (std::size_t k = 0; k < 2 && isWide; ++k)
      {
        const Point3 place = inner + ((k == 0 ? away : -away) / area) * normal;
        const int winding = givenWinding.At(place, axis, skipNone);
        const bool isDeep = k == 1 && mesh == &given.Mesh && winding > 1 &&
          isCrossing[At(given.Shells.ShellOf[t])] == 0;
        isUnion =
          isUnion && !isDeep && (winding > 0) == (madeWinding.At(place, axis, skipNone) > 0);
      }
    }
  }
  return isUnion;
}

bool DoShellsTouch(const CheckedSurface& surface)
{
  const std::vector<Id>& shellOf = surface.Shells.ShellOf;
  return std::any_of(surface.Touches.begin(), surface.Touches.end(),
    [&shellOf](const SurfaceContact& contact)
    { return shellOf[At(contact.First)] != shellOf[At(contact.Second)]; });
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
    if ((surface.Crossings.empty() && (isSmall || !DoShellsTouch(surface))) || !pulse.Ask())
    {
      continue;
    }
    SurfaceMesh mesh = isSmall ? CutOutCrossings(surface, options.Spacing, pulse)
                               : UniteSurfaces(surface, options.Noise, pulse);
    if (mesh.NumberOfTriangles() == 0)
    {
      continue;
    }
    ProblemList again;
    CheckedSurface resolved = CheckSurface(std::move(mesh), options, again, within);
    if (resolved.Mesh.NumberOfTriangles() > 0 && resolved.Crossings.empty() &&
      resolved.Figures.OpenEdges == 0 && !again.Has(ProblemCode::NotOrientable) &&
      (isSmall || IsUnion(surface, resolved.Mesh, options.Noise, pulse)))
    {
      surface = std::move(resolved);
      found =
        Together(found, again, isSmall ? ProblemCode::SmallCrossings : ProblemCode::UnitedSurfaces);
    }
  }
}

} // namespace biting
