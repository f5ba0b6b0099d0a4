// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingGroundNormals_h
#define BitingGroundNormals_h

#include "../Features/GroundPatches.h"
#include "BodyTets.h"

#include <vector> // for stars

namespace biting
{

/// What changes of the boundary the ground allows: new facets turn from the ground's normals at
/// their vertices by no more than 37 degrees, or than those before them did.
class GroundNormals
{
public:
  GroundNormals(const SurfaceGround& ground, RelaxedBody& body)
    : Ground(ground)
    , Patches(ground)
    , Body(body)
  {
  }

  /// The nearest place of the patch on which the vertex of the boundary lies.
  GroundPlace Project(Id vertex, const Point3& place) const
  {
    return this->Patches.Project(this->Body.BoundaryPlaces[At(vertex)], place);
  }

  /// `star`: slots of the vertex.
  bool AllowsMove(
    const BodyTets& tets, const std::vector<Id>& star, Id vertex, const GroundPlace& place) const;

  /// `facets`: two before, two after.
  bool AllowsFlip(const BodyTets& tets, const std::array<std::array<Id, 3>, 4>& facets) const;

  void Move(Id vertex, const GroundPlace& place)
  {
    this->Body.BoundaryPlaces[At(vertex)] = place.Triangle;
    this->Body.Sizes[At(vertex)] = this->Ground.SizeAt(place.Triangle, place.Place);
  }

private:
  double Agreement(const std::array<Point3, 3>& places, const std::array<Id, 3>& triangles) const;

  const SurfaceGround& Ground;
  GroundPatches Patches;
  RelaxedBody& Body;
};

} // namespace biting

#endif
