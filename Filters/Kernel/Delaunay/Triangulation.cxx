// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Triangulation.h"

#include "../Base/Pulse.h"
#include "ConstrainedMesh.h"
#include "RegionFill.h"

#include <utility> // for move

namespace biting
{

namespace
{

constexpr double MakingEnd = 0.8; // of the time, roughly, for a million points

TriangulationResult TakeResult(ConstrainedMesh& made, Pulse& pulse)
{
  TriangulationResult result;
  result.Conflicts = std::move(made.Recovery.Conflicts);
  result.Coincidences = std::move(made.Recovery.Coincidences);
  const bool isWhole = made.Inserted.Mesh.NumberOfTriangles > 0 && result.Conflicts.empty();
  if (isWhole && !pulse.HasStopped())
  {
    result.Mesh = TakeInside(made.Inserted.Mesh, made.Edges, made.Inserted.Order, pulse);
  }
  Release(made, pulse);
  if (pulse.HasStopped())
  {
    result = {};
    result.WasAborted = true;
  }
  return result;
}

} // namespace

TriangulationResult Triangulate(const std::vector<Point2>& points,
  const ConstraintEdges& constraints, const TriangulationOptions& options, Monitor& monitor)
{
  Pulse pulse(monitor);
  ConstrainedMesh made;
  {
    const PulsePart part(pulse, 0.0, MakingEnd);
    made = MakeConstrainedMesh(points, constraints, options.Phi, pulse);
  }
  const PulsePart part(pulse, MakingEnd, 1.0);
  return TakeResult(made, pulse);
}

TriangulationResult FinishTriangulation(ConstrainedMesh made, Monitor& monitor)
{
  Pulse pulse(monitor);
  return TakeResult(made, pulse);
}

} // namespace biting
