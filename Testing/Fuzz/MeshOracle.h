// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingMeshOracle_h
#define BitingMeshOracle_h

#include "BitingMesh.h"
#include "Drawing.h"

#include <string> // for the violation

namespace biting
{

/// What a mesh must be, told without any help of the kernel:
/// - the arrays agree in size, ids are in range, places are finite;
/// - no point twice, none unused; triangles counterclockwise; an edge has one triangle or two, and
///   the neighbors are those;
/// - the covering edges are edges of the mesh, each once; those that bound have one triangle, the
///   others two;
/// - the boundary winds once about every triangle looked at: nothing overlaps;
/// - regions are what interfaces leave connected;
/// - with explicit boundaries the area is that of the drawing;
/// - every end of a segment and every embedded point that the mesh covers is a vertex, bit for bit,
///   unless it is nearer to the boundary, or to a vertex, than rounding;
/// - every segment, as far as the mesh covers it, is covered by edges; every covering edge lies on
///   its input cell; but edges between two faces of one region are covered by none;
/// - kinds and original points are true;
/// - with PreserveBoundary no vertex is added on a segment, but where two meet;
/// - with phi = 1, and in relaxed meshes, edges that cover nothing are Delaunay;
/// - quality figures are within their ranges; distances to neighbors, in small meshes, are right;
/// - bites are there if they were asked for, not more than asked for, and centred at vertices; in
///   relaxed meshes, at those of the input.
/// Returns the first violation, empty where there is none.
std::string FindMeshViolation(
  const BitingMesh& mesh, const Polylines& input, const BitingMeshOptions& options);

} // namespace biting

#endif
