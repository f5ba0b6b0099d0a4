// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingGroundNormals_h
#define BitingGroundNormals_h

#include "../Features/GroundPatches.h"
#include "../Relaxation/ChainPlaces.h"
#include "BodyTets.h"

#include <vector> // for stars

namespace biting
{

/// The changes of the boundary that the ground allows: the angles between the normal of a new facet
/// and those of the ground at its vertices are at most 45 degrees, or that of the facets before;
/// where vertices go, or slide on lines, the ground is at most a tenth of f away, or as far as it
/// was.
class GroundNormals
{
public:
  GroundNormals(const SurfaceGround& ground, BodyTets& tets)
    : Ground(ground)
    , Patches(ground)
    , Tets(tets)
    , Chains(ChainsOf(tets))
    , Places(ground, this->Chains, tets.Mesh.Points)
  {
  }

  /// Whether a vertex on a line may slide along it.
  bool Slides(Id vertex) const
  {
    return this->Places.IsOn(vertex) && this->Tets.Lines.PiecesOf(vertex)[0] != NoId;
  }

  /// A facet, and what it becomes: its corner `From` goes to a place.
  struct FacetChange
  {
    Id Record;
    std::array<Id, 3> Corners;
    Id From;
  };

  /// The place of the chain, or the patch, of a vertex of the boundary that is nearest to the
  /// place: a local minimum.
  GroundPlace Project(Id vertex, const Point3& place) const;

  /// The nearest place of the patch of a record.
  GroundPlace ProjectOnFacet(Id record, const Point3& place) const
  {
    return this->Patches.Project(this->Tets.Body.FacetPlaces[At(record)], place);
  }

  /// Whether a vertex may slide there.
  bool AllowsMove(Id vertex, const GroundPlace& place) const;

  /// Whether the facets may be replaced by those with `to`, at the place, for From: a vertex, or
  /// NoId for one that is new, on no line.
  bool AllowsChange(const std::vector<FacetChange>& changes, Id to, const GroundPlace& place) const;

  /// Whether AllowsChange, and the ground stays near: facets of one vertex that goes to `to`.
  bool AllowsMerge(const std::vector<FacetChange>& changes, Id vertex, Id to) const;

  /// Whether two facets may become two others.
  bool AllowsFlip(const std::array<std::array<Id, 3>, 2>& before,
    const std::array<std::array<Id, 3>, 2>& after) const;

  /// Notes that the vertex is there now.
  void Move(Id vertex, const GroundPlace& place);

private:
  /// Corners of a facet, and the triangle of the ground at each, NoId on lines.
  struct Facet
  {
    std::array<Point3, 3> Places;
    std::array<Id, 3> Triangles;

    Point3 Normal() const;
  };

  Facet FacetOf(const std::array<Id, 3>& corners) const;
  Facet Changed(const FacetChange& change, const GroundPlace& place) const;
  bool AllowsFacet(const Facet& before, const Facet& after) const;
  double Agreement(const Facet& facet) const;
  bool AllowsSlide(Id vertex, const Point3& place) const;
  double DistanceOf(Id record, const Facet& facet) const;
  static std::vector<Id> ChainsOf(const BodyTets& tets);

  const SurfaceGround& Ground;
  GroundPatches Patches;
  BodyTets& Tets;
  std::vector<Id> Chains; ///< of vertices
  ChainPlaces Places;
};

} // namespace biting

#endif
