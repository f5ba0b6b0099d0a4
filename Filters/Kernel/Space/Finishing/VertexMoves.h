// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingVertexMoves_h
#define BitingVertexMoves_h

#include "../../Base/Numbers.h"
#include "BodyTets.h"
#include "CellChange.h"
#include "GroundNormals.h"

#include <array>      // for links
#include <functional> // for f
#include <vector>     // for scratch

namespace biting
{

/// Moves of single vertices of a body. Each keeps the tetrahedra at the vertex positive, exactly.
class VertexMoves
{
public:
  VertexMoves(BodyTets& tets, GroundNormals& normals, const std::function<double(const Point3&)>& f)
    : Tets(tets)
    , Normals(normals)
    , Size(f)
  {
  }

  /// Moves a vertex to a mean, or half the way. Inside, of the centres of the spheres of its
  /// tetrahedra, weighted by volume / f^3: where piecewise linear interpolation of |x|^2 has the
  /// least error (L. Chen, J. Xu, "Optimal Delaunay triangulations", 2004; P. Alliez et al.,
  /// "Variational tetrahedral meshing", 2005). On the boundary, of the middles of its facets,
  /// weighted by area / f^4, on the ground. No move may make the worst Badness at the vertex higher
  /// than both before and `good`. Precondition: the vertex is on no line.
  bool Smooth(Id vertex, double good);

  /// Moves a vertex so that the worst of its tetrahedra gets better, by trial in directions with
  /// steps that get smaller, until it is better than `good`: inside, or on its patch of the ground.
  /// Those on lines slide along them; corners stay.
  bool Improve(Id vertex, double good);

  /// Merges a vertex into `other`, of a common cell, which replaces it in its cells. If both are
  /// inside, `other` moves to where the worst of the cells about both is best. A vertex of the
  /// boundary goes along an edge of its patch, or chain, where GroundNormals allows it.
  bool Merge(Id vertex, Id other);

  /// Undoes what was noted, which ends.
  void TakeBack();

private:
  /// A tetrahedron at the vertex, by the facet opposite: its slot and corners.
  struct Cone
  {
    double Badness;
    double Tried; ///< Badness at the place that is tried
    Id Slot;
    Point3 A, B, C;
  };

  void GatherBut(Id vertex, Id other);
  double WorstAt(const Point3& place, double limit);
  double Load(double Cone::*badness) const;
  void Move(Id vertex, const Point3& place);
  void Join(Id vertex, Id gone);
  bool FindFacets(Id vertex, Id other);
  using LinkItem = std::array<Id, 3>;
  void FindLink(Id vertex, Id other, bool isAtEdge, std::vector<LinkItem>& link);
  bool IsMergeable(Id vertex, Id other);
  bool Try(Id vertex, const Point3& place, double limit);
  Point3 WayInside(const Point3& place) const;
  Point3 WayOnGround(Id vertex) const;

  double Worst() const { return this->Star.front().Badness; }

  BodyTets& Tets;
  GroundNormals& Normals;
  const std::function<double(const Point3&)>& Size;
  std::vector<Cone> Star; ///< the worst comes first
  double MostLoad = Infinity;
  CellChange Change;
  std::vector<GroundNormals::FacetChange> Facets; ///< that change where a vertex goes
  std::array<std::vector<LinkItem>, 4> Links;
};

} // namespace biting

#endif
