// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "OldPlaces.h"

#include "../Spacing/TriangleBuckets.h"

#include <algorithm> // for min, max
#include <limits>    // for infinity
#include <numeric>   // for iota

namespace biting
{

namespace
{

class Search
{
public:
  Search(const OldMesh& mesh, const std::vector<Id>& triangles, Pulse& pulse)
    : Triangles(triangles)
    , Places(PlacesOf(mesh, triangles))
    , Buckets(this->Places, pulse)
    , All(triangles.size())
  {
    std::iota(this->All.begin(), this->All.end(), 0);
  }

  OldPlace Find(const Point2& place) const
  {
    const TriangleBuckets::Range near = this->Buckets.Near(place);
    const bool isEmpty = near.First == near.Last;
    return isEmpty ? this->FindAmong(this->All, place) : this->FindAmong(near, place);
  }

private:
  static std::vector<TriangleBuckets::Corners> PlacesOf(
    const OldMesh& mesh, const std::vector<Id>& triangles);
  template <typename Candidates>
  OldPlace FindAmong(const Candidates& candidates, const Point2& place) const;
  std::array<double, 3> WeightsIn(Id candidate, const Point2& place) const;

  const std::vector<Id>& Triangles;
  std::vector<TriangleBuckets::Corners> Places;
  TriangleBuckets Buckets;
  std::vector<Id> All;
};

std::vector<TriangleBuckets::Corners> Search::PlacesOf(
  const OldMesh& mesh, const std::vector<Id>& triangles)
{
  std::vector<TriangleBuckets::Corners> places;
  for (const Id triangle : triangles)
  {
    const Id* corners = mesh.Corners.data() + 3 * static_cast<std::size_t>(triangle);
    places.push_back({ mesh.Points[corners[0]], mesh.Points[corners[1]], mesh.Points[corners[2]] });
  }
  return places;
}

std::array<double, 3> Search::WeightsIn(Id candidate, const Point2& place) const
{
  const TriangleBuckets::Corners& corners = this->Places[candidate];
  const double whole = Cross(corners[1] - corners[0], corners[2] - corners[0]);
  const double second = Cross(place - corners[0], corners[2] - corners[0]) / whole;
  const double third = Cross(corners[1] - corners[0], place - corners[0]) / whole;
  return { 1.0 - second - third, second, third };
}

// The one whose least weight is the largest: not negative in the triangle that holds the place.
template <typename Candidates>
OldPlace Search::FindAmong(const Candidates& candidates, const Point2& place) const
{
  OldPlace best;
  double largest = -std::numeric_limits<double>::infinity();
  for (const Id candidate : candidates)
  {
    const std::array<double, 3> weights = this->WeightsIn(candidate, place);
    const double least = std::min({ weights[0], weights[1], weights[2] });
    if (least > largest)
    {
      largest = least;
      best = { this->Triangles[candidate], weights };
    }
  }
  double sum = 0.0;
  for (double& weight : best.Weights)
  {
    weight = std::max(weight, 0.0);
    sum += weight;
  }
  for (double& weight : best.Weights)
  {
    weight /= sum;
  }
  return best;
}

} // namespace

std::vector<OldPlace> FindOldPlaces(const OldMesh& mesh, const std::vector<Id>& triangles,
  const std::vector<Point2>& places, Pulse& pulse)
{
  std::vector<OldPlace> found;
  if (places.empty())
  {
    return found;
  }
  const Search search(mesh, triangles, pulse);
  if (!pulse.HasStopped())
  {
    found.reserve(places.size());
    pulse.ForEach(places.size(),
      [&search, &places, &found](std::size_t k) { found.push_back(search.Find(places[k])); });
  }
  return found;
}

} // namespace biting
