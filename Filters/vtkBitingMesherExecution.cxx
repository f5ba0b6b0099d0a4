// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkBitingMesherExecution.h"

#include "Bridge/Data/CarriedArrays.h"
#include "Bridge/Drawing/BoundarySpacing.h"
#include "Bridge/Drawing/CellTags.h"
#include "Bridge/Drawing/Globe.h"
#include "Bridge/Drawing/PolylinesFromDrawing.h"
#include "Bridge/Mesh/BitesToPolyData.h"
#include "Bridge/Mesh/MeshToPolyData.h"
#include "Bridge/Ranks/RankCrew.h"
#include "Bridge/Ranks/Ranks.h"
#include "Bridge/Run/FilterRun.h"
#include "Bridge/Run/ProblemReport.h"
#include "Bridge/Run/SummaryText.h"
#include "Bridge/Source/DomainMembership.h"
#include "Bridge/Source/SourceCover.h"
#include "Bridge/Source/SourceData.h"
#include "Bridge/Source/TransferredArrays.h"
#include "Kernel/Base/Monitor.h"
#include "Kernel/BitingMesh.h"
#include "Kernel/Blocks/ByteStream.h"
#include "Kernel/Pieces/CrewRounds.h"
#include "Kernel/Stages/CoveringFaces.h"
#include "Kernel/Stages/MeshingStages.h"

#include "vtkCellData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkOutputWindow.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <new>     // for bad_alloc
#include <utility> // for move
#include <vector>  // for bytes

VTK_ABI_NAMESPACE_BEGIN

namespace
{

// The stages around those of the kernel, with their shares of the time of a run.
constexpr biting::Stage ReadingStage{ "Reading the input", 0.02 };
constexpr biting::Stage WritingStage{ "Writing the mesh", 0.06 };

// Where steps of reading and of writing end, as shares of their time.
constexpr double ChainsEnd = 0.5;
constexpr double BoundaryEnd = 0.6;
constexpr double PointsEnd = 0.15;
constexpr double MeshEnd = 0.7;
constexpr double EdgesEnd = 0.8;

} // namespace

//------------------------------------------------------------------------------
vtkBitingMesher::Execution::Execution(vtkBitingMesher* filter, biting::RankCrew& crew)
  : FilterRun({ filter, &filter->ErrorCode, &filter->Summary, &filter->IsStopping,
                filter->NumberOfThreads, crew.Own() != 0 },
      biting::SharesOfStages(ReadingStage, biting::MeshingStages::InOrder, WritingStage))
  , Filter(filter)
  , Crew(crew)
{
}

//------------------------------------------------------------------------------
void vtkBitingMesher::Execution::Run(const biting::WholeInput& drawing,
  const biting::WholeInput& source, vtkInformationVector* outputs)
{
  this->ReadGhostLevels(outputs);
  const auto run = [this, &drawing, &source, outputs]()
  {
    if (this->Gather(drawing, source) && this->ReadParameters() && this->ReadChains() &&
      this->ReadSpacing() && this->MakeMesh() && this->FindCells())
    {
      this->Write(outputs);
      this->IsSpread = this->Mesh.Piece.IsPart && this->Deliver();
    }
    const bool isRepaired = this->Options.Domain.Repair;
    this->WriteProblems(this->Planar,
      isRepaired ? biting::RepairPolicy::Repaired : biting::RepairPolicy::Left,
      vtkPolyData::GetData(outputs, PROBLEMS));
  };
  this->Guard(outputs, run);
  this->Crew.End();
}

//------------------------------------------------------------------------------
void vtkBitingMesher::Execution::Help(const biting::WholeInput& drawing,
  const biting::WholeInput& source, vtkInformationVector* outputs)
{
  if (!this->Crew.AwaitCall())
  {
    return;
  }
  this->ReadGhostLevels(outputs);
  this->Progress.StopWhere([this]() { return this->Crew.IsDismissed(); });
  try
  {
    if (this->Gather(drawing, source) && this->ReadParameters() && this->ReadChains() &&
      this->ReadSpacing() && this->MakeMesh() && this->FindCells())
    {
      this->Write(outputs);
      this->IsSpread = this->Deliver();
    }
  }
  catch (const std::bad_alloc&)
  {
    // The first rank does it itself, or says so.
    this->IsSpread = false;
  }
  if (!this->IsSpread)
  {
    biting::EmptyOutputs(outputs);
  }
  this->Crew.End();
}

//------------------------------------------------------------------------------
void vtkBitingMesher::Execution::ReadGhostLevels(vtkInformationVector* outputs)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* mesh = outputs->GetInformationObject(MESH);
  this->Options.GhostLevels = mesh->Has(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS())
    ? mesh->Get(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS())
    : 0;
}

//------------------------------------------------------------------------------
bool vtkBitingMesher::Execution::Gather(
  const biting::WholeInput& drawing, const biting::WholeInput& source)
{
  if (!this->AcceptComplete({ &drawing, &source }))
  {
    return false;
  }
  const vtkSmartPointer<vtkDataObject> input = drawing.Make();
  this->Drawing = biting::ReadDrawing(input);
  this->Source = source.Make();
  return input != nullptr;
}

//------------------------------------------------------------------------------
bool vtkBitingMesher::Execution::ReadParameters()
{
  const vtkBitingMesher& filter = *this->Filter;
  this->Planar.IsOnGlobe = filter.Coordinates == LONGITUDE_LATITUDE;
  this->Planar.MayDivide = !filter.PreserveBoundary;
  this->Options.Spacing.Uniform = filter.UniformSpacing;
  this->Options.Spacing.Scale = filter.SpacingScale;
  this->Options.Spacing.Minimum = filter.MinimumSpacing;
  this->Options.Spacing.Maximum = filter.MaximumSpacing;
  this->Options.Spacing.Gradation = filter.Gradation;
  this->Options.LimitByFeatureSize = filter.LimitByFeatureSize;
  this->Options.CellsAcross = filter.CellsAcross;
  this->Options.Domain.Repair = filter.RepairInput;
  this->Options.Domain.Rule = static_cast<biting::DomainRule>(filter.DomainRule);
  this->Options.Domain.KeepCellEdges = filter.KeepCellEdges;
  this->Options.Domain.MergeTolerance = filter.MergeTolerance;
  this->Options.Domain.EndTolerance = filter.EndTolerance;
  this->Options.PreserveBoundary = filter.PreserveBoundary;
  this->Options.Simplification.Tolerance = filter.BoundaryTolerance;
  this->Options.Simplification.CornerAngle = filter.CornerAngle;
  this->Options.Simplification.MinimumLoopSize = filter.MinimumLoopSize;
  this->Options.BitingConstant = filter.BitingConstant;
  this->Options.BiteShape =
    filter.BiteShape == CIRCLE ? biting::BiteShape::Circle : biting::BiteShape::Square;
  this->Options.Placement =
    filter.Placement == BISECTORS ? biting::Placement::Bisectors : biting::Placement::Corners;
  static_assert(static_cast<int>(biting::FrontOrder::Layers) == LAYERS &&
      static_cast<int>(biting::FrontOrder::LargestY) == LARGEST_Y &&
      static_cast<int>(biting::FrontOrder::BestFirst) == BEST_FIRST &&
      biting::FrontRules.size() == BEST_FIRST + 1,
    "the orders of the kernel are those of the filter");
  this->Options.Order = biting::FrontRules[filter.FrontOrder].Order;
  this->Options.MaximumNumberOfBites = filter.MaximumNumberOfBites;
  this->Options.MaximumNumberOfVertices = filter.MaximumNumberOfVertices;
  this->Options.VerticesPerBlock = filter.VerticesPerBlock;
  this->Options.Phi = filter.Phi;
  this->Options.Relaxation = filter.Relaxation;
  this->Options.KeepBites = filter.GenerateBites;
  return this->Accept(biting::CheckMesherParameters(this->Options));
}

//------------------------------------------------------------------------------
bool vtkBitingMesher::Execution::ReadChains()
{
  this->Progress.BeginStage(ReadingStage.Text);
  biting::PartOfStage part(this->Progress, 0.0, ChainsEnd);
  const bool isRead = this->Accept(biting::PolylinesFromDrawing(
    this->Drawing, this->Filter->RegionArray, this->Planar, this->Problems, part));
  const bool isEmpty = this->Planar.Chains.NumberOfChains() == 0;
  if (isRead && isEmpty && this->Drawing.NumberOfCells > 0 && !this->WasAborted())
  {
    return this->Accept("No cell of the input describes a domain; lines, two-dimensional cells and "
                        "vertex cells do, unless they are hidden, or have too few points.");
  }
  if (isRead && isEmpty && this->Drawing.NumberOfPoints > 0 && !this->WasAborted())
  {
    return this->Accept(
      "The input has points, but no cells; lines, two-dimensional cells and vertex "
      "cells describe a domain.");
  }
  return isRead && !this->ReportErrors() && !this->WasAborted() && !isEmpty;
}

//------------------------------------------------------------------------------
bool vtkBitingMesher::Execution::ReadSpacing()
{
  if (!this->Accept(this->AddBoundaryArray()) || !this->Accept(this->AddSourceArray()) ||
    !this->ReadTranslations() ||
    !this->Accept(
      biting::FindCracks(this->Drawing, this->Filter->SplitInterfaces, this->Options.Opens)))
  {
    return false;
  }
  if (this->Planar.IsOnGlobe)
  {
    this->Options.Spacing.Curvature = this->Planar.Frame.Curvature();
    biting::PartOfStage part(this->Progress, 1.0, 1.0);
    biting::DivideLines(&this->Options.Spacing, this->Planar, part);
  }
  return !this->WasAborted();
}

//------------------------------------------------------------------------------
bool vtkBitingMesher::Execution::ReadTranslations()
{
  for (const double* vector :
    { this->Filter->PeriodicTranslation, this->Filter->PeriodicTranslation2 })
  {
    const biting::Point3 translation{ vector[0], vector[1], vector[2] };
    const double length = Length(translation);
    if (length != 0.0 && this->Planar.IsOnGlobe)
    {
      return this->Accept("Periodic Translation is for Coordinates Plane.");
    }
    biting::Point2 inPlane;
    if (length != 0.0 && !this->Planar.Frame.TakeVector(translation, inPlane))
    {
      return this->Accept("Periodic Translation is a vector in the plane of the drawing, of finite "
                          "length.");
    }
    if (length != 0.0)
    {
      this->Options.PeriodicTranslations.push_back(inPlane);
    }
  }
  return true;
}

//------------------------------------------------------------------------------
std::string vtkBitingMesher::Execution::AddBoundaryArray()
{
  const biting::ChosenArray chosen =
    biting::ChooseBoundaryArray(this->Filter->BoundaryArrayChoice(), this->Drawing);
  if (!chosen.Refusal.empty() || !chosen.Array)
  {
    return chosen.Refusal;
  }
  biting::PartOfStage part(this->Progress, ChainsEnd, BoundaryEnd);
  return biting::AddBoundarySpacing(
    this->Drawing, this->Planar, chosen, this->Options.Spacing, this->Places, part);
}

//------------------------------------------------------------------------------
std::string vtkBitingMesher::Execution::AddSourceArray()
{
  if (!this->Source)
  {
    return {};
  }
  biting::PartOfStage part(this->Progress, BoundaryEnd, 1.0);
  biting::DomainMembership domain(this->Planar.Chains, part, this->Options.Domain.Rule);
  return this->AddSource(
    this->Filter->GetInputArrayInformation(1), this->Source, this->Planar.Frame,
    [&domain](const biting::Point2& place) { return domain.MayHold(place); }, this->Options.Spacing,
    part);
}

//------------------------------------------------------------------------------
bool vtkBitingMesher::Execution::MakeMesh()
{
  if (this->Options.Simplification.Tolerance > 0.0)
  {
    this->Options.Simplification.AreAlike = biting::CompareTags(this->Drawing, this->Planar.Chains);
  }
  this->Mesh = biting::MakeBitingMesh(
    this->Planar.Chains, this->Options, this->Problems, this->Progress, this->Crew);
  if (this->Crew.Own() != 0)
  {
    return this->Mesh.Piece.IsPart;
  }
  if (this->WasAborted() || this->ReportErrors())
  {
    return false;
  }
  this->WarnOfRepairs(&this->Planar);
  if (!this->Mesh.Piece.IsPart)
  {
    this->Warn(biting::UncoveredWarning(
      biting::FindUncovered(this->Mesh, this->Options.Spacing), this->Planar.Frame));
  }
  this->ReportNotes();
  return true;
}

//------------------------------------------------------------------------------
// Those on which triangles lie; pieces decide together. False where one of them does not arrive.
bool vtkBitingMesher::Execution::FindCells()
{
  this->Progress.BeginStage(WritingStage.Text);
  biting::PartOfStage part(this->Progress, 0.0, PointsEnd);
  biting::Pulse pulse(part);
  const biting::CoveringFaces faces(this->Planar.Chains, this->Options.Domain, pulse);
  if (faces.IsEmpty() || this->Drawing.CellArrays->GetNumberOfArrays() == 0)
  {
    return !pulse.HasStopped();
  }
  this->TriangleCells = faces.FacesOf(this->Mesh, pulse);
  biting::CoveringFaces::Votes votes;
  if (!pulse.HasStopped())
  {
    votes = faces.Count(this->Mesh, this->TriangleCells);
  }
  if (this->Mesh.Piece.IsPart)
  {
    votes = this->VotesOfAll(votes, part);
  }
  if (pulse.HasStopped() || part.HasStopped() || votes.empty())
  {
    return false;
  }
  faces.CorrectBy(votes, this->Mesh, this->TriangleCells, pulse);
  for (biting::Id& cell : this->TriangleCells)
  {
    cell = this->Planar.Chains.Cells[cell];
  }
  return !pulse.HasStopped();
}

//------------------------------------------------------------------------------
// Of all pieces; empty where one of them does not arrive.
biting::CoveringFaces::Votes vtkBitingMesher::Execution::VotesOfAll(
  const biting::CoveringFaces::Votes& votes, biting::PartOfStage& part)
{
  biting::CrewRounds rounds(this->Crew, this->Crew.WhoIsAtWork());
  biting::ByteWriter own;
  own.Put(votes);
  const auto join = [](const std::vector<std::vector<char>>& all)
  {
    biting::CoveringFaces::Votes joined;
    for (const std::vector<char>& bytes : all)
    {
      biting::CoveringFaces::Votes next;
      biting::ByteReader(bytes).Take(next);
      joined.insert(joined.end(), next.begin(), next.end());
    }
    biting::ByteWriter writer;
    writer.Put(joined);
    return std::move(writer.Bytes);
  };
  const std::vector<char> reply = rounds.Share(std::move(own.Bytes), part, join);
  biting::CoveringFaces::Votes whole;
  biting::ByteReader(reply).Take(whole);
  return whole;
}

//------------------------------------------------------------------------------
// Of several ranks, each has its piece: whether all of them have. Warns of all of it.
bool vtkBitingMesher::Execution::Deliver()
{
  biting::PartOfStage part(this->Progress, 1.0, 1.0);
  biting::CrewRounds rounds(this->Crew, this->Crew.WhoIsAtWork());
  biting::ByteWriter own;
  own.Put(biting::FindUncovered(this->Mesh, this->Options.Spacing));
  return rounds.GoOn(std::move(own.Bytes), part,
    [this](const std::vector<std::vector<char>>& all)
    {
      biting::UncoveredPart uncovered;
      for (const std::vector<char>& bytes : all)
      {
        biting::UncoveredPart next;
        biting::ByteReader(bytes).Take(next);
        uncovered.Join(next);
      }
      this->Warn(biting::UncoveredWarning(uncovered, this->Planar.Frame));
      return true;
    });
}

//------------------------------------------------------------------------------
// One error for each kind. Returns whether there was one.
bool vtkBitingMesher::Execution::ReportErrors()
{
  for (const biting::ProblemGroup& group : this->Problems.Groups())
  {
    if (biting::IsError(group.Code))
    {
      const bool isLeft =
        group.Code == biting::ProblemCode::NotResolved && !this->Filter->RepairInput;
      this->Accept(isLeft ? biting::NotResolvedMessageFrom(this->Problems, this->Planar)
                          : biting::RefusalFrom(group, this->Problems, this->Planar));
    }
  }
  return this->IsRefused;
}

//------------------------------------------------------------------------------
// A line of text, as nothing is wrong: ParaView keeps it among its messages and opens nothing.
void vtkBitingMesher::Execution::ReportNotes() const
{
  for (const biting::ProblemGroup& group : this->Problems.Groups())
  {
    if (biting::IsNote(group.Code) && vtkObject::GetGlobalWarningDisplay())
    {
      const std::string line = biting::MessageFrom(group, this->Planar) + "\n";
      vtkOutputWindow::GetInstance()->DisplayText(line.c_str());
    }
  }
}

//------------------------------------------------------------------------------
void vtkBitingMesher::Execution::Write(vtkInformationVector* outputs)
{
  biting::Pulse pulse(this->Progress);
  const auto points = this->MakePoints(pulse);
  biting::EndOnGlobe(this->Planar, this->Drawing.NumberOfPoints, this->Mesh);
  this->WriteMesh(points, vtkPolyData::GetData(outputs, MESH), pulse);
  this->WriteEdges(points, vtkPolyData::GetData(outputs, BOUNDARY_EDGES), pulse);
  if (this->Filter->GenerateBites)
  {
    const biting::PulsePart part(pulse, EdgesEnd, 1.0);
    biting::BitesToPolyData(
      this->Mesh, this->Planar.Frame, vtkPolyData::GetData(outputs, BITES), pulse);
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPoints> vtkBitingMesher::Execution::MakePoints(biting::Pulse& pulse) const
{
  const biting::PulsePart part(pulse, 0.0, PointsEnd);
  return biting::PointsInSpace(this->Mesh, this->Planar, pulse);
}

//------------------------------------------------------------------------------
void vtkBitingMesher::Execution::WriteMesh(
  vtkPoints* points, vtkPolyData* output, biting::Pulse& pulse) const
{
  const biting::PulsePart part(pulse, PointsEnd, MeshEnd);
  biting::MeshToPolyData(this->Mesh, points, this->Problems, output, pulse);
  if (!this->TriangleCells.empty())
  {
    biting::CarryArrays(this->Drawing.CellArrays, this->Drawing.NumberOfCells, this->TriangleCells,
      output->GetCellData(), pulse);
  }
  if (this->Filter->TransferSourceArrays && this->Source)
  {
    biting::TransferArrays(
      this->Source, this->Planar.Frame, this->Mesh.Points, output->GetPointData(), pulse);
  }
  if (this->Mesh.Piece.IsPart)
  {
    biting::AddPieceArrays(this->Mesh.Piece, this->Options.GhostLevels > 0, output, pulse);
  }
}

//------------------------------------------------------------------------------
void vtkBitingMesher::Execution::WriteEdges(
  vtkPoints* points, vtkPolyData* output, biting::Pulse& pulse) const
{
  const biting::PulsePart part(pulse, MeshEnd, EdgesEnd);
  const biting::BitingMesh* border = this->Mesh.Border.get();
  if (!border && !this->Mesh.Piece.IsPart)
  {
    biting::BoundaryEdgesToPolyData(this->Mesh, points, this->Drawing, output, pulse);
  }
  else if (border)
  {
    biting::BoundaryEdgesToPolyData(
      *border, biting::PointsInSpace(*border, this->Planar, pulse), this->Drawing, output, pulse);
  }
}

VTK_ABI_NAMESPACE_END
