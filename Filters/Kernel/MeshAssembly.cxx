// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "MeshAssembly.h"

#include <algorithm> // for max, sort
#include <cmath>     // for abs
#include <utility>   // for move

namespace biting
{

namespace
{

VertexKind KindOf(const Domain& domain, const BitingResult& bites, Id vertex)
{
  if (vertex >= domain.NumberOfVertices())
  {
    return bites.Segments[vertex] == NoId ? VertexKind::Interior : VertexKind::Boundary;
  }
  if (domain.IsEmbedded[vertex])
  {
    return VertexKind::Embedded;
  }
  return domain.VertexPoints[vertex] == NoId ? VertexKind::Boundary : VertexKind::Input;
}

std::vector<Id> NumberUsedVertices(const Triangulation& mesh, std::size_t numberOfPoints)
{
  std::vector<Id> numbers(numberOfPoints, NoId);
  for (Id corner : mesh.Corners)
  {
    numbers[corner] = 0;
  }
  Id next = 0;
  for (Id& number : numbers)
  {
    number = number == NoId ? NoId : next++;
  }
  return numbers;
}

void CopyVertices(
  const Domain& domain, const BitingResult& bites, const std::vector<Id>& numbers, BitingMesh& mesh)
{
  for (Id vertex = 0; vertex < static_cast<Id>(numbers.size()); ++vertex)
  {
    if (numbers[vertex] != NoId)
    {
      const bool isOld = vertex < domain.NumberOfVertices();
      mesh.Points.push_back(bites.Points[vertex]);
      mesh.Spacing.push_back(bites.Spacings[vertex]);
      mesh.BiteOrders.push_back(bites.BiteOrders[vertex]);
      mesh.Kinds.push_back(KindOf(domain, bites, vertex));
      mesh.OriginalPoints.push_back(isOld ? domain.VertexPoints[vertex] : NoId);
    }
  }
}

// A mesh edge that a constraint covers, in the direction of its segment.
struct CoveringEdge
{
  Id Constraint;
  double Along; ///< of its start, for the order where a point divides the constraint
  Id Start;
  Id End;
};

std::vector<CoveringEdge> FindCoveringEdges(const BitingResult& bites, const Triangulation& mesh)
{
  std::vector<CoveringEdge> edges;
  for (Id half = 0; half < static_cast<Id>(mesh.Corners.size()); ++half)
  {
    const Id constraint = mesh.Constraints[half];
    const Id triangle = half / 3;
    if (constraint == NoId || (mesh.Neighbors[half] != NoId && mesh.Neighbors[half] < triangle))
    {
      continue;
    }
    Id start = mesh.Corners[3 * triangle + (half + 1) % 3];
    Id end = mesh.Corners[3 * triangle + (half + 2) % 3];
    const Point2 from = bites.Points[bites.EdgeStarts[constraint]];
    const Point2 direction = bites.Points[bites.EdgeEnds[constraint]] - from;
    if (Dot(bites.Points[end] - bites.Points[start], direction) < 0.0)
    {
      std::swap(start, end);
    }
    edges.push_back({ constraint, Dot(bites.Points[start] - from, direction), start, end });
  }
  std::sort(edges.begin(), edges.end(),
    [](const CoveringEdge& a, const CoveringEdge& b)
    { return a.Constraint != b.Constraint ? a.Constraint < b.Constraint : a.Along < b.Along; });
  return edges;
}

void CopyEdges(const Domain& domain, const BitingResult& bites, const Triangulation& triangulation,
  const std::vector<Id>& numbers, BitingMesh& mesh)
{
  for (const CoveringEdge& edge : FindCoveringEdges(bites, triangulation))
  {
    const Id segment = bites.EdgeSegments[edge.Constraint];
    mesh.EdgeStarts.push_back(numbers[edge.Start]);
    mesh.EdgeEnds.push_back(numbers[edge.End]);
    mesh.EdgeCells.push_back(domain.Cells[segment]);
    mesh.EdgeIsBoundary.push_back(domain.IsBoundary[segment]);
  }
}

} // namespace

BitingMesh AssembleMesh(const Domain& domain, BitingResult bites, Triangulation& triangulation)
{
  const std::vector<Id> numbers = NumberUsedVertices(triangulation, bites.Points.size());
  BitingMesh mesh;
  CopyVertices(domain, bites, numbers, mesh);
  CopyEdges(domain, bites, triangulation, numbers, mesh);
  for (Id& corner : triangulation.Corners)
  {
    corner = numbers[corner];
  }
  mesh.Corners = triangulation.Corners;
  mesh.Neighbors = triangulation.Neighbors;
  mesh.Regions = triangulation.Regions;
  mesh.Bites = std::move(bites.Bites);
  mesh.Front = std::move(bites.Front);
  return mesh;
}

double LipschitzConstant(const BitingMesh& mesh)
{
  double greatest = 0.0;
  for (std::size_t half = 0; half < mesh.Corners.size(); ++half)
  {
    const Id u = mesh.Corners[half];
    const Id v = mesh.Corners[half % 3 == 2 ? half - 2 : half + 1];
    const double rise = std::abs(mesh.Spacing[u] - mesh.Spacing[v]);
    if (rise > greatest * Distance(mesh.Points[u], mesh.Points[v]))
    {
      greatest = rise / Distance(mesh.Points[u], mesh.Points[v]);
    }
  }
  return greatest;
}

} // namespace biting
