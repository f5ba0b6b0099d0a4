// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "GroundNormals.h"

#include <algorithm> // for all_of, find, min
#include <cmath>     // for abs
#include <iterator>  // for begin, end

namespace biting
{

namespace
{

constexpr double LeastAgreement = 0.7071067811865476; // the cosine of 45 degrees

} // namespace

Point3 GroundNormals::Facet::Normal() const
{
  const Point3 normal = Cross(this->Places[1] - this->Places[0], this->Places[2] - this->Places[0]);
  const double length = Length(normal);
  return length > 0.0 ? (1.0 / length) * normal : Point3{};
}

GroundNormals::Facet GroundNormals::FacetOf(
  const BodyTets& tets, const std::array<Id, 3>& corners) const
{
  Facet facet;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Id corner = corners[k];
    facet.Places[k] = tets.Mesh.PointAt(corner);
    facet.Triangles[k] =
      corner < this->Body.NumberOnLines ? NoId : this->Body.BoundaryPlaces[At(corner)];
  }
  return facet;
}

/// The least cosine between the normal and those of the ground at corners, of either side; 1 where
/// all are on lines.
double GroundNormals::Agreement(const Facet& facet) const
{
  const Point3 normal = facet.Normal();
  double least = 1.0;
  for (const Id triangle : facet.Triangles)
  {
    const double cosine =
      triangle == NoId ? 1.0 : std::abs(Dot(normal, this->Ground.NormalOf(At(triangle))));
    least = std::min(least, cosine);
  }
  return least;
}

bool GroundNormals::AllowsMove(
  const BodyTets& tets, const std::vector<Id>& star, Id vertex, const GroundPlace& place) const
{
  for (const Id own : star)
  {
    for (Id slot = own & ~3; slot < (own & ~3) + 4; ++slot)
    {
      if (slot == own || tets.RecordOf(slot) < 0)
      {
        continue;
      }
      const std::array<Id, 3> corners = tets.FacetCorners(slot);
      const Facet before = this->FacetOf(tets, corners);
      Facet after = before;
      const auto k = static_cast<std::size_t>(
        std::find(corners.begin(), corners.end(), vertex) - corners.begin());
      after.Places[k] = place.Place;
      after.Triangles[k] = place.Triangle;
      if (Dot(before.Normal(), after.Normal()) < LeastAgreement ||
        this->Agreement(after) < std::min(LeastAgreement, this->Agreement(before)))
      {
        return false;
      }
    }
  }
  return true;
}

bool GroundNormals::AllowsFlip(const BodyTets& tets, const std::array<std::array<Id, 3>, 2>& before,
  const std::array<std::array<Id, 3>, 2>& after) const
{
  const Facet old[2] = { this->FacetOf(tets, before[0]), this->FacetOf(tets, before[1]) };
  const double limit =
    std::min(LeastAgreement, std::min(this->Agreement(old[0]), this->Agreement(old[1])));
  const Facet facets[2] = { this->FacetOf(tets, after[0]), this->FacetOf(tets, after[1]) };
  return Dot(facets[0].Normal(), facets[1].Normal()) > LeastAgreement &&
    std::all_of(std::begin(facets), std::end(facets),
      [this, &old, limit](const Facet& facet)
      {
        return this->Agreement(facet) >= limit && Dot(facet.Normal(), old[0].Normal()) > 0.0 &&
          Dot(facet.Normal(), old[1].Normal()) > 0.0;
      });
}

} // namespace biting
