// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingFreeEdges_h
#define BitingFreeEdges_h

#include "../Base/Point2.h"
#include "../Base/Pulse.h"
#include "../Domain/SegmentTree.h" // for SegmentEnds
#include "OldMesh.h"

#include <vector> // for the arrays

namespace biting
{

/// The edges of one triangle of a mesh, by themselves: in the order of their slots, left of them
/// the triangles where these are counterclockwise.
struct FreeEdges
{
  explicit FreeEdges(const OldMesh& mesh);

  /// Whether each is longer than twice `distance`, and comes so near to no other but where they
  /// share an end, nor the other end of one of these to the other. What rounding does not tell
  /// apart is near. False also where more than four end at one vertex, and where the monitor wants
  /// to stop. Cost O(n log n).
  bool AreApart(double distance, Pulse& pulse) const;

  /// Whether the plane is covered once left of each of them, and not at all right of it: then the
  /// triangles, which lie left of them, do not overlap. Decided exactly. Precondition: they meet in
  /// common ends only. False where the monitor wants to stop. Cost O(n log n).
  bool BoundOnce(Pulse& pulse) const;

  double Length() const;
  double Area() const; ///< left of them

  std::vector<Point2> Points; ///< their ends only
  std::vector<SegmentEnds> Ends;
};

} // namespace biting

#endif
