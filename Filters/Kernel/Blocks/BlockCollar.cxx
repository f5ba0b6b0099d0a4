// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "BlockCollar.h"

#include "../Base/Pulse.h"
#include "ByteStream.h"
#include "StripParts.h"

#include <algorithm> // for max_element
#include <cstdint>   // for digests
#include <cstring>   // for copies of bytes
#include <tuple>     // for lists of arrays
#include <utility>   // for move

namespace biting
{

namespace
{

class CollarTaker
{
public:
  CollarTaker(const BlockDomain& block, const std::vector<std::uint8_t>& isOnCut,
    const BlockMesh& mesh, int steps)
    : Block(block)
    , IsOnCut(isOnCut)
    , Whole(mesh)
    , Steps(steps)
    , NumberOfShared(block.Vertices.size())
    , Numbers(mesh.Bites.Points.size(), NoId)
  {
  }

  BlockCollar Take()
  {
    this->FindTriangles();
    this->NumberVertices();
    this->CopyVertices();
    this->CopyEdges();
    this->CopyTriangles();
    this->Collar.NumberOfVertices =
      static_cast<Id>(this->Whole.Bites.Points.size() - this->NumberOfShared);
    this->Collar.NumberOfTriangles = this->Whole.Triangles.NumberOfTriangles();
    const std::vector<Id>& orders = this->Whole.Bites.BiteOrders;
    this->Collar.Mesh.NumberOfOrders =
      orders.empty() ? 0 : 1 + *std::max_element(orders.begin(), orders.end());
    this->Collar.Mesh.Bitten = this->Whole.Bitten;
    return std::move(this->Collar);
  }

private:
  void FindTriangles()
  {
    const Triangulation& mesh = this->Whole.Triangles;
    std::vector<Id> atCuts;
    for (Id vertex = 0; vertex < static_cast<Id>(this->NumberOfShared); ++vertex)
    {
      if (this->IsOnCut[this->Block.Vertices[vertex]] != 0)
      {
        atCuts.push_back(vertex);
      }
    }
    Pulse pulse(NoMonitor());
    this->TriangleNumbers.assign(mesh.Regions.size(), NoId);
    for (const Id triangle :
      TrianglesAround(mesh, this->Numbers.size(), atCuts, pulse, this->Steps))
    {
      this->TriangleNumbers[triangle] = 0;
    }
    for (std::size_t slot = 0; slot < mesh.Corners.size(); ++slot)
    {
      const Id vertex = mesh.Corners[slot];
      if (this->IsShared(vertex) || this->Whole.Bites.Segments[vertex] != NoId)
      {
        this->TriangleNumbers[slot / 3] = 0;
      }
    }
    for (std::size_t triangle = 0; triangle < this->TriangleNumbers.size(); ++triangle)
    {
      if (this->TriangleNumbers[triangle] != NoId)
      {
        this->TriangleNumbers[triangle] = static_cast<Id>(this->Collar.Triangles.size());
        this->Collar.Triangles.push_back(static_cast<Id>(triangle));
      }
    }
  }

  bool IsShared(Id vertex) const { return static_cast<std::size_t>(vertex) < this->NumberOfShared; }

  // In their order: those that the block shares, all of them, then those that are used.
  void NumberVertices()
  {
    for (const Id triangle : this->Collar.Triangles)
    {
      for (std::size_t corner = 0; corner < 3; ++corner)
      {
        this->Numbers[this->Whole.Triangles
                        .Corners[3 * static_cast<std::size_t>(triangle) + corner]] = 0;
      }
    }
    Id next = 0;
    for (std::size_t vertex = 0; vertex < this->Numbers.size(); ++vertex)
    {
      if (vertex < this->NumberOfShared)
      {
        this->Numbers[vertex] = next++;
      }
      else if (this->Numbers[vertex] != NoId)
      {
        this->Numbers[vertex] = next++;
        this->Collar.Vertices.push_back(static_cast<Id>(vertex - this->NumberOfShared));
      }
    }
  }

  void CopyVertices()
  {
    const BitingResult& from = this->Whole.Bites;
    BitingResult& to = this->Collar.Mesh.Bites;
    for (std::size_t vertex = 0; vertex < this->Numbers.size(); ++vertex)
    {
      if (this->Numbers[vertex] != NoId)
      {
        to.Points.push_back(from.Points[vertex]);
        to.Spacings.push_back(from.Spacings[vertex]);
        to.BiteOrders.push_back(from.BiteOrders[vertex]);
        to.Segments.push_back(from.Segments[vertex]);
      }
    }
  }

  void CopyEdges()
  {
    const BitingResult& from = this->Whole.Bites;
    BitingResult& to = this->Collar.Mesh.Bites;
    to.EdgeSegments = from.EdgeSegments;
    for (std::size_t edge = 0; edge < from.EdgeSegments.size(); ++edge)
    {
      to.EdgeStarts.push_back(this->Numbers[from.EdgeStarts[edge]]);
      to.EdgeEnds.push_back(this->Numbers[from.EdgeEnds[edge]]);
    }
  }

  void CopyTriangles()
  {
    const Triangulation& from = this->Whole.Triangles;
    Triangulation& to = this->Collar.Mesh.Triangles;
    for (const Id triangle : this->Collar.Triangles)
    {
      for (std::size_t slot = 3 * static_cast<std::size_t>(triangle);
           slot < 3 * static_cast<std::size_t>(triangle) + 3; ++slot)
      {
        const Id across = from.Neighbors[slot];
        to.Corners.push_back(this->Numbers[from.Corners[slot]]);
        to.Neighbors.push_back(across == NoId ? NoId : this->TriangleNumbers[across]);
        to.Constraints.push_back(from.Constraints[slot]);
      }
      to.Regions.push_back(from.Regions[triangle]);
    }
  }

  const BlockDomain& Block;
  const std::vector<std::uint8_t>& IsOnCut;
  const BlockMesh& Whole;
  int Steps;
  std::size_t NumberOfShared;
  std::vector<Id> Numbers;         ///< of the vertices in the collar, or NoId
  std::vector<Id> TriangleNumbers; ///< 0 or in the collar, or NoId
  BlockCollar Collar;
};

// All of it, which may be constant.
template <typename Collar>
auto MembersOf(Collar& collar)
{
  auto& bites = collar.Mesh.Bites;
  auto& triangles = collar.Mesh.Triangles;
  return std::tie(collar.Mesh.Bitten, collar.Mesh.NumberOfOrders, collar.NumberOfVertices,
    collar.NumberOfTriangles, collar.Vertices, collar.Triangles, bites.Points, bites.Spacings,
    bites.BiteOrders, bites.Segments, bites.EdgeStarts, bites.EdgeEnds, bites.EdgeSegments,
    triangles.Corners, triangles.Neighbors, triangles.Constraints, triangles.Regions);
}

// FNV-1a, eight bytes at a time: equal only for equal cuts, but by an accident that nobody lives to
// see.
class Digest
{
public:
  template <typename Value>
  void Add(const Value& value)
  {
    static_assert(sizeof(value) <= sizeof(std::uint64_t), "fits");
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof(value));
    this->Sum = (this->Sum ^ bits) * 1099511628211u;
  }

  std::uint64_t Sum = 14695981039346656037u;
};

// Of what all processes must have in common.
std::uint64_t DigestOf(const BlockDomains& blocks)
{
  Digest digest;
  for (const Point2& vertex : blocks.Graph.Vertices)
  {
    digest.Add(vertex.X);
    digest.Add(vertex.Y);
  }
  for (const CutGraph::Piece& piece : blocks.Graph.Pieces)
  {
    digest.Add(piece.Start);
    digest.Add(piece.End);
    digest.Add(piece.Segment);
  }
  for (const BlockDomain& block : blocks.Blocks)
  {
    digest.Add(block.Vertices.size());
    digest.Add(block.Pieces.size());
    digest.Add(block.ExpectedVertices);
  }
  return digest.Sum;
}

} // namespace

std::vector<std::uint8_t> VerticesOnCuts(const CutGraph& graph)
{
  std::vector<std::uint8_t> isOnCut(graph.Vertices.size(), 0);
  for (Id piece = 0; piece < graph.NumberOfPieces(); ++piece)
  {
    if (graph.IsCut(piece))
    {
      isOnCut[graph.Pieces[piece].Start] = 1;
      isOnCut[graph.Pieces[piece].End] = 1;
    }
  }
  return isOnCut;
}

BlockCollar TakeCollar(const BlockDomain& block, const std::vector<std::uint8_t>& isOnCut,
  const BlockMesh& mesh, int steps)
{
  return CollarTaker(block, isOnCut, mesh, steps).Take();
}

std::vector<char> PackCollars(const BlockDomains& blocks, const std::vector<std::size_t>& numbers,
  const std::vector<BlockCollar>& collars)
{
  ByteWriter writer;
  writer.Put(DigestOf(blocks));
  for (const std::size_t block : numbers)
  {
    std::apply(
      [&writer](const auto&... members) { (writer.Put(members), ...); }, MembersOf(collars[block]));
  }
  return std::move(writer.Bytes);
}

bool UnpackCollars(const std::vector<char>& bytes, const BlockDomains& blocks,
  const std::vector<std::size_t>& numbers, std::vector<BlockCollar>& collars)
{
  ByteReader reader(bytes);
  std::uint64_t digest = 0;
  reader.Take(digest);
  if (digest != DigestOf(blocks))
  {
    return false;
  }
  std::vector<BlockCollar> made(numbers.size());
  for (BlockCollar& collar : made)
  {
    std::apply([&reader](auto&... members) { (reader.Take(members), ...); }, MembersOf(collar));
  }
  for (std::size_t k = 0; k < made.size() && reader.IsAtEnd(); ++k)
  {
    collars[numbers[k]] = std::move(made[k]);
  }
  return reader.IsAtEnd();
}

} // namespace biting
