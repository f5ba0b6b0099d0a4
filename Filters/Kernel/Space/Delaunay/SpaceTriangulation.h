// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSpaceTriangulation_h
#define BitingSpaceTriangulation_h

#include "../../Base/Ids.h"
#include "../../Base/Monitor.h"
#include "../../Base/Point.h"
#include "TetMesh.h"

#include <vector> // for points

namespace biting
{

/// Two points at one place.
struct PointPair
{
  Id Point = NoId; ///< it is no vertex
  Id Of = NoId;    ///< it is one
};

struct SpaceTriangulation
{
  TetMesh Mesh;                      ///< no cells where all points lie in one plane
  std::vector<Id> Order;             ///< vertex -> point
  std::vector<PointPair> Duplicates; ///< none is known where there are no cells
  std::vector<Id> Hidden;            ///< points without a cell, too light
  int Dimension = -1;                ///< of the space that the points span, 3 if there are cells
  bool WasAborted = false;           ///< then nothing else has a meaning
};

/// The regular triangulation of many points (RegularTriangulation.h); `weights` is empty, for the
/// Delaunay triangulation, or has one for each. Inserted in the order of SpatialOrder. The cells
/// depend on points and weights only. Of points at one place the first inserted is the vertex.
/// Precondition: coordinates are finite and in range (Predicates3.h). Cost O(n log n) where points
/// are spread in space; O(n^2) cells exist for some that lie on two curves.
/// Memory: 36 bytes a point, 33 a cell; a point that is inserted among others has 6.8 cells.
SpaceTriangulation TriangulateSpace(
  const std::vector<Point3>& points, const std::vector<double>& weights, Monitor& monitor);

} // namespace biting

#endif
