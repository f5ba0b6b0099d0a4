// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "PieceUnion.h"

#include "../Base/TriangleSlots.h"

#include <algorithm> // for min, max, sort
#include <tuple>     // for comparing
#include <utility>   // for move

namespace biting
{

namespace
{

// The core of a block, as numbers in the block.
struct Core
{
  std::vector<Id> Vertices;         ///< that its triangles use
  std::vector<WholeId> VertexIds;   ///< of these
  std::vector<Id> Triangles;        ///< rising
  std::vector<WholeId> TriangleIds; ///< of these
  std::vector<Id> VertexNumbers;    ///< of the block's vertices in the piece
  std::vector<Id> TriangleNumbers;  ///< of the block's triangles in the piece, NoId in the collar
};

// An edge with nothing across it so far.
struct OpenEdge
{
  Id Low;
  Id High;
  std::size_t Slot;

  bool operator<(const OpenEdge& other) const
  {
    return std::tie(this->Low, this->High, this->Slot) <
      std::tie(other.Low, other.High, other.Slot);
  }
};

// Numbers of the things in `own` and of those that one part has, where both rise in the whole: the
// part's take their place among the others, and a thing that is in both has one number.
class Merging
{
public:
  explicit Merging(const std::vector<WholeId>& part)
    : Part(part)
    , PartNumbers(part.size(), NoId)
  {
  }

  // The number of the next of the own.
  Id Add(WholeId own)
  {
    this->PassBefore(own);
    if (this->Next < this->Part.size() && this->Part[this->Next] == own)
    {
      return this->PartNumbers[this->Next++] = this->Count++;
    }
    return this->Count++;
  }

  Id End()
  {
    while (this->Next < this->Part.size())
    {
      this->PartNumbers[this->Next++] = this->Count++;
    }
    return this->Count;
  }

  const std::vector<Id>& NumbersOfPart() const { return this->PartNumbers; }

private:
  void PassBefore(WholeId own)
  {
    while (this->Next < this->Part.size() && this->Part[this->Next] < own)
    {
      this->PartNumbers[this->Next++] = this->Count++;
    }
  }

  const std::vector<WholeId>& Part;
  std::vector<Id> PartNumbers;
  std::size_t Next = 0;
  Id Count = 0;
};

class Uniter
{
public:
  Uniter(KeptBlocks& kept, const std::vector<std::size_t>& numbers, CollarPart& part, Pulse& pulse)
    : Kept(kept)
    , Blocks(numbers)
    , Part(part)
    , Beats(pulse)
    , Cores(numbers.size())
  {
  }

  UnitedPiece Unite()
  {
    for (std::size_t k = 0; k < this->Blocks.size() && this->Beats.Ask(); ++k)
    {
      this->FindCore(k);
      this->NumberVertices(k);
    }
    this->Number();
    this->CopyPart();
    for (std::size_t k = 0; k < this->Blocks.size() && this->Beats.Ask(); ++k)
    {
      this->CopyCore(k);
      this->Kept.Meshes[this->Blocks[k]] = BlockMesh();
      this->Kept.Collars[this->Blocks[k]] = BlockCollar();
      this->Cores[k] = Core();
    }
    this->CloseEdges();
    return std::move(this->Result);
  }

private:
  void FindCore(std::size_t k)
  {
    const Triangulation& mesh = this->Kept.Meshes[this->Blocks[k]].Triangles;
    const std::vector<Id>& collar = this->Kept.Collars[this->Blocks[k]].Triangles;
    const BlockNumbers& numbers = this->Part.Blocks[k];
    Core& core = this->Cores[k];
    core.TriangleNumbers.assign(mesh.Regions.size(), 0);
    for (const Id triangle : collar)
    {
      core.TriangleNumbers[triangle] = NoId;
    }
    WholeId taken = 0;
    for (Id triangle = 0; triangle < mesh.NumberOfTriangles() && this->Beats.Beat(); ++triangle)
    {
      if (static_cast<std::size_t>(taken) < numbers.TakenTriangles.size() &&
        numbers.TakenTriangles[taken] == triangle)
      {
        ++taken;
      }
      else if (core.TriangleNumbers[triangle] != NoId)
      {
        core.Triangles.push_back(triangle);
        core.TriangleIds.push_back(numbers.FirstTriangle + triangle - taken);
      }
    }
  }

  // No vertex of a core triangle is shared with another block.
  void NumberVertices(std::size_t k)
  {
    const BlockMesh& mesh = this->Kept.Meshes[this->Blocks[k]];
    const std::size_t shared = this->Kept.Parts.Blocks[this->Blocks[k]].Vertices.size();
    const BlockNumbers& numbers = this->Part.Blocks[k];
    Core& core = this->Cores[k];
    core.VertexNumbers.assign(mesh.Bites.Points.size(), NoId);
    for (const Id triangle : core.Triangles)
    {
      for (std::size_t corner = 0; corner < 3; ++corner)
      {
        core
          .VertexNumbers[mesh.Triangles.Corners[3 * static_cast<std::size_t>(triangle) + corner]] =
          0;
      }
    }
    std::size_t gone = 0;
    for (std::size_t vertex = shared; vertex < core.VertexNumbers.size() && this->Beats.Beat();
         ++vertex)
    {
      const Id own = static_cast<Id>(vertex - shared);
      if (gone < numbers.GoneVertices.size() && numbers.GoneVertices[gone] == own)
      {
        ++gone;
      }
      else if (core.VertexNumbers[vertex] != NoId)
      {
        core.Vertices.push_back(static_cast<Id>(vertex));
        core.VertexIds.push_back(numbers.FirstVertex + own - static_cast<WholeId>(gone));
      }
    }
  }

  void Number()
  {
    Merging vertices(this->Part.Mesh.Piece.PointIds);
    Merging triangles(this->Part.Mesh.Piece.TriangleIds);
    for (Core& core : this->Cores)
    {
      for (std::size_t i = 0; i < core.Vertices.size() && this->Beats.Beat(); ++i)
      {
        core.VertexNumbers[core.Vertices[i]] = vertices.Add(core.VertexIds[i]);
      }
      for (std::size_t i = 0; i < core.Triangles.size() && this->Beats.Beat(); ++i)
      {
        core.TriangleNumbers[core.Triangles[i]] = triangles.Add(core.TriangleIds[i]);
      }
    }
    this->MakeRoom(vertices.End(), triangles.End());
    this->PartVertices = vertices.NumbersOfPart();
    this->PartTriangles = triangles.NumbersOfPart();
  }

  void MakeRoom(Id vertices, Id triangles)
  {
    const std::size_t points = static_cast<std::size_t>(vertices);
    const std::size_t cells = static_cast<std::size_t>(triangles);
    BitingMesh& mesh = this->Result.Mesh;
    mesh.Points.resize(points);
    mesh.Spacing.resize(points);
    mesh.BiteOrders.resize(points, NoId);
    mesh.Kinds.resize(points, VertexKind::Interior);
    mesh.OriginalPoints.resize(points, NoId);
    mesh.Corners.resize(3 * cells);
    mesh.Neighbors.resize(3 * cells, NoId);
    mesh.Regions.resize(cells);
    this->Result.Constraints.resize(3 * cells, NoId);
    mesh.Piece.IsPart = true;
    mesh.Piece.PointIds.resize(points);
    mesh.Piece.ForeignPoints.resize(points, 0);
    mesh.Piece.TriangleIds.resize(cells);
    mesh.Piece.Levels.resize(cells, 0);
  }

  void CopyPart()
  {
    const BitingMesh& from = this->Part.Mesh;
    BitingMesh& to = this->Result.Mesh;
    for (std::size_t k = 0; k < this->PartVertices.size() && this->Beats.Beat(); ++k)
    {
      const Id vertex = this->PartVertices[k];
      to.Points[vertex] = from.Points[k];
      to.Spacing[vertex] = from.Spacing[k];
      to.BiteOrders[vertex] = from.BiteOrders[k];
      to.Kinds[vertex] = from.Kinds[k];
      to.OriginalPoints[vertex] = from.OriginalPoints[k];
      to.Piece.PointIds[vertex] = from.Piece.PointIds[k];
      to.Piece.ForeignPoints[vertex] = from.Piece.ForeignPoints[k];
    }
    for (std::size_t slot = 0; slot < from.Corners.size() && this->Beats.Beat(); ++slot)
    {
      const Id triangle = this->PartTriangles[slot / 3];
      const std::size_t own = 3 * static_cast<std::size_t>(triangle) + slot % 3;
      const Id across = from.Neighbors[slot];
      to.Corners[own] = this->PartVertices[from.Corners[slot]];
      to.Neighbors[own] = across == NoId ? NoId : this->PartTriangles[across];
      to.Regions[triangle] = from.Regions[slot / 3];
      to.Piece.TriangleIds[triangle] = from.Piece.TriangleIds[slot / 3];
      to.Piece.Levels[triangle] = from.Piece.Levels[slot / 3];
      this->Result.Constraints[own] = this->Part.Constraints[slot];
    }
    for (std::size_t slot = 0; slot < from.Corners.size() && this->Beats.Beat(); ++slot)
    {
      if (from.Neighbors[slot] == NoId && this->Part.Constraints[slot] == NoId)
      {
        const std::size_t first = 3 * static_cast<std::size_t>(this->PartTriangles[slot / 3]);
        this->Open.push_back(this->EdgeAt(first + slot % 3));
      }
    }
  }

  // Vertices at the collar are of the part already.
  void CopyCore(std::size_t k)
  {
    const BitingResult& from = this->Kept.Meshes[this->Blocks[k]].Bites;
    const Core& core = this->Cores[k];
    BitingMesh& to = this->Result.Mesh;
    for (std::size_t i = 0; i < core.Vertices.size() && this->Beats.Beat(); ++i)
    {
      const Id vertex = core.Vertices[i];
      const Id number = core.VertexNumbers[vertex];
      const Id order = from.BiteOrders[vertex];
      to.Points[number] = from.Points[vertex];
      to.Spacing[number] = from.Spacings[vertex];
      to.BiteOrders[number] = order == NoId ? NoId : this->Part.Blocks[k].FirstOrder + order;
      to.Piece.PointIds[number] = core.VertexIds[i];
    }
    for (std::size_t i = 0; i < core.Triangles.size() && this->Beats.Beat(); ++i)
    {
      const Id triangle = core.Triangles[i];
      to.Piece.TriangleIds[core.TriangleNumbers[triangle]] = core.TriangleIds[i];
      this->CopyTriangle(k, triangle);
    }
  }

  void CopyTriangle(std::size_t k, Id triangle)
  {
    const Triangulation& from = this->Kept.Meshes[this->Blocks[k]].Triangles;
    const Core& core = this->Cores[k];
    BitingMesh& to = this->Result.Mesh;
    const Id number = core.TriangleNumbers[triangle];
    to.Regions[number] = this->Part.Blocks[k].Regions[from.Regions[triangle]];
    const std::size_t first = 3 * static_cast<std::size_t>(triangle);
    const std::size_t own = 3 * static_cast<std::size_t>(number);
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      const Id across = from.Neighbors[first + corner];
      to.Corners[own + corner] = core.VertexNumbers[from.Corners[first + corner]];
      to.Neighbors[own + corner] = across == NoId ? NoId : core.TriangleNumbers[across];
    }
    for (std::size_t slot = own; slot < own + 3; ++slot)
    {
      if (to.Neighbors[slot] == NoId)
      {
        this->Open.push_back(this->EdgeAt(slot));
      }
    }
  }

  // Two that are the same belong together; one alone is where the part ends, and not of a core.
  void CloseEdges()
  {
    constexpr Id EndOfPart = 0; // as a constraint
    std::sort(this->Open.begin(), this->Open.end());
    std::vector<Id>& neighbors = this->Result.Mesh.Neighbors;
    std::vector<std::uint8_t> isOfPart(this->Result.Mesh.Regions.size(), 0);
    for (const Id triangle : this->PartTriangles)
    {
      isOfPart[triangle] = 1;
    }
    for (std::size_t k = 0; k < this->Open.size(); ++k)
    {
      const OpenEdge& edge = this->Open[k];
      const OpenEdge* next = k + 1 < this->Open.size() ? &this->Open[k + 1] : nullptr;
      if (next && next->Low == edge.Low && next->High == edge.High)
      {
        neighbors[edge.Slot] = static_cast<Id>(next->Slot / 3);
        neighbors[next->Slot] = static_cast<Id>(edge.Slot / 3);
        ++k;
        continue;
      }
      this->Result.IsSound = this->Result.IsSound && isOfPart[edge.Slot / 3] != 0;
      this->Result.Constraints[edge.Slot] = EndOfPart;
    }
  }

  OpenEdge EdgeAt(std::size_t slot) const
  {
    const Id start = this->Result.Mesh.Corners[NextSlotOf(slot)];
    const Id end = this->Result.Mesh.Corners[PreviousSlotOf(slot)];
    return { std::min(start, end), std::max(start, end), slot };
  }

  KeptBlocks& Kept;
  const std::vector<std::size_t>& Blocks;
  CollarPart& Part;
  Pulse& Beats;
  std::vector<Core> Cores;
  std::vector<Id> PartVertices;  ///< numbers in the piece
  std::vector<Id> PartTriangles; ///< numbers in the piece
  std::vector<OpenEdge> Open;
  UnitedPiece Result;
};

template <typename Value>
void Keep(const std::vector<Id>& kept, std::size_t size, std::vector<Value>& values)
{
  for (std::size_t k = 0; k < kept.size(); ++k)
  {
    for (std::size_t i = 0; i < size; ++i)
    {
      values[size * k + i] = values[size * static_cast<std::size_t>(kept[k]) + i];
    }
  }
  values.resize(size * kept.size());
}

void KeepTriangles(const std::vector<Id>& kept, BitingMesh& mesh)
{
  Keep(kept, 3, mesh.Corners);
  mesh.Neighbors = std::vector<Id>();
  Keep(kept, 1, mesh.Regions);
  Keep(kept, 1, mesh.Piece.TriangleIds);
  Keep(kept, 1, mesh.Piece.Levels);
  Keep(kept, 1, mesh.Quality.MinimumAngle);
  Keep(kept, 1, mesh.Quality.RadiusEdgeRatio);
  Keep(kept, 1, mesh.Quality.AspectRatio);
}

void KeepVertices(const std::vector<Id>& kept, BitingMesh& mesh)
{
  Keep(kept, 1, mesh.Points);
  Keep(kept, 1, mesh.Spacing);
  Keep(kept, 1, mesh.BiteOrders);
  Keep(kept, 1, mesh.Kinds);
  Keep(kept, 1, mesh.OriginalPoints);
  Keep(kept, 1, mesh.Piece.PointIds);
  Keep(kept, 1, mesh.Piece.ForeignPoints);
  Keep(kept, 1, mesh.Quality.NearestNeighborDistance);
  Keep(kept, 1, mesh.Quality.Conformity);
}

} // namespace

UnitedPiece UnitePiece(
  KeptBlocks& kept, const std::vector<std::size_t>& numbers, CollarPart part, Pulse& pulse)
{
  return Uniter(kept, numbers, part, pulse).Unite();
}

void TrimPiece(int ghostLevels, BitingMesh& mesh)
{
  std::vector<Id> triangles;
  std::vector<Id> numbers(mesh.Points.size(), NoId);
  for (std::size_t triangle = 0; triangle < mesh.Regions.size(); ++triangle)
  {
    if (mesh.Piece.Levels[triangle] <= ghostLevels)
    {
      triangles.push_back(static_cast<Id>(triangle));
      for (std::size_t slot = 3 * triangle; slot < 3 * triangle + 3; ++slot)
      {
        numbers[mesh.Corners[slot]] = 0;
      }
    }
  }
  std::vector<Id> vertices;
  for (std::size_t vertex = 0; vertex < numbers.size(); ++vertex)
  {
    if (numbers[vertex] != NoId)
    {
      numbers[vertex] = static_cast<Id>(vertices.size());
      vertices.push_back(static_cast<Id>(vertex));
    }
  }
  KeepTriangles(triangles, mesh);
  for (Id& corner : mesh.Corners)
  {
    corner = numbers[corner];
  }
  KeepVertices(vertices, mesh);
}

} // namespace biting
