// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "MeshAssembly.h"

#include "../Base/Directory.h"
#include "../Base/DisjointSets.h"
#include "../Base/Marks.h"
#include "../Base/Pulse.h"
#include "../Base/SortInSteps.h"
#include "../Base/Tasks.h"
#include "../Delaunay/ConstrainedEdges.h"
#include "../Quality/Quality.h"

#include <cstdint> // for flags
#include <utility> // for move, swap

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
  mesh.Kinds.resize(size, VertexKind::Interior);
  mesh.OriginalPoints.resize(size, Id{ NoId });
  ForEachAtOnce(pulse, size,
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

/// From start to end.
using Way = std::pair<Id, Id>;

class Opening
{
public:
  Opening(const std::function<bool(Id)>& opens, BitingMesh& mesh)
    : Mesh(mesh)
    , IsOnCrack(mesh.Points.size(), 0)
  {
    for (std::size_t edge = 0; edge < mesh.EdgeStarts.size(); ++edge)
    {
      const bool isOpen =
        !mesh.EdgeIsBoundary[edge] && mesh.EdgeCells[edge] != NoId && opens(mesh.EdgeCells[edge]);
      if (isOpen)
      {
        this->Cracks.Add(EndsOf(mesh.EdgeStarts[edge], mesh.EdgeEnds[edge]), 0);
        this->IsOnCrack[mesh.EdgeStarts[edge]] = 1;
        this->IsOnCrack[mesh.EdgeEnds[edge]] = 1;
      }
    }
    this->Cracks.Sort();
  }

  bool IsEmpty() const { return this->Cracks.IsEmpty(); }

  void Run()
  {
    this->ListHalves();
    this->NumberSectors();
    this->DoubleVertices();
    this->DoubleEdges();
    this->Mesh.Corners = this->NewCorners;
  }

private:
  bool IsCrack(Id a, Id b) const { return this->Cracks[EndsOf(a, b)] != NoId; }

  static Id NextCorner(Id corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }

  void ListHalves();
  void NumberSectors();
  void DoubleVertices();
  void DoubleEdges();
  void AddEdge(std::size_t edge, Id corner, BitingMesh& edges) const;

  BitingMesh& Mesh;
  std::vector<std::uint8_t> IsOnCrack; // of vertices
  Directory<UndirectedEnds> Cracks;    // edges that open
  Directory<Way> Halves;               // edges of triangles on their left: the corner at the start
  std::vector<Id> NewCorners;
  std::vector<Id> Copied; // the vertex of each new one
};

// Only those between vertices of listed edges are asked for.
void Opening::ListHalves()
{
  std::vector<std::uint8_t> isListed(this->Mesh.Points.size(), 0);
  for (std::size_t edge = 0; edge < this->Mesh.EdgeStarts.size(); ++edge)
  {
    isListed[this->Mesh.EdgeStarts[edge]] = 1;
    isListed[this->Mesh.EdgeEnds[edge]] = 1;
  }
  for (Id corner = 0; corner < static_cast<Id>(this->Mesh.Corners.size()); ++corner)
  {
    const Way way(this->Mesh.Corners[corner], this->Mesh.Corners[NextCorner(corner)]);
    if (isListed[way.first] && isListed[way.second])
    {
      this->Halves.Add(way, corner);
    }
  }
  this->Halves.Sort();
}

// Corners at a vertex are of one sector where their triangles share an edge there that is closed.
void Opening::NumberSectors()
{
  std::vector<Id>& corners = this->Mesh.Corners;
  DisjointSets sectors(corners.size());
  for (std::size_t k = 0; k < corners.size(); ++k)
  {
    const Id first = NextCorner(static_cast<Id>(k)); // of the edge opposite corner k
    const Id last = NextCorner(first);
    const Id neighbor = this->Mesh.Neighbors[k];
    if (neighbor == NoId || (!this->IsOnCrack[corners[first]] && !this->IsOnCrack[corners[last]]))
    {
      continue;
    }
    if (this->IsCrack(corners[first], corners[last]))
    {
      this->Mesh.Neighbors[k] = NoId;
      continue;
    }
    for (Id other = 3 * neighbor; other < 3 * neighbor + 3; ++other)
    {
      for (const Id own : { first, last })
      {
        if (corners[other] == corners[own])
        {
          sectors.Unite(own, other);
        }
      }
    }
  }
  this->NewCorners = corners;
  std::vector<std::uint8_t> isTaken(this->Mesh.Points.size(), 0);
  for (std::size_t k = 0; k < corners.size(); ++k)
  {
    const Id vertex = corners[k];
    const Id sector = sectors.SetOf(static_cast<Id>(k));
    if (!this->IsOnCrack[vertex] || sector != static_cast<Id>(k))
    {
      this->NewCorners[k] = this->NewCorners[sector];
    }
    else if (isTaken[vertex])
    {
      this->NewCorners[k] = static_cast<Id>(this->Mesh.Points.size() + this->Copied.size());
      this->Copied.push_back(vertex);
    }
    isTaken[vertex] = 1;
  }
}

void Opening::DoubleVertices()
{
  const auto copy = [this](auto& values)
  {
    values.reserve(values.size() + this->Copied.size());
    for (const Id vertex : this->Copied)
    {
      values.push_back(values[vertex]);
    }
  };
  copy(this->Mesh.Points);
  copy(this->Mesh.Spacing);
  copy(this->Mesh.BiteOrders);
  copy(this->Mesh.Kinds);
  copy(this->Mesh.OriginalPoints);
  for (std::vector<Id>& partners : this->Mesh.Partners)
  {
    for (const Id vertex : this->Copied)
    {
      const Id partner = partners[vertex];
      partners[partner == NoId ? vertex : partner] = NoId;
      partners[vertex] = NoId;
    }
    copy(partners);
  }
}

void Opening::AddEdge(std::size_t edge, Id corner, BitingMesh& edges) const
{
  edges.EdgeStarts.push_back(this->NewCorners[corner]);
  edges.EdgeEnds.push_back(this->NewCorners[NextCorner(corner)]);
  edges.EdgeCells.push_back(this->Mesh.EdgeCells[edge]);
  edges.EdgeIsBoundary.push_back(this->Mesh.EdgeIsBoundary[edge]);
}

// Of a closed edge both sides have the same vertices.
void Opening::DoubleEdges()
{
  BitingMesh edges;
  for (std::size_t edge = 0; edge < this->Mesh.EdgeStarts.size(); ++edge)
  {
    const Id start = this->Mesh.EdgeStarts[edge];
    const Id end = this->Mesh.EdgeEnds[edge];
    const Id half = this->Halves[{ start, end }];
    const Id twin = this->Halves[{ end, start }];
    if (half != NoId)
    {
      this->AddEdge(edge, half, edges);
    }
    if (twin != NoId && (half == NoId || this->IsCrack(start, end)))
    {
      this->AddEdge(edge, twin, edges);
    }
  }
  this->Mesh.EdgeStarts.swap(edges.EdgeStarts);
  this->Mesh.EdgeEnds.swap(edges.EdgeEnds);
  this->Mesh.EdgeCells.swap(edges.EdgeCells);
  this->Mesh.EdgeIsBoundary.swap(edges.EdgeIsBoundary);
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

void OpenInterfaces(const std::function<bool(Id)>& opens, BitingMesh& mesh, Monitor& monitor)
{
  Opening opening(opens, mesh);
  if (!opening.IsEmpty())
  {
    opening.Run();
    mesh.Quality =
      MeasureQuality({ mesh.Points, mesh.Spacing, mesh.Corners, mesh.Neighbors }, monitor);
  }
}

} // namespace biting
