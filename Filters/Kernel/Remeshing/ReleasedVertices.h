// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingReleasedVertices_h
#define BitingReleasedVertices_h

#include "../Base/BoxTree.h"
#include "../Biting/BitingScheme.h"
#include "../Delaunay/Triangulation.h"
#include "../Domain/Domain.h"
#include "ChangedRegion.h"
#include "OldMesh.h"
#include "RegionEdges.h"

#include <cstdint> // for flags
#include <vector>  // for the arrays

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

/// 1 for the embedded vertices of the domain, fixed ones apart.
std::vector<std::uint8_t> FindVerticesThatMayGo(const OldMesh& old, const Domain& domain);

/// 1 for those of no old mesh.
std::vector<std::uint8_t> FindAddedVertices(const Domain& domain);

/// Takes these vertices out of the domain: they become inner vertices of the mesh like new ones.
void ReleaseVertices(const std::vector<std::uint8_t>& isReleased, Domain& domain,
  BitingResult& bites, Triangulation& mesh);

/// The points of those of the flagged vertices that are of the old mesh, in their order.
std::vector<Id> ListHeld(const std::vector<std::uint8_t>& isHeld, const Domain& domain);

/// The inverse of ReleaseVertices, for inner vertices that are at one of `places`: they are
/// vertices of the domain, after the others.
void ReturnVertices(
  const InnerPlaces& places, Domain& domain, BitingResult& bites, Triangulation& mesh);

} // namespace biting

#endif
