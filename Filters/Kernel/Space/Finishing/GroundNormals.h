// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingGroundNormals_h
#define BitingGroundNormals_h

#include "../Features/GroundPatches.h"
#include "BodyTets.h"

#include <vector> // for stars

namespace biting
{

/// The changes of the boundary that the ground allows: the angles between the normal of a new facet
/// and those of the ground at its vertices are at most 45 degrees, or that of the facets before.
class GroundNormals
{
public:
  GroundNormals(const SurfaceGround& ground, RelaxedBody& body)
    : Ground(ground)
    , Patches(ground)
    , Body(body)
  {
  }

  /// GroundPatches::Project, on the patch of the vertex, which is of the boundary.
  GroundPlace Project(Id vertex, const Point3& place) const
  {
    return this->Patches.Project(this->Body.BoundaryPlaces[At(vertex)], place);
  }

  /// `star`: slots of the vertex.
  bool AllowsMove(
    const BodyTets& tets, const std::vector<Id>& star, Id vertex, const GroundPlace& place) const;

  /// Whether two facets may become two others.
  bool AllowsFlip(const BodyTets& tets, const std::array<std::array<Id, 3>, 2>& before,
    const std::array<std::array<Id, 3>, 2>& after) const;

  void Move(Id vertex, const GroundPlace& place)
  {
    this->Body.BoundaryPlaces[At(vertex)] = place.Triangle;
    this->Body.Sizes[At(vertex)] = this->Ground.SizeAt(place.Triangle, place.Place);
  }

private:
  /// Corners of a facet, and the triangle of the ground at each, NoId on lines.
  struct Facet
  {
    std::array<Point3, 3> Places;
    std::array<Id, 3> Triangles;

    Point3 Normal() const;
  };

  Facet FacetOf(const BodyTets& tets, const std::array<Id, 3>& corners) const;
  double Agreement(const Facet& facet) const;

  const SurfaceGround& Ground;
  GroundPatches Patches;
  RelaxedBody& Body;
};

} // namespace biting

#endif
