// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "ChainPlaces.h"

#include <algorithm> // for min, max

namespace biting
{

ChainPlaces::ChainPlaces(
  const SurfaceGround& ground, const std::vector<Id>& chains, const std::vector<Point3>& points)
  : Ground(ground)
  , Chains(chains)
  , Edges(points.size(), NoId)
{
  constexpr double Rounding = 1e-6; // of coordinates far from the origin, too
  std::vector<Id> next;
  next.reserve(At(ground.Chains.Size()));
  for (Id chain = 0; chain < ground.Chains.Size(); ++chain)
  {
    next.push_back(ground.Chains.Begin(chain) + 1);
  }
  for (std::size_t v = 0; v < points.size(); ++v)
  {
    if (chains[v] == NoId)
    {
      continue;
    }
    const auto isOn = [this, &points, v](Id edge)
    {
      const double size = this->Ground.Sizes[At(this->Ground.Chains.At(edge))];
      return Distance(this->Nearest(edge, points[v]), points[v]) < Rounding * size;
    };
    const Id first = ground.Chains.Begin(chains[v]) + 1;
    const Id end = ground.Chains.End(chains[v]);
    Id& edge = next[At(chains[v])];
    for (Id k = first; k < end && this->Edges[v] == NoId; ++k)
    {
      this->Edges[v] = isOn(edge) ? edge : NoId;
      edge = this->Edges[v] != NoId ? edge : edge + 1 < end ? edge + 1 : first;
    }
  }
}

ChainPlace ChainPlaces::Project(Id vertex, const Point3& place) const
{
  constexpr int MostSteps = 64;
  const Id chain = this->Chains[At(vertex)];
  const Id start = this->Edges[At(vertex)];
  ChainPlace best{ start, this->Nearest(start, place) };
  double least = Distance(best.Place, place);
  for (const Id step : { 1, -1 })
  {
    Id edge = this->Neighbor(chain, start, step);
    for (int k = 0; k < MostSteps && edge != NoId; ++k)
    {
      const Point3 foot = this->Nearest(edge, place);
      const double distance = Distance(foot, place);
      if (distance >= least)
      {
        break;
      }
      least = distance;
      best = { edge, foot };
      edge = this->Neighbor(chain, edge, step);
    }
  }
  return best;
}

Point3 ChainPlaces::DirectionAt(Id vertex) const
{
  const Id edge = this->Edges[At(vertex)];
  const Point3 side = this->Ground.Mesh.Points[At(this->Ground.Chains.At(edge))] -
    this->Ground.Mesh.Points[At(this->Ground.Chains.At(edge - 1))];
  return (1.0 / std::max(Length(side), 1e-300)) * side;
}

Point3 ChainPlaces::Nearest(Id edge, const Point3& place) const
{
  const Point3& tail = this->Ground.Mesh.Points[At(this->Ground.Chains.At(edge - 1))];
  const Point3 side = this->Ground.Mesh.Points[At(this->Ground.Chains.At(edge))] - tail;
  const double part = Dot(place - tail, side) / std::max(Dot(side, side), 1e-300);
  return tail + std::min(1.0, std::max(0.0, part)) * side;
}

bool ChainPlaces::IsRing(Id chain) const
{
  const FeatureChains& chains = this->Ground.Chains;
  const Id first = chains.At(chains.Begin(chain));
  return first == chains.At(chains.End(chain) - 1) &&
    this->Ground.Places[At(first)] != FeaturePlace::Corner;
}

/// NoId beyond the ends.
Id ChainPlaces::Neighbor(Id chain, Id edge, Id step) const
{
  const Id first = this->Ground.Chains.Begin(chain) + 1;
  const Id last = this->Ground.Chains.End(chain) - 1;
  const Id next = edge + step;
  if (next >= first && next <= last)
  {
    return next;
  }
  return !this->IsRing(chain) ? NoId : next < first ? last : first;
}

} // namespace biting
