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
#include "SpreadMesh.h"

#include <algorithm> // for sort, adjacent_find
#include <tuple>     // for keys
#include <utility>   // for move
#include <vector>    // for vertices

namespace biting
{

namespace
{

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
