// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SpreadMesh.h"

#include "../Base/Pulse.h"
#include "../Stages/StageProblems.h"
#include "CrewRounds.h"
#include "PieceDealer.h"
#include "PieceMeasures.h"
#include "PieceUnion.h"

#include <utility> // for move

namespace biting
{

namespace
{

// Where steps end, as shares of the time.
constexpr double DealingEnd = 0.1;
constexpr double UnitingEnd = 0.2;

constexpr int RingsBeyond = 2; // of triangles, beyond the ghost levels, for what is measured

// Of the vertices that are left, and of the triangles.
void NumberCollars(const WholeNumbers& numbers, BitingMesh& collars)
{
  collars.Piece.TriangleIds = numbers.Triangles;
  for (const WholeId number : numbers.Vertices)
  {
    if (number != NoId)
    {
      collars.Piece.PointIds.push_back(number);
    }
  }
}

std::vector<std::size_t> OwnBlocks(const KeptBlocks& kept)
{
  std::vector<std::size_t> blocks;
  for (std::size_t block = 0; block < kept.Meshes.size(); ++block)
  {
    if (!kept.Meshes[block].Triangles.Corners.empty())
    {
      blocks.push_back(block);
    }
  }
  return blocks;
}

CollarPart PartOf(Id member, const KeptBlocks& kept, PieceDealer& dealer)
{
  CollarPart part = dealer.Make(member);
  for (std::size_t block = 0; block < kept.Holders.size(); ++block)
  {
    if (kept.Holders[block] == member)
    {
      part.Blocks.push_back(kept.Numbers.Blocks[block]);
    }
  }
  return part;
}

// The vertices of the edges, in their order.
std::shared_ptr<const BitingMesh> BorderOf(BitingMesh& collars)
{
  auto border = std::make_shared<BitingMesh>();
  std::vector<Id> numbers(collars.Points.size(), NoId);
  for (const std::vector<Id>* ends : { &collars.EdgeStarts, &collars.EdgeEnds })
  {
    for (const Id vertex : *ends)
    {
      numbers[vertex] = 0;
    }
  }
  for (std::size_t vertex = 0; vertex < numbers.size(); ++vertex)
  {
    if (numbers[vertex] != NoId)
    {
      numbers[vertex] = static_cast<Id>(border->Points.size());
      border->Points.push_back(collars.Points[vertex]);
      border->OriginalPoints.push_back(collars.OriginalPoints[vertex]);
      border->Piece.PointIds.push_back(collars.Piece.PointIds[vertex]);
    }
  }
  for (std::vector<Id>* ends : { &collars.EdgeStarts, &collars.EdgeEnds })
  {
    for (Id& vertex : *ends)
    {
      vertex = numbers[vertex];
    }
  }
  border->EdgeStarts = std::move(collars.EdgeStarts);
  border->EdgeEnds = std::move(collars.EdgeEnds);
  border->EdgeCells = std::move(collars.EdgeCells);
  border->EdgeIsBoundary = std::move(collars.EdgeIsBoundary);
  border->Piece.IsPart = true;
  return border;
}

// From the part of the collars on, as all members do.
BitingMesh MakePiece(const SpreadInput& input, CollarPart own, CrewRounds& rounds,
  ExactSum& density, ProblemList& problems, PartOfStage& part)
{
  const bool countsAsked = own.CountsAsked;
  const int levels = own.GhostLevels;
  PartOfStage uniting(part, DealingEnd, UnitingEnd);
  Pulse pulse(uniting);
  UnitedPiece piece = UnitePiece(input.Kept, OwnBlocks(input.Kept), std::move(own), pulse);
  if (!piece.IsSound)
  {
    // The check finds a boundary without a constraint.
    piece.Constraints.assign(piece.Constraints.size(), NoId);
  }
  PartOfStage measuring(part, UnitingEnd, 1.0);
  const bool isWell = MeasurePieces({ input.Geometry, input.F, piece.Constraints, countsAsked },
    rounds, piece.Mesh, density, problems, measuring);
  if (!isWell || measuring.HasStopped())
  {
    return {};
  }
  TrimPiece(levels, piece.Mesh);
  return std::move(piece.Mesh);
}

} // namespace

BitingMesh ShareMesh(const SpreadInput& input, BitingMesh collars,
  const std::vector<Id>& constraints, bool countsAsked, ExactSum& density, ProblemList& problems,
  PartOfStage& part)
{
  KeptBlocks& kept = input.Kept;
  NumberCollars(kept.Numbers, collars);
  CrewRounds rounds(input.Members, kept.AreHolding);
  CollarPart own;
  {
    const DealtMesh dealt{ collars, constraints, kept.Owners,
      static_cast<Id>(kept.AreHolding.size()) };
    PieceDealer dealer(dealt, input.GhostLevels + RingsBeyond);
    const auto partOf = [&input, &kept, &dealer, countsAsked](Id member)
    {
      CollarPart made = PartOf(member, kept, dealer);
      made.GhostLevels = input.GhostLevels;
      made.CountsAsked = countsAsked;
      return made;
    };
    for (std::size_t member = 1; member < kept.AreHolding.size(); ++member)
    {
      if (kept.AreHolding[member])
      {
        input.Members.Reply(static_cast<int>(member), PackPart(partOf(static_cast<Id>(member))));
      }
    }
    own = partOf(0);
  }
  const std::shared_ptr<const BitingMesh> border = BorderOf(collars);
  collars = BitingMesh();
  BitingMesh mesh = MakePiece(input, std::move(own), rounds, density, problems, part);
  if (mesh.Piece.IsPart)
  {
    mesh.Border = border;
  }
  return mesh;
}

BitingMesh TakePiece(const SpreadInput& input, ProblemList& problems, PartOfStage& part)
{
  CollarPart own;
  if (!UnpackPart(input.Members.Await(), own))
  {
    return {};
  }
  CrewRounds rounds(input.Members, {});
  ExactSum density;
  return MakePiece(input, std::move(own), rounds, density, problems, part);
}

} // namespace biting
