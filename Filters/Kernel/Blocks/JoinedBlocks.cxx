// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "JoinedBlocks.h"

#include <algorithm> // for sort, max
#include <numeric>   // for iota
#include <tuple>     // for comparing
#include <utility>   // for move, swap

namespace biting
{

namespace
{

// A constraint of a block on a segment of the domain.
struct JoinedEdge
{
  Id Segment;
  double Along; ///< of its start, on the segment
  Id Start;
  Id End;
  std::size_t Slot; ///< where its number is asked for
};

// A side of a part of a cut.
struct CutSide
{
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
  {
  }

  JoinedMesh Join();

private:
  void NumberShared();
  void CopyBlock(std::size_t block);
  Id Shared(std::size_t block, Id vertex);
  void CopyVertices(std::size_t block);
  void CopyEdges(std::size_t block);
  void CopyTriangles(std::size_t block);
  void SortEdges();
  void LinkCuts();
  bool Fits(const CutSide& side, const CutSide& other) const;
  void NumberRegions();
  Id Face(Id face);

  const Domain& Geometry;
  const BlockDomains& Parts;
  std::vector<BlockMesh>& Meshes;
  Pulse& Beats;
  JoinedMesh Result;

  std::vector<Id> SharedNumbers; ///< of the graph's vertices
  std::vector<Id> Numbers;       ///< of the block's vertices
  Id FirstOrder = 0;             ///< of the block's bites
  std::vector<JoinedEdge> Edges;
  std::vector<std::size_t> Slots; ///< of the block's constraints: places in Edges
  std::vector<CutSide> Sides;     ///< two a piece
  std::vector<Id> Faces;          ///< of the triangles: a region of a block
  std::vector<Id> Parents;        ///< of the faces: one that is joined with it, not greater
};

JoinedMesh Joiner::Join()
{
  this->NumberShared();
  this->Sides.resize(2 * this->Parts.Graph.Pieces.size());
  for (std::size_t block = 0; block < this->Meshes.size() && this->Beats.Ask(); ++block)
  {
    this->CopyBlock(block);
  }
  if (this->Beats.HasStopped())
  {
    return {};
  }
  this->SortEdges();
  this->LinkCuts();
  this->NumberRegions();
  return std::move(this->Result);
}

// Vertices of the domain, and those of the graph that a block has.
void Joiner::NumberShared()
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
  this->Result.IsOnCut.assign(bites.Points.size(), 0);
}

void Joiner::CopyBlock(std::size_t block)
{
  this->CopyVertices(block);
  this->CopyEdges(block);
  this->CopyTriangles(block);
  this->Meshes[block] = BlockMesh();
}

void Joiner::CopyVertices(std::size_t block)
{
  const BitingResult& from = this->Meshes[block].Bites;
  const BlockDomain& part = this->Parts.Blocks[block];
  BitingResult& to = this->Result.Bites;
  Id orders = 0;
  this->Numbers.resize(from.Points.size());
  for (std::size_t vertex = 0; vertex < from.Points.size(); ++vertex)
  {
    const Id order = from.BiteOrders[vertex];
    const Id joinedOrder = order == NoId ? NoId : this->FirstOrder + order;
    orders = std::max(orders, order + 1);
    if (vertex < part.Vertices.size())
    {
      const Id number = this->SharedNumbers[part.Vertices[vertex]];
      this->Numbers[vertex] = number;
      const bool isFirst = to.BiteOrders[number] == NoId;
      to.Spacings[number] = from.Spacings[vertex];
      to.BiteOrders[number] = isFirst ? joinedOrder : to.BiteOrders[number];
      continue;
    }
    this->Numbers[vertex] = static_cast<Id>(to.Points.size());
    const Id segment = from.Segments[vertex];
    to.Points.push_back(from.Points[vertex]);
    to.Spacings.push_back(from.Spacings[vertex]);
    to.BiteOrders.push_back(joinedOrder);
    to.Segments.push_back(
      segment == NoId ? NoId : this->Parts.Graph.Pieces[part.Pieces[segment]].Segment);
  }
  this->FirstOrder += orders;
}

void Joiner::CopyEdges(std::size_t block)
{
  const BitingResult& from = this->Meshes[block].Bites;
  const BlockDomain& part = this->Parts.Blocks[block];
  this->Slots.assign(from.EdgeSegments.size(), 0);
  for (std::size_t edge = 0; edge < from.EdgeSegments.size(); ++edge)
  {
    const Id segment = this->Parts.Graph.Pieces[part.Pieces[from.EdgeSegments[edge]]].Segment;
    this->Slots[edge] = this->Edges.size();
    if (segment != NoId)
    {
      const Point2& a = this->Geometry.Vertices[this->Geometry.Starts[segment]];
      const Point2& b = this->Geometry.Vertices[this->Geometry.Ends[segment]];
      const double along = Dot(from.Points[from.EdgeStarts[edge]] - a, b - a);
      this->Edges.push_back({ segment, along, this->Numbers[from.EdgeStarts[edge]],
        this->Numbers[from.EdgeEnds[edge]], this->Edges.size() });
    }
  }
}

void Joiner::CopyTriangles(std::size_t block)
{
  const BlockMesh& mesh = this->Meshes[block];
  const BlockDomain& part = this->Parts.Blocks[block];
  const Triangulation& from = mesh.Triangles;
  Triangulation& to = this->Result.Triangles;
  const Id first = to.NumberOfTriangles();
  const Id firstFace = static_cast<Id>(this->Parents.size());
  for (std::size_t slot = 0; slot < from.Corners.size(); ++slot)
  {
    const Id constraint = from.Constraints[slot];
    const Id piece = constraint == NoId ? NoId : part.Pieces[mesh.Bites.EdgeSegments[constraint]];
    const bool isCut = piece != NoId && this->Parts.Graph.IsCut(piece);
    if (isCut)
    {
      CutSide& side = this->Sides[2 * static_cast<std::size_t>(piece)];
      CutSide& free = side.Triangle == NoId ? side : *(&side + 1);
      this->Result.IsSound = this->Result.IsSound && free.Triangle == NoId;
      free = { first + static_cast<Id>(slot / 3), static_cast<Id>(to.Corners.size()) };
    }
    to.Corners.push_back(this->Numbers[from.Corners[slot]]);
    to.Neighbors.push_back(from.Neighbors[slot] == NoId ? NoId : first + from.Neighbors[slot]);
    to.Constraints.push_back(
      piece == NoId || isCut ? NoId : static_cast<Id>(this->Slots[constraint]));
  }
  Id faces = 0;
  for (const Id region : from.Regions)
  {
    this->Faces.push_back(firstFace + region);
    faces = std::max(faces, region + 1);
  }
  this->Parents.resize(this->Parents.size() + static_cast<std::size_t>(faces));
  std::iota(this->Parents.begin() + firstFace, this->Parents.end(), firstFace);
}

// Segment by segment, from start to end.
void Joiner::SortEdges()
{
  std::sort(this->Edges.begin(), this->Edges.end(),
    [](const JoinedEdge& a, const JoinedEdge& b)
    { return std::tie(a.Segment, a.Along, a.Slot) < std::tie(b.Segment, b.Along, b.Slot); });
  std::vector<Id> places(this->Edges.size());
  BitingResult& bites = this->Result.Bites;
  for (std::size_t place = 0; place < this->Edges.size(); ++place)
  {
    const JoinedEdge& edge = this->Edges[place];
    places[edge.Slot] = static_cast<Id>(place);
    bites.EdgeStarts.push_back(edge.Start);
    bites.EdgeEnds.push_back(edge.End);
    bites.EdgeSegments.push_back(edge.Segment);
  }
  for (Id& constraint : this->Result.Triangles.Constraints)
  {
    constraint = constraint == NoId ? NoId : places[constraint];
  }
}

void Joiner::LinkCuts()
{
  Triangulation& mesh = this->Result.Triangles;
  this->Result.IsOnCut.resize(this->Result.Bites.Points.size(), 0);
  for (std::size_t piece = 0; piece < this->Sides.size(); piece += 2)
  {
    const CutSide& side = this->Sides[piece];
    const CutSide& other = this->Sides[piece + 1];
    if (side.Triangle == NoId)
    {
      continue;
    }
    if (!this->Fits(side, other))
    {
      this->Result.IsSound = false;
      return;
    }
    mesh.Neighbors[side.Slot] = other.Triangle;
    mesh.Neighbors[other.Slot] = side.Triangle;
    for (const Id slot : { side.Slot, other.Slot })
    {
      this->Result.IsOnCut[mesh.Corners[slot - slot % 3 + (slot + 1) % 3]] = 1;
    }
    Id face = this->Face(this->Faces[side.Triangle]);
    Id joined = this->Face(this->Faces[other.Triangle]);
    this->Parents[std::max(face, joined)] = std::min(face, joined);
  }
}

bool Joiner::Fits(const CutSide& side, const CutSide& other) const
{
  const std::vector<Id>& corners = this->Result.Triangles.Corners;
  const auto corner = [&corners](Id slot, Id turn)
  { return corners[slot - slot % 3 + (slot + turn) % 3]; };
  return other.Triangle != NoId && corner(side.Slot, 1) == corner(other.Slot, 2) &&
    corner(side.Slot, 2) == corner(other.Slot, 1);
}

Id Joiner::Face(Id face)
{
  while (this->Parents[face] != face)
  {
    this->Parents[face] = this->Parents[this->Parents[face]];
    face = this->Parents[face];
  }
  return face;
}

// As one meets them along the constraints, the left side of each before the right.
void Joiner::NumberRegions()
{
  Triangulation& mesh = this->Result.Triangles;
  const BitingResult& bites = this->Result.Bites;
  std::vector<Id> faces(2 * bites.EdgeStarts.size(), NoId);
  for (std::size_t slot = 0; slot < mesh.Corners.size(); ++slot)
  {
    const Id constraint = mesh.Constraints[slot];
    if (constraint != NoId)
    {
      const bool isLeft =
        mesh.Corners[slot - slot % 3 + (slot + 1) % 3] == bites.EdgeStarts[constraint];
      faces[2 * static_cast<std::size_t>(constraint) + (isLeft ? 0 : 1)] =
        this->Face(this->Faces[slot / 3]);
    }
  }
  std::vector<Id> numbers(this->Parents.size(), NoId);
  Id next = 0;
  for (const Id face : faces)
  {
    if (face != NoId && numbers[face] == NoId)
    {
      numbers[face] = next++;
    }
  }
  mesh.Regions.reserve(this->Faces.size());
  for (const Id face : this->Faces)
  {
    mesh.Regions.push_back(numbers[this->Face(face)]);
  }
}

} // namespace

JoinedMesh JoinBlocks(
  const Domain& domain, const BlockDomains& blocks, std::vector<BlockMesh> meshes, Pulse& pulse)
{
  return Joiner(domain, blocks, meshes, pulse).Join();
}

} // namespace biting
