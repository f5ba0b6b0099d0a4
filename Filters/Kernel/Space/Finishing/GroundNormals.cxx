// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "GroundNormals.h"

#include <algorithm> // for min

namespace biting
{

namespace
{

constexpr double LeastAgreement = 0.8; // the cosine of 37 degrees

Point3 UnitNormal(const std::array<Point3, 3>& t)
{
  const Point3 normal = Cross(t[1] - t[0], t[2] - t[0]);
  const double length = Length(normal);
  return length > 0.0 ? (1.0 / length) * normal : Point3{};
}

} // namespace

/// The least cosine between the normal and those of the ground at corners that lie on no line, of
/// either side; 1 where there is no such corner. `triangles`: of the ground, NoId at lines.
double GroundNormals::Agreement(
  const std::array<Point3, 3>& places, const std::array<Id, 3>& triangles) const
{
  const Point3 normal = UnitNormal(places);
  double least = 1.0;
  for (const Id triangle : triangles)
  {
    least = triangle == NoId
      ? least
      : std::min(least, std::abs(Dot(normal, this->Ground.NormalOf(At(triangle)))));
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
      std::array<Point3, 3> before;
      std::array<Point3, 3> after;
      std::array<Id, 3> triangles{ NoId, NoId, NoId };
      std::array<Id, 3> newTriangles{ NoId, NoId, NoId };
      for (std::size_t k = 0; k < 3; ++k)
      {
        const Id corner = tets.Mesh.FacetCorner(slot, static_cast<int>(k));
        const bool isFree = corner >= this->Body.NumberOnLines;
        before[k] = tets.Mesh.PointAt(corner);
        after[k] = corner == vertex ? place.Place : before[k];
        triangles[k] = isFree ? this->Body.BoundaryPlaces[At(corner)] : NoId;
        newTriangles[k] = corner == vertex ? place.Triangle : triangles[k];
      }
      if (Dot(UnitNormal(before), UnitNormal(after)) < LeastAgreement ||
        this->Agreement(after, newTriangles) <
          std::min(LeastAgreement, this->Agreement(before, triangles)))
      {
        return false;
      }
    }
  }
  return true;
}

bool GroundNormals::AllowsFlip(
  const BodyTets& tets, const std::array<std::array<Id, 3>, 4>& facets) const
{
  std::array<double, 4> agreements{};
  std::array<Point3, 4> normals;
  for (std::size_t f = 0; f < 4; ++f)
  {
    std::array<Point3, 3> places;
    std::array<Id, 3> triangles{ NoId, NoId, NoId };
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Id corner = facets[f][k];
      places[k] = tets.Mesh.PointAt(corner);
      triangles[k] =
        corner >= this->Body.NumberOnLines ? this->Body.BoundaryPlaces[At(corner)] : NoId;
    }
    normals[f] = UnitNormal(places);
    agreements[f] = this->Agreement(places, triangles);
  }
  const double between = std::min(Dot(normals[2], normals[3]),
    std::min(Dot(normals[0], normals[2]), Dot(normals[1], normals[3])));
  return between > LeastAgreement &&
    std::min(agreements[2], agreements[3]) >=
    std::min(LeastAgreement, std::min(agreements[0], agreements[1]));
}

} // namespace biting
