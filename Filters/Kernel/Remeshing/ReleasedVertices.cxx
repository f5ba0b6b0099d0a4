// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "ReleasedVertices.h"

#include <algorithm> // for min
#include <cstddef>   // for sizes
#include <limits>    // for the least reach
#include <numeric>   // for iota
#include <utility>   // for move

namespace biting
{

namespace
{

// New numbers of the vertices: those of the domain that stay, the released ones, the others.
std::vector<Id> NumberVertices(
  const std::vector<std::uint8_t>& isReleased, std::size_t numberOfVertices)
{
  std::vector<Id> numbers(numberOfVertices);
  Id next = 0;
  for (const bool releases : { false, true })
  {
    for (std::size_t vertex = 0; vertex < isReleased.size(); ++vertex)
    {
      if ((isReleased[vertex] != 0) == releases)
      {
        numbers[vertex] = next++;
      }
    }
  }
  for (std::size_t vertex = isReleased.size(); vertex < numberOfVertices; ++vertex)
  {
    numbers[vertex] = next++;
  }
  return numbers;
}

template <typename Value>
void Permute(const std::vector<Id>& numbers, std::vector<Value>& values)
{
  std::vector<Value> permuted(values.size());
  for (std::size_t k = 0; k < values.size(); ++k)
  {
    permuted[numbers[k]] = values[k];
  }
  values = std::move(permuted);
}

void Renumber(const std::vector<Id>& numbers, std::vector<Id>& ids)
{
  for (Id& id : ids)
  {
    id = numbers[id];
  }
}

void RenumberAll(
  const std::vector<Id>& numbers, Domain& domain, BitingResult& bites, Triangulation& mesh)
{
  Permute(numbers, bites.Points);
  Permute(numbers, bites.Spacings);
  Permute(numbers, bites.BiteOrders);
  Permute(numbers, bites.Segments);
  Renumber(numbers, bites.EdgeStarts);
  Renumber(numbers, bites.EdgeEnds);
  Renumber(numbers, mesh.Corners);
  Renumber(numbers, domain.Starts);
  Renumber(numbers, domain.Ends);
}

} // namespace

std::vector<std::uint8_t> FindVerticesThatMayGo(const OldMesh& old, const Domain& domain)
{
  std::vector<std::uint8_t> mayGo = domain.IsEmbedded;
  for (std::size_t vertex = 0; vertex < mayGo.size(); ++vertex)
  {
    const Id point = domain.VertexPoints[vertex];
    mayGo[vertex] &= point == NoId || old.IsFixed[point] == 0;
  }
  return mayGo;
}

std::vector<std::uint8_t> FindAddedVertices(const Domain& domain)
{
  std::vector<std::uint8_t> isAdded(domain.Vertices.size(), 0);
  for (std::size_t vertex = 0; vertex < isAdded.size(); ++vertex)
  {
    isAdded[vertex] = domain.VertexPoints[vertex] == NoId;
  }
  return isAdded;
}

void ReleaseVertices(const std::vector<std::uint8_t>& isReleased, Domain& domain,
  BitingResult& bites, Triangulation& mesh)
{
  const std::vector<Id> numbers = NumberVertices(isReleased, bites.Points.size());
  RenumberAll(numbers, domain, bites, mesh);
  Permute(numbers, domain.Vertices);
  Permute(numbers, domain.VertexPoints);
  Permute(numbers, domain.IsEmbedded);
  std::size_t left = 0;
  for (const std::uint8_t is : isReleased)
  {
    left += is == 0;
  }
  domain.Vertices.resize(left);
  domain.VertexPoints.resize(left);
  domain.IsEmbedded.resize(left);
}

std::vector<Id> ListHeld(const std::vector<std::uint8_t>& isHeld, const Domain& domain)
{
  std::vector<Id> held;
  for (std::size_t vertex = 0; vertex < isHeld.size(); ++vertex)
  {
    if (isHeld[vertex] && domain.VertexPoints[vertex] != NoId)
    {
      held.push_back(domain.VertexPoints[vertex]);
    }
  }
  return held;
}

void ReturnVertices(
  const InnerPlaces& places, Domain& domain, BitingResult& bites, Triangulation& mesh)
{
  const std::size_t first = domain.Vertices.size();
  std::vector<Id> numbers(bites.Points.size(), NoId);
  std::iota(numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(first), 0);
  for (std::size_t vertex = first; vertex < numbers.size(); ++vertex)
  {
    const Point2& place = bites.Points[vertex];
    const Id point = bites.Segments[vertex] == NoId ? places.FindAt(place) : NoId;
    if (point != NoId)
    {
      numbers[vertex] = domain.NumberOfVertices();
      domain.Vertices.push_back(place);
      domain.VertexPoints.push_back(point);
      domain.IsEmbedded.push_back(1);
    }
  }
  Id next = domain.NumberOfVertices();
  for (Id& number : numbers)
  {
    number = number == NoId ? next++ : number;
  }
  RenumberAll(numbers, domain, bites, mesh);
}

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
