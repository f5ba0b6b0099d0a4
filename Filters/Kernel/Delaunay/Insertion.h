// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingInsertion_h
#define BitingInsertion_h

#include "../Base/Ids.h"
#include "../Base/Point.h"
#include "../Base/Pulse.h"
#include "HalfEdgeMesh.h"

#include <vector> // for the points

namespace biting
{

/// The phi-Delaunay triangulation of all points, before constraints.
struct InsertionResult
{
  HalfEdgeMesh Mesh;      ///< no triangles where all points are collinear
  std::vector<Id> Order;  ///< vertex of the mesh -> point
  std::vector<Id> Vertex; ///< point -> vertex of the mesh; equal points share one
};

/// Inserts `points` one after the other: a walk from the last one finds the triangle, which is
/// split; flips around the new vertex restore the criterion. `order` is that of SpatialOrder: it
/// keeps the walks at three steps or so, for any number of points. On abort the mesh has no
/// meaning.
InsertionResult InsertPoints(
  const std::vector<Point2>& points, std::vector<Id> order, double phi, Pulse& pulse);

} // namespace biting

#endif
