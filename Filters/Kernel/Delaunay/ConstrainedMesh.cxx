// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "ConstrainedMesh.h"

#include "SpatialOrder.h"

#include <utility> // for move

namespace biting
{

namespace
{

// Where the steps end, as shares of the time, roughly, for a million points.
constexpr double OrderEnd = 0.19;
constexpr double InsertionEnd = 0.94;

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

} // namespace

ConstrainedMesh MakeConstrainedMesh(
  const std::vector<Point2>& points, const ConstraintEdges& constraints, double phi, Pulse& pulse)
{
  ConstrainedMesh made;
  made.Inserted = Insert(points, Order(points, pulse), phi, pulse);
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

} // namespace biting
