// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "FinishedMesh.h"

#include "../Base/Pulse.h"
#include "../Quality/MeshCheck.h"
#include "../Stages/FineDrawing.h"
#include "../Stages/MeshAssembly.h"
#include "../Stages/SegmentCover.h"
#include "../Stages/SharpSectors.h"
#include "../Stages/StageProblems.h"
#include "CrewRounds.h"
#include "PieceDealer.h"
#include "PieceMeasures.h"
#include "PieceUnion.h"

#include <algorithm> // for sort, adjacent_find
#include <tuple>     // for keys
#include <utility>   // for move
#include <vector>    // for vertices

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

// Where steps end, as shares of the time of the stage.
constexpr double CountingEnd = 0.01;
constexpr double AssemblyEnd = 0.2;
constexpr double CheckEnd = 0.4;
constexpr double QualityEnd = 0.98;

// The mesh as it is handed out, but for its quality. Where blocks are spread it is that of their
// collars, of which more is to be checked (Pieces/PieceMeasures.h).
BitingMesh Assemble(const Domain& domain, BitingResult bites, Triangulation& triangulation,
  bool isDelaunay, bool isSpread, ProblemList& problems, Monitor& monitor)
{
  PartOfStage part(monitor, CountingEnd, AssemblyEnd);
  const std::vector<Id> segments = bites.EdgeSegments;
  BitingMesh mesh = AssembleMesh(domain, std::move(bites), triangulation, part);
  if (!AddAborted(part, problems))
  {
    PartOfStage checking(monitor, AssemblyEnd, CheckEnd);
    const std::vector<Id>& constraints = triangulation.Constraints;
    MeshCheckInput all{ mesh.Points, mesh.Corners, mesh.Neighbors, constraints, domain.Area };
    all.IsDelaunay = isDelaunay;
    std::string violation = isSpread ? "" : CheckMesh(all, checking);
    if (violation.empty() && !checking.HasStopped())
    {
      violation = CheckSegmentCover(
        domain, { mesh.Points, mesh.Corners, mesh.Neighbors, constraints, segments }, checking);
    }
    if (!AddAborted(checking, problems) && !violation.empty())
    {
      AddProblem(ProblemCode::CheckFailed, violation, problems);
    }
  }
  return mesh;
}

// Whether so much is due to the drawing that it is counted.
bool IsFine(const Domain& drawing, const BitingMeshOptions& options, const Spacing& spacing,
  const BitingMesh& mesh, double numberOfVertices)
{
  return !options.PreserveBoundary &&
    IsFineDrawing(drawing, mesh.Spacing, numberOfVertices, spacing);
}

// Says so where it is large and no tolerance is set.
void TellFineDrawing(
  const ExactSum& asked, const BitingMeshOptions& options, BitingMesh& mesh, ProblemList& problems)
{
  const double vertices = static_cast<double>(mesh.Quality.NumberOfVertices);
  mesh.ShareOfDrawing = ShareOfFineDrawing(asked, vertices);
  const bool isAccepted = options.Simplification.Tolerance > 0.0;
  if (!isAccepted && IsWorthTelling(mesh.ShareOfDrawing, vertices))
  {
    AddProblem(ProblemCode::FineDrawing,
      Figure(100.0 * mesh.ShareOfDrawing) + " % of the vertices are there for it alone", problems);
  }
}

SpreadInput Spread(const MeshingInput& input, BlockMesher& blocks)
{
  return { input.Simplified.Drawing, input.F, blocks.Kept(), input.Members,
    input.Options.GhostLevels };
}

// The quality, and what the drawing has to do with it.
void Judge(const MeshingInput& input, BitingMesh& mesh, ProblemList& problems, PartOfStage& whole)
{
  const MeshView view{ mesh.Points, mesh.Spacing, mesh.Corners, mesh.Neighbors };
  PartOfStage measuring(whole, CheckEnd, QualityEnd);
  mesh.Quality = MeasureQuality(view, measuring);
  mesh.UsedLipschitz = mesh.Quality.LargestSlope;
  if (!IsOver(whole, problems) &&
    IsFine(input.Simplified.Drawing, input.Options, input.F, mesh,
      static_cast<double>(mesh.Points.size())))
  {
    PartOfStage part(whole, QualityEnd, 1.0);
    Pulse pulse(part);
    const ExactSum asked = CountAsked(mesh, input.F, pulse);
    if (!AddAborted(part, problems))
    {
      TellFineDrawing(asked, input.Options, mesh, problems);
    }
  }
}

// The same for the piece of the first of several members; the others take theirs.
void JudgePieces(const MeshingInput& input, BlockMesher& blocks, const std::vector<Id>& constraints,
  BitingMesh& mesh, ProblemList& problems, PartOfStage& whole)
{
  const bool isFine = IsFine(input.Simplified.Drawing, input.Options, input.F, mesh,
    static_cast<double>(blocks.Kept().Numbers.NumberOfVertices));
  PartOfStage sharing(whole, CheckEnd, 1.0);
  ExactSum asked;
  mesh = ShareMesh(
    Spread(input, blocks), std::move(mesh), constraints, isFine, asked, problems, sharing);
  mesh.UsedLipschitz = mesh.Quality.LargestSlope;
  if (!AddAborted(sharing, problems) && !problems.HasErrors() && isFine)
  {
    TellFineDrawing(asked, input.Options, mesh, problems);
  }
}

// Whether two vertices of boundary or interfaces are at one place, as where a cut ends beside one.
bool HasRepeatedPlaces(const BitingMesh& mesh)
{
  std::vector<Id> vertices = mesh.EdgeStarts;
  vertices.insert(vertices.end(), mesh.EdgeEnds.begin(), mesh.EdgeEnds.end());
  const auto key = [&mesh](Id vertex)
  { return std::make_tuple(mesh.Points[vertex].X, mesh.Points[vertex].Y, vertex); };
  std::sort(vertices.begin(), vertices.end(), [&key](Id a, Id b) { return key(a) < key(b); });
  return std::adjacent_find(vertices.begin(), vertices.end(),
           [&mesh](Id a, Id b)
           { return a != b && mesh.Points[a] == mesh.Points[b]; }) != vertices.end();
}

// Of a mesh that was made in blocks.
void TellBlocks(BlockMesher& blocks, BitingMesh& mesh, ProblemList& problems)
{
  mesh.NumberOfBlocks = static_cast<Id>(blocks.Kept().Parts.Blocks.size());
  if (HasRepeatedPlaces(mesh.Border ? *mesh.Border : mesh))
  {
    AddProblem(ProblemCode::CheckFailed, "two vertices are at one place", problems);
  }
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

BitingMesh FinishMesh(const MeshingInput& input, BlockMesher& blocks, BitingResult bites,
  Triangulation& triangulation, ProblemList& problems, PartOfStage& whole)
{
  if (blocks.IsHelping())
  {
    PartOfStage taking(whole, 0.0, 1.0);
    return TakePiece(Spread(input, blocks), problems, taking);
  }
  const Domain& domain = input.Simplified.Drawing;
  const bool isSpread = blocks.Kept().AreSpread;
  PartOfStage counting(whole, 0.0, CountingEnd);
  const Id sharp = CountSharpCornerTriangles(domain, bites, triangulation, counting);
  BitingMesh mesh = Assemble(
    domain, std::move(bites), triangulation, input.Settings.IsDelaunay, isSpread, problems, whole);
  if (IsOver(whole, problems))
  {
    return {};
  }
  isSpread ? JudgePieces(input, blocks, triangulation.Constraints, mesh, problems, whole)
           : Judge(input, mesh, problems, whole);
  mesh.NumberOfSharpCornerTriangles = sharp;
  mesh.GivenLipschitz = input.F.GivenLipschitz();
  mesh.RemovedVertices = input.Simplified.RemovedVertices;
  mesh.LeftOutLoops = input.Simplified.LeftOutLoops;
  mesh.LeftOutArea = input.Simplified.LeftOutArea;
  if (!IsOver(whole, problems) && blocks.IsInUse())
  {
    TellBlocks(blocks, mesh, problems);
  }
  return problems.HasErrors() ? BitingMesh() : std::move(mesh);
}

} // namespace biting
