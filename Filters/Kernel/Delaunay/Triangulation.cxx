// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Triangulation.h"

#include "../Base/Pulse.h"
#include "ConstraintRecovery.h"
#include "Insertion.h"
#include "RegionFill.h"
#include "SpatialOrder.h"

#include <utility> // for move

namespace biting
{

namespace
{

// Where the steps end, as shares of the time, roughly, for a million points.
constexpr double OrderEnd = 0.15;
constexpr double InsertionEnd = 0.75;
constexpr double RecoveryEnd = 0.8;

std::vector<Id> Order(const std::vector<Point2>& points, Pulse& pulse)
{
  const PulsePart part(pulse, 0.0, OrderEnd);
  return SpatialOrder(points, pulse);
}

InsertionResult Insert(
  const std::vector<Point2>& points, std::vector<Id> order, double phi, Pulse& pulse)
{
  const PulsePart part(pulse, OrderEnd, InsertionEnd);
  return InsertPoints(points, std::move(order), phi, pulse);
}

/// The constraints with vertices of the mesh in place of points.
ConstraintEdges Renumber(
  const ConstraintEdges& constraints, const std::vector<Id>& vertex, Pulse& pulse)
{
  ConstraintEdges renumbered = constraints;
  const PulsePart part(pulse, InsertionEnd, InsertionEnd);
  pulse.ForEach(constraints.Starts.size(),
    [&renumbered, &vertex](std::size_t constraint)
    {
      renumbered.Starts[constraint] = vertex[renumbered.Starts[constraint]];
      renumbered.Ends[constraint] = vertex[renumbered.Ends[constraint]];
    });
  return renumbered;
}

RecoveryResult Recover(
  HalfEdgeMesh& mesh, const ConstraintEdges& constraints, double phi, Pulse& pulse)
{
  const PulsePart part(pulse, InsertionEnd, RecoveryEnd);
  return RecoverConstraints(mesh, constraints, phi, pulse);
}

Triangulation Take(
  const InsertionResult& inserted, const ConstraintEdges& constraints, Pulse& pulse)
{
  const PulsePart part(pulse, RecoveryEnd, 1.0);
  return TakeInside(inserted.Mesh, constraints, inserted.Order, pulse);
}

void Release(InsertionResult& inserted, Pulse& pulse)
{
  HalfEdgeMesh& mesh = inserted.Mesh;
  ReleaseInSteps(pulse, mesh.Marks, mesh.Twins, mesh.Corners, mesh.Points, mesh.VertexEdges);
}

} // namespace

TriangulationResult Triangulate(const std::vector<Point2>& points,
  const ConstraintEdges& constraints, const TriangulationOptions& options, Monitor& monitor)
{
  TriangulationResult result;
  Pulse pulse(monitor);
  InsertionResult inserted = Insert(points, Order(points, pulse), options.Phi, pulse);
  if (inserted.Mesh.NumberOfTriangles > 0 && !pulse.HasStopped())
  {
    const ConstraintEdges edges = Renumber(constraints, inserted.Vertex, pulse);
    RecoveryResult recovery = Recover(inserted.Mesh, edges, options.Phi, pulse);
    result.Conflicts = std::move(recovery.Conflicts);
    result.Coincidences = std::move(recovery.Coincidences);
    if (result.Conflicts.empty() && !pulse.HasStopped())
    {
      result.Mesh = Take(inserted, edges, pulse);
    }
  }
  Release(inserted, pulse);
  if (pulse.HasStopped())
  {
    result = {};
    result.WasAborted = true;
  }
  return result;
}

} // namespace biting
