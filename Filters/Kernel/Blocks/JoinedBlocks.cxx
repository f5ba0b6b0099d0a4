// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "JoinedBlocks.h"

#include "../Base/DisjointSets.h"
#include "../Base/SortInSteps.h"
#include "../Base/Tasks.h"
#include "StripParts.h"

#include <algorithm> // for max, max_element, stable_sort
#include <tuple>     // for comparing
#include <utility>   // for move

namespace biting
{

namespace
{

// Where copying begins and ends, as shares of the time.
constexpr double VerticesEnd = 0.3;
constexpr double CopyingEnd = 0.9;

// A constraint of a block on a segment of the domain.
struct JoinedEdge
{
  Id Segment;
  double Along; ///< of its start, on the segment
  Id Start;
  Id End;
  std::size_t Block;
  std::size_t Edge; ///< of the block
};

// A side of a part of a cut.
struct CutSide
{
  Id Piece = NoId;
  Id Triangle = NoId;
  Id Slot = NoId;
};

class Joiner
{
public:
  Joiner(
    const Domain& domain, const BlockDomains& blocks, std::vector<BlockMesh>& meshes, Pulse& pulse)
    : Geometry(domain)
    , Parts(blocks)
    , Meshes(meshes)
    , Beats(pulse)
    , Places(meshes.size() + 1)
    , EdgePlaces(meshes.size())
    , Sides(meshes.size())
    , NearCuts(meshes.size())
  {
  }

  JoinedMesh Join()
  {
    this->NumberShared();
    this->PlaceBlocks();
    this->JoinEdges();
    if (!this->JoinVertices() || !this->JoinTriangles())
    {
      return {};
    }
    this->LinkCuts();
    this->NumberRegions();
    this->Result.Places = std::move(this->Places);
    return std::move(this->Result);
  }

private:
  // Vertices of the domain, and those of the graph that a block has.
  void NumberShared()
  {
    const CutGraph& graph = this->Parts.Graph;
    std::vector<std::uint8_t> isUsed(graph.Vertices.size(), 0);
    for (const BlockDomain& block : this->Parts.Blocks)
    {
      for (const Id vertex : block.Vertices)
      {
        isUsed[vertex] = 1;
      }
    }
    BitingResult& bites = this->Result.Bites;
    this->SharedNumbers.assign(graph.Vertices.size(), NoId);
    for (std::size_t vertex = 0; vertex < graph.Vertices.size(); ++vertex)
    {
      if (vertex < this->Geometry.Vertices.size() || isUsed[vertex] != 0)
      {
        this->SharedNumbers[vertex] = static_cast<Id>(bites.Points.size());
        bites.Points.push_back(graph.Vertices[vertex]);
        bites.Segments.push_back(graph.Segments[vertex]);
      }
    }
    bites.Spacings.assign(bites.Points.size(), 0.0);
    bites.BiteOrders.assign(bites.Points.size(), NoId);
    this->Places[0].Vertex = static_cast<Id>(bites.Points.size());
  }

  // Vertices, bites, triangles and faces are numbered block after block.
  void PlaceBlocks()
  {
    for (std::size_t block = 0; block < this->Meshes.size() && this->Beats.Ask(); ++block)
    {
      const BlockMesh& mesh = this->Meshes[block];
      const std::vector<Id>& regions = mesh.Triangles.Regions;
      const std::size_t shared = this->Parts.Blocks[block].Vertices.size();
      const auto sizeOf = [](const std::vector<Id>& numbers)
      { return numbers.empty() ? 0 : 1 + *std::max_element(numbers.begin(), numbers.end()); };
      this->AddShared(block);
      const BlockPlace& place = this->Places[block];
      this->Places[block + 1] = { place.Vertex + static_cast<Id>(mesh.Bites.Points.size() - shared),
        place.Order + std::max(mesh.NumberOfOrders, sizeOf(mesh.Bites.BiteOrders)),
        place.Triangle + mesh.Triangles.NumberOfTriangles(), place.Face + sizeOf(regions) };
    }
    this->JoinedFaces = DisjointSets(static_cast<std::size_t>(this->Places.back().Face));
  }

  void AddShared(std::size_t block)
  {
    const BitingResult& from = this->Meshes[block].Bites;
    const std::vector<Id>& shared = this->Parts.Blocks[block].Vertices;
    for (std::size_t vertex = 0; vertex < shared.size(); ++vertex)
    {
      const Id number = this->SharedNumbers[shared[vertex]];
      const Id order = from.BiteOrders[vertex];
      Id& joined = this->Result.Bites.BiteOrders[number];
      this->Result.Bites.Spacings[number] = from.Spacings[vertex];
      joined = joined != NoId || order == NoId ? joined : this->Places[block].Order + order;
    }
  }

  // Segment by segment, from start to end.
  void JoinEdges()
  {
    for (std::size_t block = 0; block < this->Meshes.size(); ++block)
    {
      this->ListEdges(block);
    }
    SortInSteps(
      this->Edges,
      [](const JoinedEdge& a, const JoinedEdge& b)
      {
        return std::tie(a.Segment, a.Along, a.Block, a.Edge) <
          std::tie(b.Segment, b.Along, b.Block, b.Edge);
      },
      this->Beats);
    BitingResult& bites = this->Result.Bites;
    for (const JoinedEdge& edge : this->Edges)
    {
      this->EdgePlaces[edge.Block][edge.Edge] = static_cast<Id>(bites.EdgeStarts.size());
      bites.EdgeStarts.push_back(edge.Start);
      bites.EdgeEnds.push_back(edge.End);
      bites.EdgeSegments.push_back(edge.Segment);
    }
    this->EdgeFaces.assign(2 * this->Edges.size(), NoId);
  }

  void ListEdges(std::size_t block)
  {
    const BitingResult& from = this->Meshes[block].Bites;
    const BlockDomain& part = this->Parts.Blocks[block];
    this->EdgePlaces[block].assign(from.EdgeSegments.size(), NoId);
    for (std::size_t edge = 0; edge < from.EdgeSegments.size(); ++edge)
    {
      const Id segment = this->Parts.Graph.Pieces[part.Pieces[from.EdgeSegments[edge]]].Segment;
      if (segment != NoId && this->Beats.Beat())
      {
        const Point2& a = this->Geometry.Vertices[this->Geometry.Starts[segment]];
        const Point2& b = this->Geometry.Vertices[this->Geometry.Ends[segment]];
        const double along = Dot(from.Points[from.EdgeStarts[edge]] - a, b - a);
        this->Edges.push_back({ segment, along, this->NumberOf(block, from.EdgeStarts[edge]),
          this->NumberOf(block, from.EdgeEnds[edge]), block, edge });
      }
    }
  }

  // What blocks have of vertices is given back before there are triangles, the most of a mesh.
  bool JoinVertices()
  {
    const PulsePart part(this->Beats, 0.0, VerticesEnd);
    const std::size_t vertices = static_cast<std::size_t>(this->Places.back().Vertex);
    BitingResult& bites = this->Result.Bites;
    bites.Points.resize(vertices);
    bites.Spacings.resize(vertices);
    bites.BiteOrders.resize(vertices);
    bites.Segments.resize(vertices);
    return DoTasks(this->Beats, this->Meshes.size(),
      [this](std::size_t block, Monitor& own)
      {
        Pulse pulse(own);
        this->CopyVertices(block, pulse);
        BitingResult& from = this->Meshes[block].Bites;
        ReleaseInSteps(pulse, from.Points, from.Spacings, from.BiteOrders, from.Segments);
      });
  }

  bool JoinTriangles()
  {
    const PulsePart part(this->Beats, VerticesEnd, CopyingEnd);
    const std::size_t triangles = static_cast<std::size_t>(this->Places.back().Triangle);
    Triangulation& mesh = this->Result.Triangles;
    for (std::vector<Id>* slots : { &mesh.Corners, &mesh.Neighbors, &mesh.Constraints })
    {
      slots->resize(3 * triangles);
    }
    mesh.Regions.resize(triangles);
    this->Faces.resize(triangles);
    DoTasks(this->Beats, this->Meshes.size(),
      [this](std::size_t block, Monitor& own)
      {
        Pulse pulse(own);
        this->CopyTriangles(block, pulse);
        this->FindNearCuts(block, pulse);
        this->Meshes[block] = BlockMesh();
      });
    for (const TriangleList& near : this->NearCuts)
    {
      this->Result.NearCuts.insert(this->Result.NearCuts.end(), near.begin(), near.end());
    }
    return !this->Beats.HasStopped();
  }

  void CopyVertices(std::size_t block, Pulse& pulse)
  {
    const BitingResult& from = this->Meshes[block].Bites;
    const BlockDomain& part = this->Parts.Blocks[block];
    BitingResult& to = this->Result.Bites;
    const std::size_t shared = part.Vertices.size();
    pulse.ForEach(from.Points.size() - shared,
      [this, block, shared, &from, &part, &to](std::size_t k)
      {
        const std::size_t vertex = shared + k;
        const std::size_t number = static_cast<std::size_t>(this->Places[block].Vertex) + k;
        const Id order = from.BiteOrders[vertex];
        const Id segment = from.Segments[vertex];
        to.Points[number] = from.Points[vertex];
        to.Spacings[number] = from.Spacings[vertex];
        to.BiteOrders[number] = order == NoId ? NoId : this->Places[block].Order + order;
        to.Segments[number] =
          segment == NoId ? NoId : this->Parts.Graph.Pieces[part.Pieces[segment]].Segment;
      });
  }

  void CopyTriangles(std::size_t block, Pulse& pulse)
  {
    const Triangulation& from = this->Meshes[block].Triangles;
    const BlockPlace& place = this->Places[block];
    pulse.ForEach(
      from.Corners.size(), [this, block](std::size_t slot) { this->CopySlot(block, slot); });
    pulse.ForEach(from.Regions.size(),
      [this, &from, &place](std::size_t triangle)
      {
        this->Faces[static_cast<std::size_t>(place.Triangle) + triangle] =
          place.Face + from.Regions[triangle];
      });
  }

  // Finds the triangles of the block near its cuts. A triangle near the cut of another block is
  // near a cut of its own block, too.
  void FindNearCuts(std::size_t block, Pulse& pulse)
  {
    const BlockMesh& mesh = this->Meshes[block];
    const std::vector<Id>& edges = this->EdgePlaces[block];
    std::vector<Id> ends;
    for (std::size_t edge = 0; edge < edges.size(); ++edge)
    {
      if (edges[edge] == NoId)
      {
        ends.insert(ends.end(), { mesh.Bites.EdgeStarts[edge], mesh.Bites.EdgeEnds[edge] });
      }
    }
    TriangleList& triangles = this->NearCuts[block];
    triangles = TrianglesAround(mesh.Triangles, this->NumberOfVertices(block), ends, pulse);
    for (Id& triangle : triangles)
    {
      triangle += this->Places[block].Triangle;
    }
  }

  void CopySlot(std::size_t block, std::size_t slot)
  {
    const BlockMesh& mesh = this->Meshes[block];
    const Triangulation& from = mesh.Triangles;
    const BlockPlace& place = this->Places[block];
    Triangulation& to = this->Result.Triangles;
    const std::size_t joined = 3 * static_cast<std::size_t>(place.Triangle) + slot;
    const Id neighbor = from.Neighbors[slot];
    to.Corners[joined] = this->NumberOf(block, from.Corners[slot]);
    to.Neighbors[joined] = neighbor == NoId ? NoId : place.Triangle + neighbor;
    to.Constraints[joined] = NoId;
    const Id constraint = from.Constraints[slot];
    if (constraint == NoId)
    {
      return;
    }
    const Id edge = this->EdgePlaces[block][constraint];
    to.Constraints[joined] = edge;
    if (edge == NoId)
    {
      const Id piece = this->Parts.Blocks[block].Pieces[mesh.Bites.EdgeSegments[constraint]];
      this->Sides[block].push_back({ piece, static_cast<Id>(joined / 3), static_cast<Id>(joined) });
      return;
    }
    const Id start = this->NumberOf(block, from.Corners[slot - slot % 3 + (slot + 1) % 3]);
    const std::size_t side = start == this->Result.Bites.EdgeStarts[edge] ? 0 : 1;
    this->EdgeFaces[2 * static_cast<std::size_t>(edge) + side] =
      place.Face + from.Regions[slot / 3];
  }

  // The two sides of a part of a cut are in different blocks.
  void LinkCuts()
  {
    std::vector<CutSide> sides;
    for (const std::vector<CutSide>& ofBlock : this->Sides)
    {
      sides.insert(sides.end(), ofBlock.begin(), ofBlock.end());
    }
    std::stable_sort(sides.begin(), sides.end(),
      [](const CutSide& a, const CutSide& b) { return a.Piece < b.Piece; });
    this->Result.IsSound = sides.size() % 2 == 0;
    for (std::size_t k = 0; k < sides.size() && this->Result.IsSound; k += 2)
    {
      this->Result.IsSound = this->Fits(sides[k], sides[k + 1]);
      if (this->Result.IsSound)
      {
        this->Link(sides[k], sides[k + 1]);
      }
    }
  }

  void Link(const CutSide& side, const CutSide& other)
  {
    Triangulation& mesh = this->Result.Triangles;
    mesh.Neighbors[side.Slot] = other.Triangle;
    mesh.Neighbors[other.Slot] = side.Triangle;
    this->JoinedFaces.Unite(this->Faces[side.Triangle], this->Faces[other.Triangle]);
  }

  bool Fits(const CutSide& side, const CutSide& other) const
  {
    const std::vector<Id>& corners = this->Result.Triangles.Corners;
    const auto corner = [&corners](Id slot, Id turn)
    { return corners[slot - slot % 3 + (slot + turn) % 3]; };
    return side.Piece == other.Piece && corner(side.Slot, 1) == corner(other.Slot, 2) &&
      corner(side.Slot, 2) == corner(other.Slot, 1);
  }

  // Regions are numbered in the order of the constraints, the left side of each before the right.
  void NumberRegions()
  {
    std::vector<Id> numbers(this->JoinedFaces.Size(), NoId);
    Id next = 0;
    for (const Id face : this->EdgeFaces)
    {
      if (face != NoId && numbers[this->JoinedFaces.SetOf(face)] == NoId)
      {
        numbers[this->JoinedFaces.SetOf(face)] = next++;
      }
    }
    for (Id face = 0; face < static_cast<Id>(numbers.size()); ++face)
    {
      numbers[face] = numbers[this->JoinedFaces.SetOf(face)];
    }
    ForEachAtOnce(this->Beats, this->Faces.size(),
      [this, &numbers](std::size_t triangle)
      { this->Result.Triangles.Regions[triangle] = numbers[this->Faces[triangle]]; });
    this->Result.FaceRegions = std::move(numbers);
  }

  Id NumberOf(std::size_t block, Id vertex) const
  {
    const std::vector<Id>& shared = this->Parts.Blocks[block].Vertices;
    const Id count = static_cast<Id>(shared.size());
    return vertex < count ? this->SharedNumbers[shared[vertex]]
                          : this->Places[block].Vertex + vertex - count;
  }

  std::size_t NumberOfVertices(std::size_t block) const
  {
    const Id own = this->Places[block + 1].Vertex - this->Places[block].Vertex;
    return this->Parts.Blocks[block].Vertices.size() + static_cast<std::size_t>(own);
  }

  const Domain& Geometry;
  const BlockDomains& Parts;
  std::vector<BlockMesh>& Meshes;
  Pulse& Beats;
  JoinedMesh Result;

  std::vector<Id> SharedNumbers;           ///< of the graph's vertices
  std::vector<BlockPlace> Places;          ///< of the blocks, and past the last
  std::vector<JoinedEdge> Edges;           ///< in their order
  std::vector<std::vector<Id>> EdgePlaces; ///< of the edges of each block in Edges, or NoId
  std::vector<std::vector<CutSide>> Sides; ///< of each block
  std::vector<TriangleList> NearCuts;      ///< of each block, in the whole
  std::vector<Id> Faces;                   ///< of the triangles
  std::vector<Id> EdgeFaces;               ///< to the left and the right of the edges
  DisjointSets JoinedFaces;
};

} // namespace

JoinedMesh JoinBlocks(
  const Domain& domain, const BlockDomains& blocks, std::vector<BlockMesh> meshes, Pulse& pulse)
{
  return Joiner(domain, blocks, meshes, pulse).Join();
}

} // namespace biting
