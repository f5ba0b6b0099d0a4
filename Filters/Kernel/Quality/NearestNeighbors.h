// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingNearestNeighbors_h
#define BitingNearestNeighbors_h

#include "../Base/Ids.h"
#include "../Base/Monitor.h"
#include "../Base/Point2.h"

#include <vector> // for the arrays

namespace biting
{

/// The distance of each vertex of a triangulation to the nearest other vertex, wherever it is:
/// joined by an edge or not, visible or hidden behind a hole or a slit. Infinite for a single
/// vertex. `corners` and `neighbors` are as in Triangulation. The triangles may have any shape
/// (they need not be Delaunay) but must not overlap, and `neighbors` must be mutual (see
/// CheckMesh).
///
/// Cost O(n) where triangles are well shaped and few vertices are near the boundary; O(n log n) for
/// the vertices for which this does not hold. Empty where the monitor asked to stop.
/// The triangles may be a part of a mesh: then distances are those within it; vertices that may be
/// nearer to others, though all triangles at them and beyond these are in the part, are among
/// `suspects`, where it is not null.
std::vector<double> NearestNeighborDistances(const std::vector<Point2>& points,
  const std::vector<Id>& corners, const std::vector<Id>& neighbors, Monitor& monitor = NoMonitor(),
  std::vector<Id>* suspects = nullptr);

/// The same of any points, without a triangulation; equal points have the distance 0.
/// Cost O(n log n). Empty where the monitor asked to stop.
std::vector<double> NearestNeighborDistances(const std::vector<Point2>& points, Monitor& monitor);

} // namespace biting

#endif
