// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "WholeNumbers.h"

#include "../Base/TriangleSlots.h"

namespace biting
{

namespace
{

// Goes through rising numbers beside a rising list of some of them.
class Listed
{
public:
  explicit Listed(const std::vector<Id>& list)
    : List(list)
  {
  }

  bool Has(Id number)
  {
    const bool isNext = this->Next < this->List.size() && this->List[this->Next] == number;
    this->Next += isNext ? 1 : 0;
    return isNext;
  }

private:
  const std::vector<Id>& List;
  std::size_t Next = 0;
};

class Numberer
{
public:
  Numberer(
    const std::vector<BlockCollar>& collars, const JoinedMesh& joined, const StripChange& change)
    : Collars(collars)
    , Joined(joined)
    , Change(change)
  {
  }

  WholeNumbers Number()
  {
    this->Result.Blocks.resize(this->Collars.size());
    this->NumberVertices();
    this->NumberTriangles();
    this->AddBlocks();
    return std::move(this->Result);
  }

private:
  void NumberVertices()
  {
    Listed gone(this->Change.GoneVertices);
    this->NumberShared(gone);
    WholeId before = this->Joined.Places[0].Vertex; // in the whole, if none were missing
    for (std::size_t block = 0; block < this->Collars.size(); ++block)
    {
      BlockNumbers& numbers = this->Result.Blocks[block];
      numbers.FirstVertex = before - this->Missing;
      Id vertex = this->Joined.Places[block].Vertex;
      for (const Id own : this->Collars[block].Vertices)
      {
        if (gone.Has(vertex++))
        {
          numbers.GoneVertices.push_back(own);
          ++this->Missing;
          continue;
        }
        this->Result.Vertices.push_back(before + own - this->Missing);
        this->Result.VertexBlocks.push_back(static_cast<Id>(block));
      }
      before += this->Collars[block].NumberOfVertices;
    }
    while (this->Result.Vertices.size() < this->Joined.Bites.Points.size())
    {
      this->Result.Vertices.push_back(before++ - this->Missing);
      this->Result.VertexBlocks.push_back(NoId);
    }
    this->Result.NumberOfVertices = before - this->Missing;
  }

  // The collars have all triangles at shared vertices: a vertex without one is unused.
  void NumberShared(Listed& gone)
  {
    const std::size_t shared = static_cast<std::size_t>(this->Joined.Places[0].Vertex);
    std::vector<std::uint8_t> isUsed(shared, 0);
    for (const Id corner : this->Joined.Triangles.Corners)
    {
      if (static_cast<std::size_t>(corner) < shared)
      {
        isUsed[corner] = 1;
      }
    }
    for (Id vertex = 0; vertex < static_cast<Id>(shared); ++vertex)
    {
      if (gone.Has(vertex))
      {
        ++this->Missing;
        continue;
      }
      const bool isUnused = isUsed[this->Result.Vertices.size()] == 0;
      this->Missing += isUnused ? 1 : 0;
      this->Result.Vertices.push_back(isUnused ? WholeId{ NoId } : vertex - this->Missing);
      this->Result.VertexBlocks.push_back(NoId);
    }
  }

  // Triangles of strips come last.
  void NumberTriangles()
  {
    Listed strip(this->Change.Triangles);
    WholeId before = 0;
    WholeId taken = 0;
    for (std::size_t block = 0; block < this->Collars.size(); ++block)
    {
      BlockNumbers& numbers = this->Result.Blocks[block];
      numbers.FirstTriangle = before - taken;
      Id triangle = this->Joined.Places[block].Triangle;
      for (const Id own : this->Collars[block].Triangles)
      {
        if (strip.Has(triangle++))
        {
          numbers.TakenTriangles.push_back(own);
          ++taken;
          continue;
        }
        this->Result.Triangles.push_back(before + own - taken);
        this->Result.TriangleBlocks.push_back(static_cast<Id>(block));
      }
      before += this->Collars[block].NumberOfTriangles;
    }
    while (this->Result.Triangles.size() < this->Joined.Triangles.Regions.size())
    {
      this->Result.Triangles.push_back(before++ - taken);
      this->Result.TriangleBlocks.push_back(NoId);
    }
  }

  void AddBlocks()
  {
    for (std::size_t block = 0; block < this->Collars.size(); ++block)
    {
      const BlockPlace& place = this->Joined.Places[block];
      const auto regions = this->Joined.FaceRegions.begin();
      this->Result.Blocks[block].FirstOrder = place.Order;
      this->Result.Blocks[block].Regions.assign(
        regions + place.Face, regions + this->Joined.Places[block + 1].Face);
    }
  }

  const std::vector<BlockCollar>& Collars;
  const JoinedMesh& Joined;
  const StripChange& Change;
  WholeId Missing = 0; ///< vertices that are gone or unused, so far
  WholeNumbers Result;
};

Id BlockOfStrip(const Id* corners, const WholeNumbers& numbers)
{
  Id block = NoId;
  for (int corner = 0; corner < 3; ++corner)
  {
    const Id own = numbers.VertexBlocks[corners[corner]];
    block = block == NoId || (own != NoId && own < block) ? own : block;
  }
  return block;
}

// A triangle without a block takes that of a neighbour, breadth first.
void FillFromNeighbors(const Triangulation& mesh, std::vector<Id>& blocks)
{
  std::vector<Id> front;
  for (Id triangle = 0; triangle < mesh.NumberOfTriangles(); ++triangle)
  {
    if (blocks[triangle] != NoId)
    {
      front.push_back(triangle);
    }
  }
  while (!front.empty())
  {
    std::vector<Id> next;
    for (const Id triangle : front)
    {
      const std::size_t first = 3 * static_cast<std::size_t>(triangle);
      for (std::size_t slot = first; slot < first + 3; ++slot)
      {
        const Id across = mesh.Neighbors[slot];
        if (across != NoId && blocks[across] == NoId)
        {
          blocks[across] = blocks[triangle];
          next.push_back(across);
        }
      }
    }
    front.swap(next);
  }
}

// Vertices of triangles that have a marked corner become marked.
void MarkRing(const Triangulation& mesh, std::vector<std::uint8_t>& isMarked)
{
  std::vector<std::uint8_t> marks = isMarked;
  for (std::size_t slot = 0; slot < mesh.Corners.size(); slot += 3)
  {
    const Id* own = mesh.Corners.data() + slot;
    if (isMarked[own[0]] != 0 || isMarked[own[1]] != 0 || isMarked[own[2]] != 0)
    {
      marks[own[0]] = marks[own[1]] = marks[own[2]] = 1;
    }
  }
  isMarked.swap(marks);
}

} // namespace

WholeNumbers NumberWhole(
  const std::vector<BlockCollar>& collars, const JoinedMesh& joined, const StripChange& change)
{
  return Numberer(collars, joined, change).Number();
}

std::vector<Id> OwnersOfTriangles(
  const Triangulation& mesh, const WholeNumbers& numbers, const std::vector<Id>& holders)
{
  std::vector<Id> blocks = numbers.TriangleBlocks;
  for (std::size_t triangle = 0; triangle < blocks.size(); ++triangle)
  {
    blocks[triangle] = blocks[triangle] != NoId
      ? blocks[triangle]
      : BlockOfStrip(mesh.Corners.data() + 3 * triangle, numbers);
  }
  FillFromNeighbors(mesh, blocks);
  for (Id& block : blocks)
  {
    block = block == NoId ? 0 : holders[block];
  }
  return blocks;
}

bool HasRingsAround(
  const Triangulation& mesh, const std::vector<Id>& owners, std::size_t numberOfVertices, int rings)
{
  std::vector<Id> ownersOf(numberOfVertices, NoId);
  std::vector<std::uint8_t> isMarked(numberOfVertices, 0);
  for (std::size_t slot = 0; slot < mesh.Corners.size(); ++slot)
  {
    Id& owner = ownersOf[mesh.Corners[slot]];
    owner = owner == NoId ? owners[slot / 3] : owner;
    isMarked[mesh.Corners[slot]] |= owner != owners[slot / 3] ? 1 : 0;
  }
  for (int ring = 0; ring < rings; ++ring)
  {
    MarkRing(mesh, isMarked);
  }
  bool areThere = true;
  for (std::size_t slot = 0; slot < mesh.Corners.size(); ++slot)
  {
    const bool isOpen = mesh.Neighbors[slot] == NoId && mesh.Constraints[slot] == NoId;
    areThere = areThere &&
      !(isOpen &&
        (isMarked[mesh.Corners[NextSlotOf(slot)]] != 0 ||
          isMarked[mesh.Corners[PreviousSlotOf(slot)]] != 0));
  }
  return areThere;
}

} // namespace biting
