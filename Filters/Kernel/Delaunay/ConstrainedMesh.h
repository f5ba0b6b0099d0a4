// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingConstrainedMesh_h
#define BitingConstrainedMesh_h

#include "../Base/Point.h"
#include "../Base/Pulse.h"
#include "HalfEdgeMesh.h"
#include "Triangulation.h"

#include <cstddef> // for a count
#include <vector>  // for the points

// The steps of Triangulate. On abort their results have no meaning.

namespace biting
{

/// The phi-Delaunay triangulation of all points, before constraints.
struct InsertionResult
{
  HalfEdgeMesh Mesh;      ///< no triangles where all points are collinear
  std::vector<Id> Order;  ///< vertex of the mesh -> point
  std::vector<Id> Vertex; ///< point -> vertex of the mesh; equal points share one
};

/// Pairs of constraints that are in each other's way, the smaller number first; at most 10000 of
/// each kind. Below that, each constraint that crosses another is in a pair of Conflicts.
struct RecoveryResult
{
  std::vector<ConstraintConflict> Conflicts;    ///< they cross: the mesh has no meaning
  std::vector<ConstraintConflict> Coincidences; ///< they cover the same edge
};

/// A triangulation of the whole plane with all constraints, before its inside is taken out. More
/// points may come.
struct ConstrainedMesh
{
  InsertionResult Inserted;
  ConstraintEdges Edges; ///< the constraints; their ends are vertices of the mesh
  RecoveryResult Recovery;
  std::size_t NumberOfPoints = 0; ///< that were inserted

  /// Whether it has triangles, and all constraints are among their edges.
  bool IsWhole() const
  {
    return this->Inserted.Mesh.NumberOfTriangles > 0 && this->Recovery.Conflicts.empty();
  }
};

/// Inserts `points` one after the other: a walk from the last one finds the triangle, which is
/// split; flips around the new vertex restore the criterion. `order` is that of SpatialOrder: with
/// it walks take about three steps, for any number of points.
InsertionResult InsertPoints(
  const std::vector<Point2>& points, std::vector<Id> order, double phi, Pulse& pulse);

/// Makes edges of the constraints, whose ends are vertices of the mesh, and marks them
/// (HalfEdgeMesh::Marks). A constraint that meets vertices on its way becomes several edges. An
/// edge that several constraints cover gets the smallest number; each boundary constraint on it
/// toggles the parity of its mark.
/// The order is scattered: long constraints side by side, each ending at those made before, then
/// cross O(n log n) edges in all; one after the other they would cross O(n^2). Missing edges are
/// searched from both ends at once, so a fan of constraints costs the degrees of its outer ends.
/// The crossed triangles are replaced in linear time, then edges flip.
RecoveryResult RecoverConstraints(
  HalfEdgeMesh& mesh, const ConstraintEdges& constraints, double phi, Pulse& pulse);

/// The steps up to here, one after the other.
ConstrainedMesh MakeConstrainedMesh(
  const std::vector<Point2>& points, const ConstraintEdges& constraints, double phi, Pulse& pulse);

/// Inserts those of `points` that are not in the mesh yet: it has the first ones. Each is walked to
/// from the one before. One that lies on a constraint divides it. The mesh must be whole; it was
/// made with the same phi, and stays phi-Delaunay.
void InsertLate(const std::vector<Point2>& points, double phi, ConstrainedMesh& mesh, Pulse& pulse);

/// The inside of the mesh: triangles that are an odd number of boundaries away from the ghosts.
/// `constraints` have vertices of the mesh as ends; `order` maps these to the points of the caller,
/// which the result refers to.
/// Regions are numbered as one meets them along the constraints, in order of number, from start to
/// end, the left side of each edge before the right. Triangles are ordered by region, then by the
/// last of their corners as a point of the caller: where points near each other are so in the
/// caller's order, neighbors are near each other in memory, too.
/// The arrays of `mesh` are given back as they are read. On abort the result is empty.
Triangulation TakeInside(HalfEdgeMesh& mesh, const ConstraintEdges& constraints,
  const std::vector<Id>& order, Pulse& pulse);

/// Gives the memory back.
void Release(ConstrainedMesh& mesh, Pulse& pulse);

} // namespace biting

#endif
