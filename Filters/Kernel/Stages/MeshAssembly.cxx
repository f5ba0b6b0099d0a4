// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "MeshAssembly.h"

#include "../Base/Marks.h"
#include "../Base/Pulse.h"
#include "../Base/SortInSteps.h"
#include "../Base/Tasks.h"
#include "../Delaunay/ConstrainedEdges.h"

#include <algorithm> // for min
#include <utility>   // for move, swap

namespace biting
{

namespace
{

// Where steps end, as shares of the time.
constexpr double NumbersEnd = 0.3;
constexpr double EdgesEnd = 0.6;
constexpr double VerticesEnd = 0.9;

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

// How many of the vertices are used, and the new numbers of these, NoId for the others; without
// numbers where all are.
struct Numbering
{
  bool IsNew() const { return !this->Numbers.empty(); }
  Id NumberOf(Id vertex) const { return this->IsNew() ? this->Numbers[vertex] : vertex; }

  std::vector<Id> Numbers;
  Id Size = 0;
};

struct Count
{
  Id Number = 0;

  void Join(const Count& other) { this->Number += other.Number; }
};

Numbering NumberUsedVertices(const Triangulation& mesh, std::size_t numberOfPoints, Pulse& pulse)
{
  const PulsePart part(pulse, 0.0, NumbersEnd);
  Marks used(numberOfPoints);
  ForEachAtOnce(pulse, mesh.Corners.size(),
    [&used, &mesh](std::size_t half)
    { used.Set(static_cast<std::size_t>(mesh.Corners[half]), 1); });
  Numbering numbering;
  numbering.Size = SumAtOnce(pulse, numberOfPoints, Count(),
    [&used](Count& sum, std::size_t vertex) {
      sum.Number += used[vertex];
    }).Number;
  if (static_cast<std::size_t>(numbering.Size) == numberOfPoints || pulse.HasStopped())
  {
    return numbering;
  }
  numbering.Numbers.reserve(numberOfPoints);
  Id next = 0;
  pulse.ForEach(numberOfPoints,
    [&numbering, &used, &next](std::size_t vertex)
    { numbering.Numbers.push_back(used[vertex] != 0 ? next++ : NoId); });
  return numbering;
}

template <typename Value>
void CloseUp(const Numbering& used, std::vector<Value>& values, Pulse& pulse)
{
  pulse.ForEach(values.size(),
    [&used, &values](std::size_t vertex)
    {
      if (used.Numbers[vertex] != NoId)
      {
        values[used.Numbers[vertex]] = values[vertex];
      }
    });
  values.resize(static_cast<std::size_t>(used.Size));
}

// Kind and input point of each vertex, before unused ones are left out.
void TellVertices(const Domain& domain, const BitingResult& bites, BitingMesh& mesh, Pulse& pulse)
{
  const std::size_t size = bites.Points.size();
  GrowInSteps(mesh.Kinds, size, VertexKind::Interior, pulse);
  GrowInSteps(mesh.OriginalPoints, size, Id{ NoId }, pulse);
  ForEachAtOnce(pulse, std::min(mesh.Kinds.size(), mesh.OriginalPoints.size()),
    [&domain, &bites, &mesh](std::size_t place)
    {
      const Id vertex = static_cast<Id>(place);
      mesh.Kinds[place] = KindOf(domain, bites, vertex);
      mesh.OriginalPoints[place] =
        vertex < domain.NumberOfVertices() ? domain.VertexPoints[vertex] : NoId;
    });
}

void MoveVertices(
  const Domain& domain, const Numbering& used, BitingResult& bites, BitingMesh& mesh, Pulse& pulse)
{
  const PulsePart part(pulse, EdgesEnd, VerticesEnd);
  TellVertices(domain, bites, mesh, pulse);
  mesh.Points = std::move(bites.Points);
  mesh.Spacing = std::move(bites.Spacings);
  mesh.BiteOrders = std::move(bites.BiteOrders);
  if (used.IsNew() && !pulse.HasStopped())
  {
    CloseUp(used, mesh.Points, pulse);
    CloseUp(used, mesh.Spacing, pulse);
    CloseUp(used, mesh.BiteOrders, pulse);
    CloseUp(used, mesh.Kinds, pulse);
    CloseUp(used, mesh.OriginalPoints, pulse);
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

CoveringEdge MakeCoveringEdge(const BitingResult& bites, Id constraint, Id start, Id end)
{
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
  ForEachConstrainedEdge(mesh, pulse,
    [&bites, &edges](Id constraint, Id start, Id end)
    { edges.push_back(MakeCoveringEdge(bites, constraint, start, end)); });
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
  const PulsePart part(pulse, NumbersEnd, EdgesEnd);
  const std::vector<CoveringEdge> edges = FindCoveringEdges(bites, triangulation, pulse);
  pulse.ForEach(edges.size(),
    [&domain, &bites, &used, &mesh, &edges](std::size_t k)
    {
      const Id segment = bites.EdgeSegments[edges[k].Constraint];
      mesh.EdgeStarts.push_back(used.NumberOf(edges[k].Start));
      mesh.EdgeEnds.push_back(used.NumberOf(edges[k].End));
      mesh.EdgeCells.push_back(domain.Cells[segment]);
      mesh.EdgeIsBoundary.push_back(domain.IsBoundary[segment]);
    });
}

void MoveTriangles(
  const Numbering& used, Triangulation& triangulation, BitingMesh& mesh, Pulse& pulse)
{
  const PulsePart part(pulse, VerticesEnd, 1.0);
  mesh.Corners = std::move(triangulation.Corners);
  mesh.Neighbors = std::move(triangulation.Neighbors);
  mesh.Regions = std::move(triangulation.Regions);
  if (used.IsNew())
  {
    ForEachAtOnce(pulse, mesh.Corners.size(),
      [&used, &mesh](std::size_t half) { mesh.Corners[half] = used.Numbers[mesh.Corners[half]]; });
  }
}

} // namespace

BitingMesh AssembleMesh(
  const Domain& domain, BitingResult bites, Triangulation& triangulation, Monitor& monitor)
{
  Pulse pulse(monitor);
  const Numbering used = NumberUsedVertices(triangulation, bites.Points.size(), pulse);
  BitingMesh mesh;
  CopyEdges(domain, bites, triangulation, used, mesh, pulse);
  MoveVertices(domain, used, bites, mesh, pulse);
  MoveTriangles(used, triangulation, mesh, pulse);
  mesh.Bites = std::move(bites.Bites);
  mesh.Front = std::move(bites.Front);
  return mesh;
}

} // namespace biting
