// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "FilterRun.h"

#include "ChosenArray.h"
#include "MeshPieces.h"
#include "ProblemsToPolyData.h"
#include "SourceData.h"
#include "SourceSpacing.h"
#include "SummaryText.h"

#include "vtkAlgorithm.h"
#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <memory>  // for pieces
#include <new>     // for bad_alloc
#include <utility> // for move

namespace biting
{

void EmptyOutputs(vtkInformationVector* outputs)
{
  for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
  {
    vtkDataObject::GetData(outputs, port)->Initialize();
  }
}

namespace
{

// Null where all of the mesh is to stay together.
std::unique_ptr<MeshPieces> PiecesOf(
  vtkInformation* output, std::vector<Id> piecesOfTriangles, int numberOfPieces)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  if (piecesOfTriangles.empty())
  {
    return nullptr;
  }
  const auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->ShallowCopy(vtkPolyData::GetData(output));
  auto pieces = std::make_unique<MeshPieces>(mesh, std::move(piecesOfTriangles), numberOfPieces);
  pieces->SetGhostLevels(output->Has(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS())
      ? output->Get(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS())
      : 0);
  return pieces;
}

} // namespace

FilterRun::FilterRun(const RunningFilter& filter, std::vector<double> shares)
  : Progress(filter.Filter, std::move(shares), filter.NumberOfThreads)
  , Running(filter)
{
}

void FilterRun::Guard(vtkInformationVector* outputs, const std::function<void()>& run)
{
  try
  {
    run();
    if (this->WasAborted())
    {
      EmptyOutputs(outputs);
      this->EndWhereStopped();
    }
  }
  catch (const std::bad_alloc&)
  {
    EmptyOutputs(outputs);
    this->Refuse("There is not enough memory for this mesh. Choose a larger spacing.");
  }
}

bool FilterRun::Spread(const Ranks& ranks, const std::function<std::vector<Id>(Pulse&)>& divide,
  vtkInformationVector* outputs)
{
  if (!ranks.AreSeveral())
  {
    return false;
  }
  vtkInformation* output = outputs->GetInformationObject(0);
  vtkPolyData* mesh = vtkPolyData::GetData(output);
  std::unique_ptr<MeshPieces> pieces;
  if (mesh->GetNumberOfCells() > 0)
  {
    this->Guard(outputs,
      [this, &ranks, &divide, output, &pieces]()
      {
        Pulse pulse(this->Progress);
        pieces = PiecesOf(output, divide(pulse), ranks.Count());
      });
  }
  Delivery delivery = Delivery::None;
  if (!pieces || this->WasAborted())
  {
    delivery = ranks.SendPieces({}, mesh);
  }
  else
  {
    const auto make = [this, &pieces](int rank)
    { return this->Progress.Advance(1.0) ? pieces->Make(rank) : nullptr; };
    delivery = ranks.SendPieces(make, mesh);
  }
  if (delivery == Delivery::Failed)
  {
    this->EndUndelivered(outputs);
  }
  return delivery == Delivery::Done;
}

// It was stopped, or memory did not suffice.
void FilterRun::EndUndelivered(vtkInformationVector* outputs)
{
  EmptyOutputs(outputs);
  if (this->WasAborted())
  {
    this->EndWhereStopped();
  }
  else
  {
    this->Refuse(NotSpread);
  }
}

void FilterRun::EndWhereStopped()
{
  if (*this->Running.IsStopping)
  {
    vtkBitingCompat::EndAbort(this->Running.Filter);
    this->Refuse("Stopped, as was asked for. Change a parameter to mesh again.");
  }
}

bool FilterRun::Accept(const std::string& refusal)
{
  if (!refusal.empty())
  {
    this->Refuse(refusal);
  }
  return refusal.empty();
}

void FilterRun::Refuse(const std::string& reason)
{
  this->IsRefused = true;
  if (this->Running.IsSilent)
  {
    return;
  }
  *this->Running.ErrorCode = vtkErrorCode::UserError;
  *this->Running.Summary += RefusalLines(reason);
  vtkErrorWithObjectMacro(this->Running.Filter, << reason);
}

void FilterRun::Warn(const std::string& text) const
{
  if (!text.empty() && !this->Running.IsSilent)
  {
    vtkWarningWithObjectMacro(this->Running.Filter, << text);
  }
}

void FilterRun::WarnOfRepairs(const PlanarInput& planar) const
{
  for (const ProblemGroup& group : this->Problems.Groups())
  {
    if (!IsError(group.Code) && !IsNote(group.Code))
    {
      this->Warn(MessageFrom(group, planar));
    }
  }
}

std::string FilterRun::AddSource(vtkInformation* information, vtkDataObject* source,
  const PlaneFrame& frame, const std::function<bool(const Point2&)>& isWanted,
  SpacingOptions& spacing, Monitor& part)
{
  const SourceData data = ChooseSource(information, source);
  if (data.Chosen.IsMissing)
  {
    this->Warn(std::string("The spacing source is not used: it has no point array named ") +
      SpacingArrayName + ", and no other was chosen.");
  }
  if (!data.Chosen.Refusal.empty() || !data.Chosen.Array)
  {
    return data.Chosen.Refusal;
  }
  return AddSourceSpacing(data, frame, isWanted, spacing, this->Places, part);
}

void FilterRun::WriteProblems(const PlanarInput& planar, RepairPolicy policy, vtkPolyData* output)
{
  if (!this->Problems.Has(ProblemCode::Aborted))
  {
    AddPlaces(this->Problems, planar, policy, this->Places);
    ProblemsToPolyData(this->Places, output);
  }
}

} // namespace biting
