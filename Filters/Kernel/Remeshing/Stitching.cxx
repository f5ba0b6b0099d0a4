// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Stitching.h"

#include "../Domain/AreaSum.h"

#include <algorithm> // for sort, lower_bound, binary_search, max, rotate, min_element
#include <array>     // for corners
#include <cmath>     // for abs
#include <limits>    // for epsilon
#include <utility>   // for move

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

void ListEdges(const std::vector<Id>& corners, const std::vector<Id>& neighbors,
  const std::vector<Id>& marks, BitingMesh& mesh)
{
  for (Id slot = 0; slot < static_cast<Id>(corners.size()); ++slot)
  {
    if (marks[slot] != NoId && neighbors[slot] < slot / 3)
    {
      const Id first = slot - slot % 3;
      mesh.EdgeStarts.push_back(corners[first + (slot + 1) % 3]);
      mesh.EdgeEnds.push_back(corners[first + (slot + 2) % 3]);
      mesh.EdgeCells.push_back(marks[slot] - 1); // Untagged: NoId
      mesh.EdgeIsBoundary.push_back(neighbors[slot] == NoId);
    }
  }
}

using Corners = std::array<Id, 3>;

// The same for the same triangle, whichever corner comes first.
Corners Turned(Id a, Id b, Id c)
{
  Corners corners{ a, b, c };
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  return corners;
}

class Stitcher
{
public:
  Stitcher(const OldMesh& mesh, const ChangedRegion& region, const RegionEdges& edges,
    const std::vector<double>& spacings, const CavityMesh& cavity)
    : Old(mesh)
    , Region(region)
    , Edges(edges)
    , Spacings(spacings)
    , Cavity(cavity)
  {
  }

  StitchedMesh Stitch()
  {
    this->NumberVertices();
    this->CopyVertices();
    this->CopyUnchanged();
    this->CopyCavity();
    this->FindOriginals();
    BitingMesh& mesh = this->Result.Mesh;
    ListEdges(mesh.Corners, mesh.Neighbors, this->Marks, mesh);
    this->SetKinds();
    return std::move(this->Result);
  }

private:
  bool IsOldVertex(Id vertex) const { return vertex < this->Cavity.Geometry.NumberOfVertices(); }

  // The edge of the region that a slot of the cavity's mesh lies on, or null.
  const RegionEdge* EdgeOf(Id slot) const
  {
    const Id constraint = this->Cavity.Triangles.Constraints[slot];
    return constraint == NoId ? nullptr
                              : &this->Edges.Edges[this->Cavity.Bites.EdgeSegments[constraint]];
  }

  void NumberVertices()
  {
    this->OldNumbers.assign(this->Old.Points.size(), NoId);
    this->Numbers.assign(this->Cavity.Bites.Points.size(), NoId);
    for (std::size_t slot = 0; slot < this->Old.Corners.size(); ++slot)
    {
      if (!this->Region.IsChanged[slot / 3])
      {
        this->OldNumbers[this->Old.Corners[slot]] = 0;
      }
    }
    for (const Id corner : this->Cavity.Triangles.Corners)
    {
      this->Numbers[corner] = 0;
      if (this->IsOldVertex(corner))
      {
        this->OldNumbers[this->Cavity.Geometry.VertexPoints[corner]] = 0;
      }
    }
  }

  void CopyVertices()
  {
    Id next = 0;
    for (Id vertex = 0; vertex < this->Old.NumberOfVertices(); ++vertex)
    {
      if (this->OldNumbers[vertex] != NoId)
      {
        this->OldNumbers[vertex] = next++;
        this->AddVertex(this->Old.Points[vertex], this->Spacings[vertex], NoId, vertex);
      }
    }
    const BitingResult& bites = this->Cavity.Bites;
    for (Id vertex = 0; vertex < static_cast<Id>(this->Numbers.size()); ++vertex)
    {
      if (this->Numbers[vertex] == NoId)
      {
        continue;
      }
      if (this->IsOldVertex(vertex))
      {
        this->Numbers[vertex] = this->OldNumbers[this->Cavity.Geometry.VertexPoints[vertex]];
        this->Result.Mesh.Spacing[this->Numbers[vertex]] = bites.Spacings[vertex];
        this->Result.Mesh.BiteOrders[this->Numbers[vertex]] = bites.BiteOrders[vertex];
      }
      else
      {
        this->Numbers[vertex] = next++;
        this->AddVertex(
          bites.Points[vertex], bites.Spacings[vertex], bites.BiteOrders[vertex], NoId);
      }
    }
  }

  void AddVertex(const Point2& place, double spacing, Id order, Id original)
  {
    BitingMesh& mesh = this->Result.Mesh;
    mesh.Points.push_back(place);
    mesh.Spacing.push_back(spacing);
    mesh.BiteOrders.push_back(order);
    mesh.OriginalPoints.push_back(original);
  }

  // Across the rim the neighbors are set with the cavity.
  void CopyUnchanged()
  {
    BitingMesh& mesh = this->Result.Mesh;
    this->TriangleNumbers.assign(this->Old.Regions.size(), NoId);
    Id next = 0;
    for (Id triangle = 0; triangle < this->Old.NumberOfTriangles(); ++triangle)
    {
      if (!this->Region.IsChanged[triangle])
      {
        this->TriangleNumbers[triangle] = next++;
        mesh.Regions.push_back(this->Old.Regions[triangle]);
        this->Result.OriginalTriangles.push_back(triangle);
      }
    }
    for (const Id triangle : this->Result.OriginalTriangles)
    {
      for (Id slot = 3 * triangle; slot < 3 * triangle + 3; ++slot)
      {
        const Id neighbor = this->Old.Neighbors[slot];
        mesh.Corners.push_back(this->OldNumbers[this->Old.Corners[slot]]);
        mesh.Neighbors.push_back(neighbor == NoId ? NoId : this->TriangleNumbers[neighbor]);
        this->Marks.push_back(this->Old.Marks[slot]);
      }
    }
  }

  void CopyCavity()
  {
    const Triangulation& triangles = this->Cavity.Triangles;
    const Id first = static_cast<Id>(this->Result.OriginalTriangles.size());
    for (Id slot = 0; slot < static_cast<Id>(triangles.Corners.size()); ++slot)
    {
      this->CopySlot(slot, first);
    }
    for (const Id face : triangles.Regions)
    {
      this->Result.Mesh.Regions.push_back(this->Cavity.FaceRegions[face]);
      this->Result.OriginalTriangles.push_back(NoId);
    }
  }

  void CopySlot(Id slot, Id first)
  {
    BitingMesh& mesh = this->Result.Mesh;
    const RegionEdge* edge = this->EdgeOf(slot);
    Id neighbor = this->Cavity.Triangles.Neighbors[slot];
    neighbor = neighbor == NoId ? NoId : first + neighbor;
    if (edge && edge->RimSlot != NoId)
    {
      neighbor = this->TriangleNumbers[edge->RimSlot / 3];
      mesh.Neighbors[3 * neighbor + edge->RimSlot % 3] = first + slot / 3;
    }
    mesh.Corners.push_back(this->Numbers[this->Cavity.Triangles.Corners[slot]]);
    mesh.Neighbors.push_back(neighbor);
    this->Marks.push_back(edge ? edge->Mark : NoId);
  }

  // Triangles that came back as they were.
  void FindOriginals()
  {
    const BitingMesh& mesh = this->Result.Mesh;
    std::vector<std::pair<Corners, Id>> old;
    for (const Id triangle : this->Region.Triangles)
    {
      const Id* corners = this->Old.Corners.data() + 3 * static_cast<std::size_t>(triangle);
      const auto number = [this, corners](int k) { return this->OldNumbers[corners[k]]; };
      const bool isRepaired = !this->Old.IsRepaired.empty() && this->Old.IsRepaired[triangle];
      if (number(0) != NoId && number(1) != NoId && number(2) != NoId && !isRepaired)
      {
        old.emplace_back(Turned(number(0), number(1), number(2)), triangle);
      }
    }
    std::sort(old.begin(), old.end());
    for (std::size_t triangle = 0; triangle < mesh.Regions.size(); ++triangle)
    {
      if (this->Result.OriginalTriangles[triangle] == NoId)
      {
        const Id* corners = mesh.Corners.data() + 3 * triangle;
        const Corners key = Turned(corners[0], corners[1], corners[2]);
        const auto same = std::lower_bound(old.begin(), old.end(), std::make_pair(key, NoId));
        const bool isSame = same != old.end() && same->first == key;
        this->Result.OriginalTriangles[triangle] = isSame ? same->second : NoId;
      }
    }
  }

  void SetKinds()
  {
    BitingMesh& mesh = this->Result.Mesh;
    std::vector<std::array<Id, 2>> ends(mesh.Points.size());
    std::vector<Id> counts(mesh.Points.size(), 0);
    for (std::size_t edge = 0; edge < mesh.EdgeStarts.size(); ++edge)
    {
      const Id start = mesh.EdgeStarts[edge];
      const Id end = mesh.EdgeEnds[edge];
      ends[start][counts[start]++ == 0 ? 0 : 1] = end;
      ends[end][counts[end]++ == 0 ? 0 : 1] = start;
    }
    for (Id vertex = 0; vertex < static_cast<Id>(mesh.Points.size()); ++vertex)
    {
      const Id original = mesh.OriginalPoints[vertex];
      const bool isEmbedded = original != NoId && this->Old.IsFixed[original];
      mesh.Kinds.push_back(counts[vertex] > 0
          ? this->KindOnEdge(vertex, ends[vertex], counts[vertex])
          : isEmbedded ? VertexKind::Embedded
                       : VertexKind::Interior);
    }
  }

  // Where the edges end, meet others or turn is a vertex that was given.
  VertexKind KindOnEdge(Id vertex, const std::array<Id, 2>& ends, Id count) const
  {
    const std::vector<Point2>& points = this->Result.Mesh.Points;
    if (this->Result.Mesh.OriginalPoints[vertex] == NoId)
    {
      return VertexKind::Boundary;
    }
    if (count != 2)
    {
      return VertexKind::Input;
    }
    const Point2 across = points[ends[1]] - points[ends[0]];
    const double turn = std::abs(Cross(across, points[vertex] - points[ends[0]]));
    return turn <= this->Old.Rounding * Length(across) ? VertexKind::Boundary : VertexKind::Input;
  }

  const OldMesh& Old;
  const ChangedRegion& Region;
  const RegionEdges& Edges;
  const std::vector<double>& Spacings;
  const CavityMesh& Cavity;
  std::vector<Id> OldNumbers; ///< of old vertices in the new mesh, NoId where they are gone
  std::vector<Id> Numbers;    ///< of the cavity's vertices
  std::vector<Id> TriangleNumbers;
  std::vector<Id> Marks; ///< of the new slots
  StitchedMesh Result;
};

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

BitingMesh EdgesOf(const OldMesh& mesh)
{
  BitingMesh edges;
  ListEdges(mesh.Corners, mesh.Neighbors, mesh.Marks, edges);
  return edges;
}

std::string CheckRim(const OldMesh& mesh, const ChangedRegion& region, const RegionEdges& edges,
  const CavityMesh& cavity)
{
  const std::vector<std::pair<Id, Id>> rest = FreeEdgesOfRest(mesh, region);
  const std::vector<Id>& corners = cavity.Triangles.Corners;
  const std::vector<Id>& vertexPoints = cavity.Geometry.VertexPoints;
  for (std::size_t slot = 0; slot < corners.size(); ++slot)
  {
    const Id constraint = cavity.Triangles.Constraints[slot];
    const Id rimSlot =
      constraint == NoId ? NoId : edges.Edges[cavity.Bites.EdgeSegments[constraint]].RimSlot;
    const Id start = corners[slot - slot % 3 + (slot + 1) % 3];
    const Id end = corners[slot - slot % 3 + (slot + 2) % 3];
    const Id count = cavity.Geometry.NumberOfVertices();
    if (rimSlot != NoId && (start >= count || vertexPoints[start] != mesh.End(rimSlot)))
    {
      return "a triangle lies on the side of the rim that is unchanged";
    }
    if (cavity.Triangles.Neighbors[slot] == NoId && start < count && end < count &&
      std::binary_search(
        rest.begin(), rest.end(), std::minmax({ vertexPoints[start], vertexPoints[end] })))
    {
      return "an edge lies on one of what is unchanged";
    }
  }
  return {};
}

StitchedMesh Stitch(const OldMesh& mesh, const ChangedRegion& region, const RegionEdges& edges,
  const std::vector<double>& spacings, const CavityMesh& cavity)
{
  return Stitcher(mesh, region, edges, spacings, cavity).Stitch();
}

} // namespace biting
