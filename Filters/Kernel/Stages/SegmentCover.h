// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSegmentCover_h
#define BitingSegmentCover_h

#include "../Base/Ids.h"
#include "../Base/Monitor.h"
#include "../Base/Point.h"
#include "../Domain/Domain.h"

#include <string> // for the violation
#include <vector> // for the arrays

namespace biting
{

/// The edges of a mesh that cover segments. Arrays as in Triangulation: three entries a triangle.
struct SegmentCoverInput
{
  const std::vector<Point2>& Points;
  const std::vector<Id>& Corners;
  const std::vector<Id>& Neighbors;
  const std::vector<Id>& Constraints;
  const std::vector<Id>& Segments; ///< of each constraint: the segment of the domain
};

/// Part of the second look at a mesh: the mesh edges on each segment of the domain, boundary or
/// interface, form a chain between its ends: every place is an end of an even number of them, but
/// for the two ends of the segment. Places are compared as coordinates, bit for bit, by a sum of 64
/// bits for each segment. Whether the chain is straight is left to the area.
/// Returns the first violation as text, empty where there is none. Cost O(n). Where the monitor
/// asks to stop the answer has no meaning.
std::string CheckSegmentCover(
  const Domain& domain, const SegmentCoverInput& mesh, Monitor& monitor = NoMonitor());

} // namespace biting

#endif
