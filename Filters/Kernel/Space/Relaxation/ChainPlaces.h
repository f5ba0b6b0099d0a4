// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingChainPlaces_h
#define BitingChainPlaces_h

#include "../Features/SurfaceGround.h"

#include <vector> // for the edges

namespace biting
{

/// A place on a chain of the ground.
struct ChainPlace
{
  Id Edge; ///< FeatureChains::Vertices[Edge - 1] and [Edge] are its ends; NoId: on none
  Point3 Place;
};

/// Where vertices are on the chains that they slide along.
class ChainPlaces
{
public:
  /// `chains`: of each point, the chain; or NoId. Quick where points of a chain are in its order.
  ChainPlaces(
    const SurfaceGround& ground, const std::vector<Id>& chains, const std::vector<Point3>& points);

  bool IsOn(Id vertex) const { return this->Edges[At(vertex)] != NoId; }

  /// The place of the vertex's chain that is nearest to `place`, by descent along it: a local
  /// minimum. Chains that are no rings end at their corners.
  ChainPlace Project(Id vertex, const Point3& place) const;

  /// Of the chain at the vertex; of length 1.
  Point3 DirectionAt(Id vertex) const;

  void Move(Id vertex, Id edge) { this->Edges[At(vertex)] = edge; }

private:
  Point3 Nearest(Id edge, const Point3& place) const;
  bool IsRing(Id chain) const;
  Id Neighbor(Id chain, Id edge, Id step) const;

  const SurfaceGround& Ground;
  const std::vector<Id>& Chains;
  std::vector<Id> Edges; ///< of points
};

} // namespace biting

#endif
