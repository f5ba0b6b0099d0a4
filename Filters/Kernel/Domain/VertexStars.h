// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingVertexStars_h
#define BitingVertexStars_h

#include "../Base/Ids.h"
#include "../Base/Point.h"
#include "SegmentTree.h" // for SegmentEnds

#include <vector> // for the arrays

namespace biting
{

/// The segments at each vertex, sorted counterclockwise, exactly.
///
/// The order begins just after straight down: first the segments that lead to lexicographically
/// greater points ("right", from below to above), then those that lead to smaller ones ("left",
/// from above to below). Segments of equal direction are sorted by their number.
class VertexStars
{
public:
  /// A segment as a vertex sees it: with its other end.
  struct Ray
  {
    Point2 Far;
    Id Segment = NoId;
  };

  /// Where the monitor wants to stop, the order is not yet that.
  VertexStars(
    const std::vector<Point2>& points, const std::vector<SegmentEnds>& segments, Pulse& pulse);

  Id NumberOfVertices() const { return static_cast<Id>(this->Offsets.size()) - 1; }
  const Id* Begin(Id vertex) const { return this->Segments.data() + this->Offset(vertex); }
  const Id* End(Id vertex) const { return this->Segments.data() + this->Offset(vertex + 1); }
  Id Degree(Id vertex) const { return this->Offset(vertex + 1) - this->Offset(vertex); }

  /// The next segment counterclockwise after `segment` around `vertex`.
  Id Next(Id vertex, Id segment) const;

private:
  void SortStar(Id vertex, const std::vector<Point2>& points,
    const std::vector<SegmentEnds>& segments, std::vector<Ray>& rays, Pulse& pulse);
  Id Offset(Id vertex) const { return this->Offsets[vertex]; }

  std::vector<Id> Offsets;
  std::vector<Id> Segments;
};

/// The other end of a segment that ends at `vertex`.
inline Id OtherEnd(const SegmentEnds& ends, Id vertex)
{
  return ends.Start == vertex ? ends.End : ends.Start;
}

} // namespace biting

#endif
