// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "InnerPlaces.h"

#include <algorithm> // for min
#include <limits>    // for the least reach

namespace biting
{

InnerPlaces::InnerPlaces(
  const OldMesh& mesh, const ChangedRegion& region, const RegionEdges& edges, Pulse& pulse)
  : Tree(List(mesh, region, edges), pulse)
{
}

std::vector<InnerPlaces::OldPlace> InnerPlaces::List(
  const OldMesh& mesh, const ChangedRegion& region, const RegionEdges& edges)
{
  std::vector<OldPlace> places;
  for (Id vertex = 0; vertex < region.NumberOfVertices(); ++vertex)
  {
    if (region.IsInside[vertex] && !edges.IsKept[vertex] && !edges.IsGone[vertex])
    {
      const Id point = region.Vertices[vertex];
      places.push_back({ mesh.Points[point], point });
    }
  }
  return places;
}

const InnerPlaces::OldPlace* InnerPlaces::FindNearest(const Point2& place, double reach) const
{
  const OldPlace* nearest = nullptr;
  this->Tree.Search(place, 1.0, reach,
    [&place, &nearest](const OldPlace& item, double limit)
    {
      const double distance = Distance(item.Place, place);
      nearest = distance < limit ? &item : nearest;
      return std::min(distance, limit);
    });
  return nearest;
}

const Point2* InnerPlaces::FindNear(const Point2& place, double reach) const
{
  const OldPlace* nearest = this->FindNearest(place, reach);
  return nearest ? &nearest->Place : nullptr;
}

Id InnerPlaces::FindAt(const Point2& place) const
{
  const OldPlace* nearest = this->FindNearest(place, std::numeric_limits<double>::denorm_min());
  return nearest ? nearest->Point : NoId;
}

} // namespace biting
