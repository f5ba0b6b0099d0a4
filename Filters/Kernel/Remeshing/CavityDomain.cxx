// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "CavityDomain.h"

#include "../Domain/AreaSum.h"

#include <algorithm> // for max
#include <cmath>     // for abs
#include <limits>    // for epsilon

namespace biting
{

namespace
{

constexpr double ResolutionInUlp = 4.0;

// The places of vertices of the region among those of the domain.
std::vector<Id> AddVertices(const OldMesh& mesh, const ChangedRegion& region,
  const RegionEdges& edges, const std::vector<std::uint8_t>& isKept, Domain& domain)
{
  std::vector<Id> numbers(region.Vertices.size(), NoId);
  for (Id vertex = 0; vertex < region.NumberOfVertices(); ++vertex)
  {
    if (isKept[vertex])
    {
      numbers[vertex] = domain.NumberOfVertices();
      domain.Vertices.push_back(mesh.Points[region.Vertices[vertex]]);
      domain.VertexPoints.push_back(region.Vertices[vertex]);
      domain.IsEmbedded.push_back(!edges.IsKept[vertex]);
      domain.Bounds.Add(domain.Vertices.back());
    }
  }
  return numbers;
}

void AddSegment(
  const RegionEdge& edge, const std::vector<Id>& numbers, bool isPreserved, Domain& domain)
{
  const bool isRightOut = edge.RightRegion == NoId;
  const bool isLeftOut = edge.LeftRegion == NoId;
  domain.Starts.push_back(numbers[edge.Start]);
  domain.Ends.push_back(numbers[edge.End]);
  domain.Cells.push_back(edge.Mark);
  domain.IsBoundary.push_back(isRightOut || isLeftOut);
  domain.LeftInside.push_back(!isLeftOut);
  domain.RightInside.push_back(!isRightOut);
  domain.IsPreserved.push_back(isPreserved);
}

void AddArea(Domain& domain)
{
  AreaSum area(domain.Bounds.Center());
  double largest = 0.0;
  for (Id segment = 0; segment < domain.NumberOfSegments(); ++segment)
  {
    const Point2& start = domain.Vertices[domain.Starts[segment]];
    const Point2& end = domain.Vertices[domain.Ends[segment]];
    if (domain.IsBoundary[segment])
    {
      domain.LeftInside[segment] ? area.Add(start, end) : area.Add(end, start);
    }
  }
  for (const Point2& corner : { domain.Bounds.Low, domain.Bounds.High })
  {
    largest = std::max({ largest, std::abs(corner.X), std::abs(corner.Y) });
  }
  domain.Area = area.Area();
  domain.Resolution = ResolutionInUlp * std::numeric_limits<double>::epsilon() * largest;
}

} // namespace

Domain MakeCavityDomain(const OldMesh& mesh, const ChangedRegion& region, const RegionEdges& edges,
  const std::vector<std::uint8_t>& isKept, const std::vector<Point2>& added, EdgePolicy policy)
{
  Domain domain;
  const std::vector<Id> numbers = AddVertices(mesh, region, edges, isKept, domain);
  for (const RegionEdge& edge : edges.Edges)
  {
    const bool isPreserved =
      edge.RimSlot != NoId || policy == EdgePolicy::Frozen || mesh.IsFrozenEdge(edge.Mark);
    AddSegment(edge, numbers, isPreserved, domain);
  }
  domain.Vertices.insert(domain.Vertices.end(), added.begin(), added.end());
  domain.VertexPoints.resize(domain.Vertices.size(), NoId);
  domain.IsEmbedded.resize(domain.Vertices.size(), 1);
  AddArea(domain);
  return domain;
}

} // namespace biting
