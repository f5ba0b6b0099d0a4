// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "OpenedInterfaces.h"

#include "../Base/DisjointSets.h"
#include "../Quality/Quality.h"

#include <algorithm> // for binary_search, lower_bound, minmax, sort
#include <utility>   // for pair, swap

namespace biting
{

namespace
{

using Ends = std::pair<Id, Id>;

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
        this->Cracks.push_back(std::minmax({ mesh.EdgeStarts[edge], mesh.EdgeEnds[edge] }));
        this->IsOnCrack[mesh.EdgeStarts[edge]] = 1;
        this->IsOnCrack[mesh.EdgeEnds[edge]] = 1;
      }
    }
    std::sort(this->Cracks.begin(), this->Cracks.end());
  }

  bool IsEmpty() const { return this->Cracks.empty(); }

  void Run()
  {
    this->ListHalves();
    this->NumberSectors();
    this->DoubleVertices();
    this->DoubleEdges();
    this->Mesh.Corners = this->NewCorners;
  }

private:
  // A triangle's edge from Start to End, with the corner at Start.
  struct Half
  {
    Ends Way;
    Id Start;
    Id End;
  };

  bool IsCrack(Id a, Id b) const
  {
    return std::binary_search(
      this->Cracks.begin(), this->Cracks.end(), Ends(std::minmax({ a, b })));
  }

  static Id NextCorner(Id corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }

  void ListHalves();
  void NumberSectors();
  void DoubleVertices();
  void DoubleEdges();
  const Half* FindHalf(Id start, Id end) const;
  void AddEdge(std::size_t edge, const Half& half, BitingMesh& edges) const;

  BitingMesh& Mesh;
  std::vector<std::uint8_t> IsOnCrack; // of vertices
  std::vector<Ends> Cracks;            // edges that open, the lower vertex first
  std::vector<Half> Halves;            // those with an end on a crack, or of a listed edge
  std::vector<Id> NewCorners;
  std::vector<Id> Copied; // the vertex of each new one
};

// Only what has a vertex of boundary or interfaces at both ends can be asked for.
void Opening::ListHalves()
{
  std::vector<std::uint8_t> isListed = this->IsOnCrack;
  for (std::size_t edge = 0; edge < this->Mesh.EdgeStarts.size(); ++edge)
  {
    isListed[this->Mesh.EdgeStarts[edge]] = 1;
    isListed[this->Mesh.EdgeEnds[edge]] = 1;
  }
  for (std::size_t k = 0; k < this->Mesh.Corners.size(); ++k)
  {
    const Id corner = static_cast<Id>(k);
    const Id next = NextCorner(corner);
    const Ends way(this->Mesh.Corners[corner], this->Mesh.Corners[next]);
    if (isListed[way.first] && isListed[way.second])
    {
      this->Halves.push_back({ way, corner, next });
    }
  }
  std::sort(this->Halves.begin(), this->Halves.end(),
    [](const Half& a, const Half& b) { return a.Way < b.Way; });
}

const Opening::Half* Opening::FindHalf(Id start, Id end) const
{
  const Ends way(start, end);
  const auto found = std::lower_bound(this->Halves.begin(), this->Halves.end(), way,
    [](const Half& half, const Ends& wanted) { return half.Way < wanted; });
  return found != this->Halves.end() && found->Way == way ? &*found : nullptr;
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

void Opening::AddEdge(std::size_t edge, const Half& half, BitingMesh& edges) const
{
  edges.EdgeStarts.push_back(this->NewCorners[half.Start]);
  edges.EdgeEnds.push_back(this->NewCorners[half.End]);
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
    const Half* half = this->FindHalf(start, end);
    const Half* twin = this->FindHalf(end, start);
    if (half)
    {
      this->AddEdge(edge, *half, edges);
    }
    if (twin && (!half || this->IsCrack(start, end)))
    {
      this->AddEdge(edge, *twin, edges);
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
