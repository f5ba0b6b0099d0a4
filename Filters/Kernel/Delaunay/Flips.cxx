// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Flips.h"

#include <algorithm> // for min

namespace biting
{

namespace
{

/// Whether triangle (a, b, c) must not stand beside d: its circumcentre is nearer to d than phi
/// times the circumradius, or its radius-edge ratio is above sqrt(2) / phi. Rounded: which of two
/// valid diagonals is kept is a matter of quality.
bool IsRefused(const Point2& a, const Point2& b, const Point2& c, const Point2& d, double phi)
{
  const Point2 u = b - a;
  const Point2 v = c - a;
  const double doubledCross = 2.0 * Cross(u, v);
  const Point2 center{ (Dot(u, u) * v.Y - Dot(v, v) * u.Y) / doubledCross,
    (Dot(v, v) * u.X - Dot(u, u) * v.X) / doubledCross };
  const Point2 toPoint = (d - a) - center;
  const double scaledRadius = phi * phi * Dot(center, center);
  const double shortest = std::min({ Dot(u, u), Dot(v, v), Dot(v - u, v - u) });
  return Dot(toPoint, toPoint) < scaledRadius || !(scaledRadius <= 2.0 * shortest);
}

bool MustFlip(const HalfEdgeMesh& mesh, Id edge, double phi)
{
  const Id twin = mesh.Twins[edge];
  const Id p = mesh.Corners[edge];
  const Id a = mesh.Origin(edge);
  const Id b = mesh.Target(edge);
  const Id d = mesh.Corners[twin];
  if (mesh.Mark(edge) != NoId || !BreaksDelaunay(mesh, p, a, b, d))
  {
    return false;
  }
  if (phi >= 1.0 || (a | b) < 0)
  {
    return true;
  }
  const auto& points = mesh.Points;
  return IsRefused(points[p], points[a], points[b], points[d], phi) ||
    IsRefused(points[d], points[b], points[a], points[p], phi);
}

/// Marks are those before the flip: the outer edges beyond the two `Next` move to edge and twin.
void MoveMarks(HalfEdgeMesh& mesh, Id edge, Id twin)
{
  const Id nextEdge = HalfEdgeMesh::Next(edge);
  const Id nextTwin = HalfEdgeMesh::Next(twin);
  mesh.SetMark(edge, mesh.Mark(nextTwin));
  mesh.SetMark(twin, mesh.Mark(nextEdge));
  mesh.SetMark(nextEdge, NoId);
  mesh.SetMark(nextTwin, NoId);
}

void UpdateVertexEdges(HalfEdgeMesh& mesh, Id edge, Id twin)
{
  for (const Id corner : { edge, HalfEdgeMesh::Next(edge), twin, HalfEdgeMesh::Next(twin) })
  {
    if (mesh.Corners[corner] != NoId)
    {
      mesh.VertexEdges[mesh.Corners[corner]] = corner;
    }
  }
}

} // namespace

bool BreaksDelaunayAtInfinity(const HalfEdgeMesh& mesh, Id p, Id a, Id b, Id d)
{
  if (p < 0 || d < 0)
  {
    return false;
  }
  return a < 0 ? Orient2D(mesh.PointAt(d), mesh.PointAt(b), mesh.PointAt(p)) > 0
               : Orient2D(mesh.PointAt(a), mesh.PointAt(d), mesh.PointAt(p)) > 0;
}

void FlipEdge(HalfEdgeMesh& mesh, Id edge)
{
  const Id twin = mesh.Twins[edge];
  const Id nextEdge = HalfEdgeMesh::Next(edge);
  const Id nextTwin = HalfEdgeMesh::Next(twin);
  mesh.Corners[HalfEdgeMesh::Previous(edge)] = mesh.Corners[twin];
  mesh.Corners[HalfEdgeMesh::Previous(twin)] = mesh.Corners[edge];
  const Id beyondEdge = mesh.Twins[nextEdge];
  const Id beyondTwin = mesh.Twins[nextTwin];
  mesh.Link(edge, beyondTwin);
  mesh.Link(twin, beyondEdge);
  mesh.Link(nextEdge, nextTwin);
  if (!mesh.VertexEdges.empty())
  {
    MoveMarks(mesh, edge, twin);
    UpdateVertexEdges(mesh, edge, twin);
  }
}

void RestoreDelaunay(HalfEdgeMesh& mesh, double phi, std::vector<Id>& stack, Pulse& pulse)
{
  while (!stack.empty() && pulse.Beat())
  {
    const Id edge = stack.back();
    stack.pop_back();
    if (MustFlip(mesh, edge, phi))
    {
      const Id twin = mesh.Twins[edge];
      FlipEdge(mesh, edge);
      stack.insert(
        stack.end(), { edge, HalfEdgeMesh::Previous(edge), twin, HalfEdgeMesh::Previous(twin) });
    }
  }
}

} // namespace biting
