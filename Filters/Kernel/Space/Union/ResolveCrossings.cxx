// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "ResolveCrossings.h"

#include "SmallCrossings.h"
#include "SurfaceUnion.h"

#include <utility> // for move

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
      !again.Has(ProblemCode::NotOrientable))
    {
      surface = std::move(resolved);
      found =
        Together(found, again, isSmall ? ProblemCode::SmallCrossings : ProblemCode::UnitedSurfaces);
    }
  }
}

} // namespace biting
