// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingMeshCheck_h
#define BitingMeshCheck_h

#include "../Base/Ids.h"
#include "../Base/Monitor.h"
#include "../Base/Point.h"

#include <string> // for the violation
#include <vector> // for the arrays

namespace biting
{

/// A mesh and what it must be. Arrays as in Triangulation: three entries a triangle.
struct MeshCheckInput
{
  const std::vector<Point2>& Points;
  const std::vector<Id>& Corners;
  const std::vector<Id>& Neighbors;
  const std::vector<Id>& Constraints;
  double ExpectedArea = 0.0;

  /// How far the area may be off, relative to ExpectedArea, in addition to rounding: that of the
  /// boundary vertices, 4 ulp of the largest coordinate along the whole boundary, and that of the
  /// sum itself.
  double AreaTolerance = 1e-12;

  /// True: edges that no constraint covers must be locally Delaunay.
  bool IsDelaunay = false;
};

/// The second look at a mesh before it is handed out. Checks that
/// - the arrays agree in size, and all ids are in range;
/// - every triangle is counterclockwise, exactly;
/// - neighbors are mutual: both triangles have the same edge, in opposite directions, and the same
///   constraint on it;
/// - where it must be Delaunay, no corner lies within the circle of a triangle beside its own, but
///   across a constraint, exactly;
/// - every boundary edge is covered by a constraint;
/// - every vertex belongs to a triangle;
/// - Euler's formula holds: with C connected components and L boundary loops, V - E + F = 2 C - L,
///   where a vertex counts once for each separate fan of triangles at it. It fails for a surface
///   with a handle, and where two fans without boundary share a vertex;
/// - the sum of the areas is the expected one.
/// Where the boundary edges are those of the domain, the triangles then cover it once.
/// Returns the first violation as text, empty where there is none. Cost O(n). Where the monitor
/// asks to stop the answer has no meaning.
std::string CheckMesh(const MeshCheckInput& mesh, Monitor& monitor = NoMonitor());

} // namespace biting

#endif
