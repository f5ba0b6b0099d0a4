// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingFlips_h
#define BitingFlips_h

#include "../Base/Ids.h"
#include "../Base/Pulse.h"
#include "HalfEdgeMesh.h"

#include <vector> // for the stack

namespace biting
{

/// Whether the edge between the triangles (p, a, b) and (d, b, a) breaks the Delaunay criterion:
/// d lies inside the circle through p, a, b. Exact. The circle of a ghost triangle is the open half
/// plane beyond its edge. Where true the quadrangle is strictly convex.
/// Inline, because it is asked nine times for each point that is inserted.
inline bool BreaksDelaunay(const HalfEdgeMesh& mesh, Id p, Id a, Id b, Id d);

/// The same where one of the vertices is at infinity.
bool BreaksDelaunayAtInfinity(const HalfEdgeMesh& mesh, Id p, Id a, Id b, Id d);

/// Replaces the edge by the other diagonal of its quadrangle. Marks and VertexEdges follow, where
/// there are any.
void FlipEdge(HalfEdgeMesh& mesh, Id edge);

/// Makes the mesh phi-Delaunay (TriangulationOptions::Phi), given that all edges that may not be so
/// are on the stack. Edges that carry a mark stay. Each flip lowers the lifted surface, so it ends.
/// On abort it just returns.
void RestoreDelaunay(HalfEdgeMesh& mesh, double phi, std::vector<Id>& stack, Pulse& pulse);

inline bool BreaksDelaunay(const HalfEdgeMesh& mesh, Id p, Id a, Id b, Id d)
{
  if ((p | a | b | d) < 0)
  {
    return BreaksDelaunayAtInfinity(mesh, p, a, b, d);
  }
  const auto& points = mesh.Points;
  return InCircle(points[p], points[a], points[b], points[d]) > 0;
}

} // namespace biting

#endif
