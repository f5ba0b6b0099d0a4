// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "BlockCollar.h"

#include <algorithm> // for max_element

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

  BlockCollar Take();

private:
  void FindTriangles();
  void AddRing(std::vector<Id>& front);
  bool IsShared(Id vertex) const { return static_cast<std::size_t>(vertex) < this->NumberOfShared; }
  bool IsAtCut(Id vertex) const
  {
    return this->IsShared(vertex) && this->IsOnCut[this->Block.Vertices[vertex]] != 0;
  }
  void NumberVertices();
  void CopyVertices();
  void CopyEdges();
  void CopyTriangles();

  const BlockDomain& Block;
  const std::vector<std::uint8_t>& IsOnCut;
  const BlockMesh& Whole;
  int Steps;
  std::size_t NumberOfShared;
  std::vector<Id> Numbers;         ///< of the vertices in the collar, or NoId
  std::vector<Id> TriangleNumbers; ///< 0 or in the collar, or NoId
  BlockCollar Collar;
};

BlockCollar CollarTaker::Take()
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

void CollarTaker::FindTriangles()
{
  const std::vector<Id>& corners = this->Whole.Triangles.Corners;
  this->TriangleNumbers.assign(corners.size() / 3, NoId);
  std::vector<Id> front;
  for (std::size_t slot = 0; slot < corners.size(); ++slot)
  {
    Id& number = this->TriangleNumbers[slot / 3];
    if (number == NoId && this->IsAtCut(corners[slot]))
    {
      number = 0;
      front.push_back(static_cast<Id>(slot / 3));
    }
  }
  for (int step = 0; step < this->Steps; ++step)
  {
    this->AddRing(front);
  }
  for (std::size_t slot = 0; slot < corners.size(); ++slot)
  {
    const Id vertex = corners[slot];
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

void CollarTaker::AddRing(std::vector<Id>& front)
{
  std::vector<Id> next;
  for (const Id triangle : front)
  {
    for (std::size_t slot = 3 * static_cast<std::size_t>(triangle);
         slot < 3 * static_cast<std::size_t>(triangle) + 3; ++slot)
    {
      const Id across = this->Whole.Triangles.Neighbors[slot];
      if (across != NoId && this->TriangleNumbers[across] == NoId)
      {
        this->TriangleNumbers[across] = 0;
        next.push_back(across);
      }
    }
  }
  front.swap(next);
}

// In their order: those that the block shares, all of them, then those that are used.
void CollarTaker::NumberVertices()
{
  for (const Id triangle : this->Collar.Triangles)
  {
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      this
        ->Numbers[this->Whole.Triangles.Corners[3 * static_cast<std::size_t>(triangle) + corner]] =
        0;
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

void CollarTaker::CopyVertices()
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

void CollarTaker::CopyEdges()
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

void CollarTaker::CopyTriangles()
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

} // namespace biting
