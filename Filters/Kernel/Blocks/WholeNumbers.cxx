// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "WholeNumbers.h"

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

  WholeNumbers Number();

private:
  void NumberVertices();
  void NumberShared(Listed& gone);
  void NumberTriangles();
  void AddBlocks();

  const std::vector<BlockCollar>& Collars;
  const JoinedMesh& Joined;
  const StripChange& Change;
  WholeId Missing = 0; ///< vertices that are gone or unused, so far
  WholeNumbers Result;
};

WholeNumbers Numberer::Number()
{
  this->Result.Blocks.resize(this->Collars.size());
  this->NumberVertices();
  this->NumberTriangles();
  this->AddBlocks();
  return std::move(this->Result);
}

void Numberer::NumberVertices()
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

// All triangles at them are at hand.
void Numberer::NumberShared(Listed& gone)
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

// Those of strips come last.
void Numberer::NumberTriangles()
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

void Numberer::AddBlocks()
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

} // namespace

WholeNumbers NumberWhole(
  const std::vector<BlockCollar>& collars, const JoinedMesh& joined, const StripChange& change)
{
  return Numberer(collars, joined, change).Number();
}

} // namespace biting
