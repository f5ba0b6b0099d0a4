// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "ReleasedVertices.h"

#include "../Quality/Quality.h"

#include <utility> // for move

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

// Marks the corners of a triangle that are in the way: all at a poor angle, the ends of a poor
// edge.
void MarkCorners(const BitingResult& bites, const Id* corners, const KeepRules& rules,
  std::vector<std::uint8_t>& isMarked)
{
  const auto place = [&bites, corners](int k) { return bites.Points[corners[k % 3]]; };
  const auto spacing = [&bites, corners](int k) { return bites.Spacings[corners[k % 3]]; };
  const bool isPoor = MinimumAngle(place(0), place(1), place(2)) < rules.LeastAngle;
  for (int k = 0; k < 3; ++k)
  {
    const double length = 2.0 * Distance(place(k), place(k + 1)) / (spacing(k) + spacing(k + 1));
    if (isPoor || length < rules.ShortestEdge || length > rules.LongestEdge)
    {
      isMarked[corners[k]] = 1;
      isMarked[corners[(k + 1) % 3]] = 1;
    }
  }
}

} // namespace

std::vector<std::uint8_t> FindVerticesInTheWay(const OldMesh& old, const Domain& domain,
  const BitingResult& bites, const Triangulation& mesh, const KeepRules& rules)
{
  std::vector<std::uint8_t> isInTheWay(bites.Points.size(), 0);
  for (std::size_t corner = 0; corner < mesh.Corners.size(); corner += 3)
  {
    MarkCorners(bites, mesh.Corners.data() + corner, rules, isInTheWay);
  }
  isInTheWay.resize(domain.Vertices.size());
  for (std::size_t vertex = 0; vertex < isInTheWay.size(); ++vertex)
  {
    isInTheWay[vertex] &=
      domain.IsEmbedded[vertex] != 0 && !old.IsFixed[domain.VertexPoints[vertex]];
  }
  return isInTheWay;
}

void ReleaseVertices(const std::vector<std::uint8_t>& isReleased, Domain& domain,
  BitingResult& bites, Triangulation& mesh)
{
  const std::vector<Id> numbers = NumberVertices(isReleased, bites.Points.size());
  Permute(numbers, bites.Points);
  Permute(numbers, bites.Spacings);
  Permute(numbers, bites.BiteOrders);
  Permute(numbers, bites.Segments);
  Renumber(numbers, bites.EdgeStarts);
  Renumber(numbers, bites.EdgeEnds);
  Renumber(numbers, mesh.Corners);
  Renumber(numbers, domain.Starts);
  Renumber(numbers, domain.Ends);
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

} // namespace biting
