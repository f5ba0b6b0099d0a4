// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "GroundNormals.h"

#include "../Surface/NearestOnTriangle.h"

#include <algorithm> // for all_of, any_of, find, max, min
#include <cmath>     // for abs
#include <iterator>  // for begin, end

namespace biting
{

namespace
{

constexpr double LeastAgreement = 0.7071067811865476; // the cosine of 45 degrees
constexpr double MostDistance = 0.1; // in f: the default of BoundaryTolerance, which caps f

} // namespace

std::vector<Id> GroundNormals::ChainsOf(const BodyTets& tets)
{
  std::vector<Id> chains(tets.Mesh.Points.size(), NoId);
  for (Id vertex = 0; vertex < tets.Body.NumberOnLines; ++vertex)
  {
    const Id piece = tets.Lines.PiecesOf(vertex)[0];
    chains[At(vertex)] = piece == NoId ? NoId : tets.Body.PieceChains[At(piece)];
  }
  return chains;
}

Point3 GroundNormals::Facet::Normal() const
{
  const Point3 normal = Cross(this->Places[1] - this->Places[0], this->Places[2] - this->Places[0]);
  const double length = Length(normal);
  return length > 0.0 ? (1.0 / length) * normal : Point3{};
}

GroundNormals::Facet GroundNormals::FacetOf(const std::array<Id, 3>& corners) const
{
  Facet facet;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Id corner = corners[k];
    facet.Places[k] = this->Tets.Mesh.PointAt(corner);
    facet.Triangles[k] = this->Tets.Kinds[At(corner)] == BodyTets::Kind::OnLine
      ? NoId
      : this->Tets.Body.BoundaryPlaces[At(corner)];
  }
  return facet;
}

GroundNormals::Facet GroundNormals::Changed(
  const FacetChange& change, const GroundPlace& place) const
{
  Facet facet = this->FacetOf(change.Corners);
  const auto k = static_cast<std::size_t>(
    std::find(change.Corners.begin(), change.Corners.end(), change.From) - change.Corners.begin());
  facet.Places[k] = place.Place;
  facet.Triangles[k] = place.Triangle;
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

bool GroundNormals::AllowsFacet(const Facet& before, const Facet& after) const
{
  return Dot(before.Normal(), after.Normal()) >= LeastAgreement &&
    this->Agreement(after) >= std::min(LeastAgreement, this->Agreement(before));
}

GroundPlace GroundNormals::Project(Id vertex, const Point3& place) const
{
  if (this->Tets.Kinds[At(vertex)] != BodyTets::Kind::OnLine)
  {
    return this->Patches.Project(this->Tets.Body.BoundaryPlaces[At(vertex)], place);
  }
  const ChainPlace there = this->Places.Project(vertex, place);
  const Id tail = this->Ground.Chains.At(there.Edge - 1);
  return { this->Ground.TrianglesAt[tail][0], there.Place };
}

bool GroundNormals::AllowsMove(Id vertex, const GroundPlace& place) const
{
  const bool isOnLine = this->Tets.Kinds[At(vertex)] == BodyTets::Kind::OnLine;
  std::vector<FacetChange> changes;
  for (const Id slot : this->Tets.FacetsAt(vertex))
  {
    changes.push_back({ this->Tets.RecordOf(slot), this->Tets.FacetCorners(slot), vertex });
  }
  return this->AllowsChange(changes, vertex, place) &&
    (!isOnLine || this->AllowsSlide(vertex, place.Place));
}

/// Whether the chain stays near the pieces at the vertex: at their middles.
bool GroundNormals::AllowsSlide(Id vertex, const Point3& place) const
{
  const RelaxedBody& body = this->Tets.Body;
  double before = MostDistance * body.Sizes[At(vertex)];
  double after = 0.0;
  for (const Id piece : this->Tets.Lines.PiecesOf(vertex))
  {
    const Point3& end = this->Tets.Mesh.PointAt(this->Tets.Lines.OtherEnd(piece, vertex));
    const auto distanceAt = [this, vertex](const Point3& middle)
    { return Distance(this->Places.Project(vertex, middle).Place, middle); };
    before = std::max(before, distanceAt(Midpoint(this->Tets.Mesh.PointAt(vertex), end)));
    after = std::max(after, distanceAt(Midpoint(place, end)));
  }
  return after <= before;
}

bool GroundNormals::AllowsChange(
  const std::vector<FacetChange>& changes, Id to, const GroundPlace& place) const
{
  const Id triangle =
    to != NoId && this->Tets.Kinds[At(to)] == BodyTets::Kind::OnLine ? NoId : place.Triangle;
  return std::all_of(changes.begin(), changes.end(),
    [this, triangle, &place](const FacetChange& change)
    {
      return this->AllowsFacet(
        this->FacetOf(change.Corners), this->Changed(change, { triangle, place.Place }));
    });
}

bool GroundNormals::AllowsMerge(const std::vector<FacetChange>& changes, Id vertex, Id to) const
{
  const Point3& old = this->Tets.Mesh.PointAt(vertex);
  const GroundPlace place{ this->Tets.Body.BoundaryPlaces[At(to)], this->Tets.Mesh.PointAt(to) };
  const double most = MostDistance * this->Tets.Body.Sizes[At(to)];
  double least = Infinity; // of the old place, of the facets
  for (const FacetChange& change : changes)
  {
    const Facet after = this->Changed(change, place);
    least = std::min(least, Distance(NearestPoint(after.Places, old), old));
    const double before = this->DistanceOf(change.Record, this->FacetOf(change.Corners));
    if (this->DistanceOf(change.Record, after) > std::max(most, before))
    {
      return false;
    }
  }
  return least <= most && this->AllowsChange(changes, to, place);
}

/// From the middle of a facet to the ground.
double GroundNormals::DistanceOf(Id record, const Facet& facet) const
{
  const Point3 middle = (1.0 / 3.0) * (facet.Places[0] + facet.Places[1] + facet.Places[2]);
  return Distance(this->ProjectOnFacet(record, middle).Place, middle);
}

bool GroundNormals::AllowsFlip(const std::array<std::array<Id, 3>, 2>& before,
  const std::array<std::array<Id, 3>, 2>& after) const
{
  const Facet old[2] = { this->FacetOf(before[0]), this->FacetOf(before[1]) };
  const double limit =
    std::min(LeastAgreement, std::min(this->Agreement(old[0]), this->Agreement(old[1])));
  const Facet facets[2] = { this->FacetOf(after[0]), this->FacetOf(after[1]) };
  return Dot(facets[0].Normal(), facets[1].Normal()) > LeastAgreement &&
    std::all_of(std::begin(facets), std::end(facets),
      [this, &old, limit](const Facet& facet)
      {
        return this->Agreement(facet) >= limit && Dot(facet.Normal(), old[0].Normal()) > 0.0 &&
          Dot(facet.Normal(), old[1].Normal()) > 0.0;
      });
}

void GroundNormals::Move(Id vertex, const GroundPlace& place)
{
  this->Tets.Body.BoundaryPlaces[At(vertex)] = place.Triangle;
  if (this->Tets.Kinds[At(vertex)] != BodyTets::Kind::OnLine)
  {
    this->Tets.Body.Sizes[At(vertex)] = this->Ground.SizeAt(place.Triangle, place.Place);
  }
  else if (this->Places.IsOn(vertex))
  {
    this->Places.Move(vertex, this->Places.Project(vertex, place.Place).Edge);
  }
}

} // namespace biting
