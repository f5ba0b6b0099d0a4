// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingInnerPlaces_h
#define BitingInnerPlaces_h

#include "../Base/BoxTree.h"
#include "ChangedRegion.h"
#include "OldMesh.h"
#include "RegionEdges.h"

#include <vector> // for the list

namespace biting
{

/// The places of the old vertices within the region, those on edges and fixed ones apart: an inner
/// vertex of the new mesh that is at one of them is the old one. Build O(n log n), queries
/// O(log n).
class InnerPlaces
{
public:
  /// On abort it must not be asked.
  InnerPlaces(
    const OldMesh& mesh, const ChangedRegion& region, const RegionEdges& edges, Pulse& pulse);

  /// The nearest one within reach, or null.
  const Point2* FindNear(const Point2& place, double reach) const;

  /// The old vertex that is exactly at `place`, or NoId.
  Id FindAt(const Point2& place) const;

private:
  /// As an item of the tree: a box without extent.
  struct OldPlace
  {
    Point2 Place;
    Id Point;

    Box2 Box() const { return { this->Place, this->Place }; }
    double Least() const { return 0.0; }
  };

  static std::vector<OldPlace> List(
    const OldMesh& mesh, const ChangedRegion& region, const RegionEdges& edges);
  const OldPlace* FindNearest(const Point2& place, double reach) const;

  BoxTree<OldPlace> Tree;
};

} // namespace biting

#endif
