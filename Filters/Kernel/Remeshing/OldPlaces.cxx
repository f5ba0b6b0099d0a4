// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "OldPlaces.h"

#include "../Spacing/TriangleBuckets.h"
#include "../Spacing/TriangleInterpolator.h"

#include <algorithm> // for min, max
#include <limits>    // for infinity
#include <numeric>   // for iota
#include <optional>  // for what may not be needed

namespace biting
{

namespace
{

class Search
{
public:
  Search(const OldMesh& mesh, const std::vector<Id>& triangles, Pulse& pulse)
    : Mesh(mesh)
    , Triangles(triangles)
    , Progress(pulse)
    , Buckets(mesh.Points, CornersOf(mesh, triangles), pulse)
    , All(triangles.size())
  {
    std::iota(this->All.begin(), this->All.end(), 0);
  }

  OldPlace Find(const Point2& place)
  {
    OldPlace found;
    if (!this->FindAmong(this->Buckets.Near(place), place, found))
    {
      this->FindOnBorder(place, found);
    }
    if (found.Triangle == NoId)
    {
      this->FindAmong(this->All, place, found);
    }
    return found;
  }

private:
  static std::vector<Id> CornersOf(const OldMesh& mesh, const std::vector<Id>& triangles)
  {
    std::vector<Id> corners;
    for (const Id triangle : triangles)
    {
      const auto first = mesh.Corners.begin() + 3 * triangle;
      corners.insert(corners.end(), first, first + 3);
    }
    return corners;
  }

  // The one whose least weight is the largest: not negative in the triangle that holds the place.
  // Whether one does.
  template <typename Candidates>
  bool FindAmong(const Candidates& candidates, const Point2& place, OldPlace& found) const
  {
    double largest = -std::numeric_limits<double>::infinity();
    for (const Id candidate : candidates)
    {
      const std::array<double, 3> weights = this->WeightsIn(candidate, place);
      const double least = std::min({ weights[0], weights[1], weights[2] });
      if (least > largest)
      {
        largest = least;
        found = { this->Triangles[candidate], weights };
      }
    }
    double sum = 0.0;
    for (double& weight : found.Weights)
    {
      weight = std::max(weight, 0.0);
      sum += weight;
    }
    for (double& weight : found.Weights)
    {
      weight /= sum;
    }
    return largest >= 0.0;
  }

  // Where the border is nearer than what was found: that may be off by rounding only.
  void FindOnBorder(const Point2& place, OldPlace& found)
  {
    if (!this->Border)
    {
      this->Border = this->MakeBorder();
    }
    if (this->Progress.HasStopped())
    {
      return;
    }
    const NearestValue nearest =
      Nearest(*this->Border, place, { this->DistanceTo(found, place), 0.0 });
    if (nearest.Edge)
    {
      const Id slot = nearest.Edge->StartId;
      found.Triangle = slot / 3;
      found.Weights = { 0.0, 0.0, 0.0 };
      found.Weights[(slot % 3 + 1) % 3] = 1.0 - nearest.Value;
      found.Weights[(slot % 3 + 2) % 3] = nearest.Value;
    }
  }

  double DistanceTo(const OldPlace& found, const Point2& place) const
  {
    if (found.Triangle == NoId)
    {
      return std::numeric_limits<double>::infinity();
    }
    Point2 sum{};
    for (std::size_t k = 0; k < 3; ++k)
    {
      sum = sum + found.Weights[k] * this->Mesh.Points[this->Mesh.Corners[3 * found.Triangle + k]];
    }
    return Distance(sum, place);
  }

  BoxTree<BorderEdge> MakeBorder()
  {
    std::vector<BorderEdge> edges;
    for (const Id triangle : this->Triangles)
    {
      for (Id slot = 3 * triangle; slot < 3 * triangle + 3; ++slot)
      {
        if (this->Mesh.Neighbors[slot] == NoId)
        {
          edges.push_back({ this->Mesh.Points[this->Mesh.Start(slot)],
            this->Mesh.Points[this->Mesh.End(slot)], 0.0, 1.0, slot, slot });
        }
      }
    }
    return { edges, this->Progress };
  }

  std::array<double, 3> WeightsIn(Id candidate, const Point2& place) const
  {
    const Id* ids = this->Mesh.Corners.data() + 3 * this->Triangles[candidate];
    const Point2 corners[3] = { this->Mesh.Points[ids[0]], this->Mesh.Points[ids[1]],
      this->Mesh.Points[ids[2]] };
    const double whole = Cross(corners[1] - corners[0], corners[2] - corners[0]);
    const double second = Cross(place - corners[0], corners[2] - corners[0]) / whole;
    const double third = Cross(corners[1] - corners[0], place - corners[0]) / whole;
    return { 1.0 - second - third, second, third };
  }

  const OldMesh& Mesh;
  const std::vector<Id>& Triangles;
  Pulse& Progress;
  TriangleBuckets Buckets;
  std::vector<Id> All;
  std::optional<BoxTree<BorderEdge>> Border; ///< the free edges, with their slots as both ids
};

} // namespace

std::vector<OldPlace> FindOldPlaces(const OldMesh& mesh, const std::vector<Id>& triangles,
  const std::vector<Point2>& places, Pulse& pulse)
{
  std::vector<OldPlace> found;
  if (places.empty())
  {
    return found;
  }
  Search search(mesh, triangles, pulse);
  if (!pulse.HasStopped())
  {
    found.reserve(places.size());
    pulse.ForEach(places.size(),
      [&search, &places, &found](std::size_t k) { found.push_back(search.Find(places[k])); });
  }
  return found;
}

} // namespace biting
