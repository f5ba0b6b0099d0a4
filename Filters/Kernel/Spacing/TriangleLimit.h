// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingTriangleLimit_h
#define BitingTriangleLimit_h

#include "ConeCollector.h"

namespace biting
{

/// The values of a triangulated source, each lowered to what a gradation allows, measured from all
/// other points along its triangles; empty where no triangle is steep. Where triangles are so wide
/// that interpolation between points is not enough, `cones` has what the largest Lipschitz function
/// below the interpolant grows from: the edges of steep ones, and what bounds the points around; the
/// values of their points are as given.
/// Cost: n log n for n triangles that are to be lowered, linear for all others. Without meaning if
/// the monitor asks to stop.
///
/// Method: points hand on to their neighbors the place that bounds them, lowest first (the order of
/// Dijkstra), so that distances are those of the plane and not of paths along edges.
std::vector<double> LimitTriangles(
  const TriangulatedSource& source, double gradation, ConeCollector& cones, Monitor& monitor);

} // namespace biting

#endif
