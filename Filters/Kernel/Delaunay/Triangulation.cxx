// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Triangulation.h"

#include "../Base/Pulse.h"
#include "ConstrainedMesh.h"
#include "SpatialOrder.h"

#include <utility> // for move

namespace biting
{

namespace
{

// Where the steps end, as shares of the time, roughly, for a million points: of all, and of the
// constrained mesh.
constexpr double MakingEnd = 0.8;
constexpr double OrderEnd = 0.19;
constexpr double InsertionEnd = 0.94;

InsertionResult OrderAndInsert(const std::vector<Point2>& points, double phi, Pulse& pulse)
{
  std::vector<Id> order;
  {
    const PulsePart part(pulse, 0.0, OrderEnd);
    order = SpatialOrder(points, pulse);
  }
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

ConstrainedMesh MakeConstrainedMesh(
  const std::vector<Point2>& points, const ConstraintEdges& constraints, double phi, Pulse& pulse)
{
  ConstrainedMesh made;
  made.Inserted = OrderAndInsert(points, phi, pulse);
  if (made.Inserted.Mesh.NumberOfTriangles > 0 && !pulse.HasStopped())
  {
    made.NumberOfPoints = points.size();
    made.Edges = Renumber(constraints, made.Inserted.Vertex, pulse);
    ReleaseInSteps(pulse, made.Inserted.Vertex);
    const PulsePart part(pulse, InsertionEnd, 1.0);
    made.Recovery = RecoverConstraints(made.Inserted.Mesh, made.Edges, phi, pulse);
  }
  return made;
}

void Release(ConstrainedMesh& mesh, Pulse& pulse)
{
  HalfEdgeMesh& triangles = mesh.Inserted.Mesh;
  ReleaseInSteps(pulse, triangles.Marks, triangles.Twins, triangles.Corners, triangles.Points,
    triangles.VertexEdges);
}

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
