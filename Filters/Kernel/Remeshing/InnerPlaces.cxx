// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "InnerPlaces.h"

#include <limits> // for the least square

namespace biting
{

namespace
{

std::vector<PointTree::Item> ListInner(
  const OldMesh& mesh, const ChangedRegion& region, const RegionEdges& edges)
{
  std::vector<PointTree::Item> items;
  for (Id vertex = 0; vertex < region.NumberOfVertices(); ++vertex)
  {
    if (region.IsInside[vertex] && !edges.IsKept[vertex] && !edges.IsGone[vertex])
    {
      const Id point = region.Vertices[vertex];
      items.push_back({ mesh.Points[point], point });
    }
  }
  return items;
}

} // namespace

InnerPlaces::InnerPlaces(
  const OldMesh& mesh, const ChangedRegion& region, const RegionEdges& edges, Pulse& pulse)
  : Tree(ListInner(mesh, region, edges), pulse)
{
}

const Point2* InnerPlaces::FindNear(const Point2& place, double reach) const
{
  const PointTree::Item* nearest = this->Tree.Nearest(place, reach * reach);
  return nearest ? &nearest->Place : nullptr;
}

Id InnerPlaces::FindAt(const Point2& place) const
{
  const PointTree::Item* nearest =
    this->Tree.Nearest(place, std::numeric_limits<double>::denorm_min());
  return nearest && nearest->Place == place ? nearest->Name : NoId;
}

} // namespace biting
