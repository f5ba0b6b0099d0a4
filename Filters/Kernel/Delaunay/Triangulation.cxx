// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Triangulation.h"

#include "ConstraintRecovery.h"
#include "Insertion.h"
#include "Pulse.h"
#include "RegionFill.h"

#include <utility> // for move

namespace biting
{

namespace
{

// Shares of the time that the three steps take, roughly, for a million points.
constexpr double InsertionEnd = 0.75;
constexpr double RecoveryEnd = 0.85;

/// The constraints with vertices of the mesh in place of points.
ConstraintEdges Renumber(const ConstraintEdges& constraints, const std::vector<Id>& vertex)
{
  ConstraintEdges renumbered = constraints;
  for (Id& start : renumbered.Starts)
  {
    start = vertex[start];
  }
  for (Id& end : renumbered.Ends)
  {
    end = vertex[end];
  }
  return renumbered;
}

} // namespace

TriangulationResult Triangulate(const std::vector<Point2>& points,
  const ConstraintEdges& constraints, const TriangulationOptions& options, Monitor& monitor)
{
  TriangulationResult result;
  Pulse pulse(monitor);
  pulse.BeginPart(0.0, InsertionEnd);
  InsertionResult inserted = InsertPoints(points, options.Phi, pulse);
  if (inserted.Mesh.NumberOfTriangles > 0 && !pulse.HasStopped())
  {
    const ConstraintEdges edges = Renumber(constraints, inserted.Vertex);
    pulse.BeginPart(InsertionEnd, RecoveryEnd);
    RecoveryResult recovery = RecoverConstraints(inserted.Mesh, edges, options.Phi, pulse);
    result.Conflicts = std::move(recovery.Conflicts);
    result.Coincidences = std::move(recovery.Coincidences);
    if (result.Conflicts.empty() && !pulse.HasStopped())
    {
      pulse.BeginPart(RecoveryEnd, 1.0);
      result.Mesh = TakeInside(inserted.Mesh, edges, inserted.Order, pulse);
    }
  }
  if (pulse.HasStopped())
  {
    result = {};
    result.WasAborted = true;
  }
  return result;
}

} // namespace biting
