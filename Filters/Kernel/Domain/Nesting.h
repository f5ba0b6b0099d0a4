// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingNesting_h
#define BitingNesting_h

#include "../Base/Ids.h"
#include "../Base/Point.h"
#include "../Base/Pulse.h"
#include "SegmentTree.h" // for SegmentEnds

#include <cstdint> // for flags
#include <vector>  // for the arrays

namespace biting
{

/// What lies inside the even-odd region.
struct InsideFlags
{
  std::vector<std::uint8_t> Left;     ///< of each segment
  std::vector<std::uint8_t> Right;    ///< of each segment
  std::vector<std::uint8_t> Vertices; ///< of vertices without segments; 0 for others
};

/// Finds the sides of every segment, and the place of lone vertices, by a sweep over the vertices
/// in lexicographic order. Crossing a segment with `bounds` changes between outside and inside;
/// loops and their orientation play no part. All comparisons are exact. Precondition: segments meet
/// at common ends only; vertices are distinct and lie on no segment but those they end. Cost O(n
/// log n). Source: M. I. Shamos, D. Hoey, "Geometric intersection problems", 1976 (the sweep).
InsideFlags FindInside(const std::vector<Point2>& vertices,
  const std::vector<SegmentEnds>& segments, const std::vector<std::uint8_t>& bounds, Pulse& pulse);

/// How many things cover the plane beside segments, and which segment lies below which.
struct SegmentDepths
{
  std::vector<Id> Steps; ///< of each segment: the depth just above it less that just below it
  std::vector<Id> Above; ///< of each segment: the depth just above it
  std::vector<Id> Below; ///< of each segment: the one just below its left end; NoId: none
  std::vector<Id> Order; ///< the segments by their left ends, and from below to above
};

/// The same sweep for a depth that changes by `turns` from the right to the left of a segment, and
/// is 0 outside. Empty where the monitor wants to stop.
SegmentDepths FindDepths(const std::vector<Point2>& vertices,
  const std::vector<SegmentEnds>& segments, const std::vector<Id>& turns, Pulse& pulse);

} // namespace biting

#endif
