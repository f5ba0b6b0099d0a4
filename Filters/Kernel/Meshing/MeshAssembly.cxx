// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "MeshAssembly.h"

#include "../Base/Pulse.h"
#include "../Base/SortInSteps.h"
#include "../Base/Tasks.h"

#include <algorithm> // for max
#include <utility>   // for move

namespace biting
{

namespace
{

// Where steps end, as shares of the time.
constexpr double NumbersEnd = 0.3;
constexpr double VerticesEnd = 0.6;
constexpr double EdgesEnd = 0.8;

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

// The new numbers of the used vertices, NoId for the others.
struct Numbering
{
  std::vector<Id> Numbers;
  Id Size = 0;
};

Numbering NumberUsedVertices(const Triangulation& mesh, std::size_t numberOfPoints, Pulse& pulse)
{
  const PulsePart part(pulse, 0.0, NumbersEnd);
  Numbering used{ std::vector<Id>(numberOfPoints, NoId) };
  pulse.ForEach(mesh.Corners.size(),
    [&used, &mesh](std::size_t half) { used.Numbers[mesh.Corners[half]] = 0; });
  pulse.ForEach(numberOfPoints,
    [&used](std::size_t vertex)
    {
      Id& number = used.Numbers[vertex];
      number = number == NoId ? NoId : used.Size++;
    });
  return used;
}

void MakeRoom(std::size_t size, BitingMesh& mesh, Pulse& pulse)
{
  mesh.Points.reserve(size);
  mesh.Spacing.reserve(size);
  mesh.BiteOrders.reserve(size);
  mesh.Kinds.reserve(size);
  mesh.OriginalPoints.reserve(size);
  pulse.Ask();
}

void CopyVertices(const Domain& domain, const BitingResult& bites, const Numbering& used,
  BitingMesh& mesh, Pulse& pulse)
{
  const PulsePart part(pulse, NumbersEnd, VerticesEnd);
  MakeRoom(static_cast<std::size_t>(used.Size), mesh, pulse);
  pulse.ForEach(used.Numbers.size(),
    [&domain, &bites, &used, &mesh](std::size_t place)
    {
      const Id vertex = static_cast<Id>(place);
      if (used.Numbers[vertex] != NoId)
      {
        const bool isOld = vertex < domain.NumberOfVertices();
        mesh.Points.push_back(bites.Points[vertex]);
        mesh.Spacing.push_back(bites.Spacings[vertex]);
        mesh.BiteOrders.push_back(bites.BiteOrders[vertex]);
        mesh.Kinds.push_back(KindOf(domain, bites, vertex));
        mesh.OriginalPoints.push_back(isOld ? domain.VertexPoints[vertex] : NoId);
      }
    });
}

// A mesh edge that a constraint covers, in the direction of its segment.
struct CoveringEdge
{
  Id Constraint;
  double Along; ///< of its start, for the order where a point divides the constraint
  Id Start;
  Id End;
};

CoveringEdge MakeCoveringEdge(const BitingResult& bites, const Triangulation& mesh, Id half)
{
  const Id triangle = half / 3;
  const Id constraint = mesh.Constraints[half];
  Id start = mesh.Corners[3 * triangle + (half + 1) % 3];
  Id end = mesh.Corners[3 * triangle + (half + 2) % 3];
  const Point2 from = bites.Points[bites.EdgeStarts[constraint]];
  const Point2 direction = bites.Points[bites.EdgeEnds[constraint]] - from;
  if (Dot(bites.Points[end] - bites.Points[start], direction) < 0.0)
  {
    std::swap(start, end);
  }
  return { constraint, Dot(bites.Points[start] - from, direction), start, end };
}

std::vector<CoveringEdge> FindCoveringEdges(
  const BitingResult& bites, const Triangulation& mesh, Pulse& pulse)
{
  std::vector<CoveringEdge> edges;
  pulse.ForEach(mesh.Corners.size(),
    [&bites, &mesh, &edges](std::size_t slot)
    {
      const Id half = static_cast<Id>(slot);
      const bool isFirst = mesh.Neighbors[half] == NoId || mesh.Neighbors[half] >= half / 3;
      if (mesh.Constraints[half] != NoId && isFirst)
      {
        edges.push_back(MakeCoveringEdge(bites, mesh, half));
      }
    });
  SortInSteps(
    edges,
    [](const CoveringEdge& a, const CoveringEdge& b)
    { return a.Constraint != b.Constraint ? a.Constraint < b.Constraint : a.Along < b.Along; },
    pulse);
  return edges;
}

void CopyEdges(const Domain& domain, const BitingResult& bites, const Triangulation& triangulation,
  const Numbering& used, BitingMesh& mesh, Pulse& pulse)
{
  const PulsePart part(pulse, VerticesEnd, EdgesEnd);
  const std::vector<CoveringEdge> edges = FindCoveringEdges(bites, triangulation, pulse);
  pulse.ForEach(edges.size(),
    [&domain, &bites, &used, &mesh, &edges](std::size_t k)
    {
      const Id segment = bites.EdgeSegments[edges[k].Constraint];
      mesh.EdgeStarts.push_back(used.Numbers[edges[k].Start]);
      mesh.EdgeEnds.push_back(used.Numbers[edges[k].End]);
      mesh.EdgeCells.push_back(domain.Cells[segment]);
      mesh.EdgeIsBoundary.push_back(domain.IsBoundary[segment]);
    });
}

void MoveTriangles(
  const Numbering& used, Triangulation& triangulation, BitingMesh& mesh, Pulse& pulse)
{
  const PulsePart part(pulse, EdgesEnd, 1.0);
  mesh.Corners = std::move(triangulation.Corners);
  mesh.Neighbors = std::move(triangulation.Neighbors);
  mesh.Regions = std::move(triangulation.Regions);
  ForEachAtOnce(pulse, mesh.Corners.size(),
    [&used, &mesh](std::size_t half) { mesh.Corners[half] = used.Numbers[mesh.Corners[half]]; });
}

} // namespace

BitingMesh AssembleMesh(
  const Domain& domain, BitingResult bites, Triangulation& triangulation, Monitor& monitor)
{
  Pulse pulse(monitor);
  const Numbering used = NumberUsedVertices(triangulation, bites.Points.size(), pulse);
  BitingMesh mesh;
  CopyVertices(domain, bites, used, mesh, pulse);
  CopyEdges(domain, bites, triangulation, used, mesh, pulse);
  MoveTriangles(used, triangulation, mesh, pulse);
  mesh.Bites = std::move(bites.Bites);
  mesh.Front = std::move(bites.Front);
  return mesh;
}

} // namespace biting
