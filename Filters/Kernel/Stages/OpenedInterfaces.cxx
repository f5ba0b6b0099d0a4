// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "OpenedInterfaces.h"

#include "../Base/Directory.h"
#include "../Base/DisjointSets.h"
#include "../Quality/Quality.h"

#include <cstdint> // for flags
#include <utility> // for pair, swap

namespace biting
{

namespace
{

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
