// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingTriangleBuckets_h
#define BitingTriangleBuckets_h

#include "../Base/IdLists.h"
#include "../Base/Pulse.h"
#include "Orthtree.h"

#include <vector> // for the arrays

namespace biting
{

/// Which triangles may contain a point, for triangles of very different sizes: a quadtree whose
/// leaves list the triangles that meet them. Cost: n log n to build; a lookup and a handful of
/// triangles for a point, more where many triangles are long or meet at one vertex.
class TriangleBuckets
{
public:
  /// Of three corners a triangle: at least one, and each has an area.
  /// Incomplete if the pulse stops: it must not be asked then.
  TriangleBuckets(const std::vector<Point2>& points, const std::vector<Id>& corners, Pulse& pulse);

  /// All triangles that meet the leaf of x; outside, those of the nearest leaf along the axes.
  IdLists::List Near(const Point2& x) const
  {
    const Id* list = &this->Lists[this->Tree.Locate(x)];
    return { list + 1, list + 1 + *list };
  }

private:
  class Builder;

  Orthtree<2> Tree;           ///< the number of a leaf is where its list starts in Lists
  std::vector<Id> Lists{ 0 }; ///< each is a count, and as many triangles
};

} // namespace biting

#endif
