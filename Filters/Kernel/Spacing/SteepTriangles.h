// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSteepTriangles_h
#define BitingSteepTriangles_h

#include "ConeCollector.h"

namespace biting
{

/// Adds to `cones` what makes a triangulated source Lipschitz with the constant `gradation`: the
/// edges of its triangles that are steeper than that, and the lines in these where the least value
/// begins. The minimum of the source and its extension from there is then exactly the largest
/// Lipschitz function below it, in the plane of its triangles: within a triangle f is linear, so the
/// point from which another one is bounded is on an edge of a steep triangle.
/// Edges are left out where a path along other edges proves that they bound nothing.
/// Nothing is added for a source that is nowhere steep. False if the monitor asks to stop.
/// Cost O(n log n), linear where little is steep.
bool AddSteepTriangles(
  const TriangulatedSource& source, double gradation, ConeCollector& cones, Monitor& monitor);

} // namespace biting

#endif
