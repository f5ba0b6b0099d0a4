// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingConstrainedMesh_h
#define BitingConstrainedMesh_h

#include "../Base/Point.h"
#include "../Base/Pulse.h"
#include "ConstraintRecovery.h"
#include "Insertion.h"
#include "Triangulation.h"

#include <cstddef> // for a count
#include <vector>  // for the points

namespace biting
{

/// A triangulation before its inside is taken out: of the whole plane, with all constraints. More
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

/// The first steps of Triangulate. On abort the mesh has no meaning.
ConstrainedMesh MakeConstrainedMesh(
  const std::vector<Point2>& points, const ConstraintEdges& constraints, double phi, Pulse& pulse);

/// Inserts those of `points` that are not in the mesh yet: it has the first ones. Each is walked to
/// from the one before. One that lies on a constraint divides it. The mesh must be whole; it was
/// made with the same phi, and stays phi-Delaunay. On abort it has no meaning.
void InsertLate(const std::vector<Point2>& points, double phi, ConstrainedMesh& mesh, Pulse& pulse);

/// Gives the memory back.
void Release(ConstrainedMesh& mesh, Pulse& pulse);

} // namespace biting

#endif
