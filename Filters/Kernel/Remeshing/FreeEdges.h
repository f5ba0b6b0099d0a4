// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingFreeEdges_h
#define BitingFreeEdges_h

#include "../Base/Point.h"
#include "../Base/Pulse.h"
#include "../Domain/SegmentTree.h" // for SegmentEnds
#include "OldMesh.h"

#include <cstdint> // for flags
#include <vector>  // for the arrays

namespace biting
{

/// The edges of one triangle of a mesh, by themselves: in the order of their slots, left of them
/// the triangles where these are counterclockwise.
struct FreeEdges
{
  explicit FreeEdges(const OldMesh& mesh);

  /// Flags, one an edge, of those that are not longer than twice `distance`, or come so near to
  /// another, but where they share an end: then they are near where the other end of one is near to
  /// the other. What rounding does not tell apart is near, and so are edges of which more than four
  /// end at one vertex; all are where most have very many others about them. Cost O(n log n).
  std::vector<std::uint8_t> FindNear(double distance, Pulse& pulse) const;

  /// Whether none is. False where the monitor wants to stop. Cost O(n log n).
  bool AreApart(double distance, Pulse& pulse) const;

  /// Whether the plane is covered once left of each of them, and not at all right of it: then the
  /// triangles, which lie left of them, do not overlap. Decided exactly. Precondition: they meet in
  /// common ends only. False where the monitor wants to stop. Cost O(n log n).
  bool BoundOnce(Pulse& pulse) const;

  double LengthOf(const std::vector<std::uint8_t>& isCounted) const;
  double Area() const; ///< left of them

  std::vector<Point2> Points; ///< their ends only
  std::vector<SegmentEnds> Ends;
};

} // namespace biting

#endif
