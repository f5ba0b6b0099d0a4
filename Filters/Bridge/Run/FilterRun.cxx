// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "FilterRun.h"

#include "../Source/ChosenArray.h"
#include "../Source/SourceData.h"
#include "../Source/SourceSpacing.h"
#include "ProblemsToPolyData.h"
#include "SummaryText.h"

#include "vtkAlgorithm.h"
#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkPolyData.h"

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

FilterRun::FilterRun(const RunningFilter& filter, std::vector<double> shares)
  : Progress(filter.Filter, std::move(shares), filter.NumberOfThreads)
  , Running(filter)
{
  this->Progress.StopWhere([isStopping = filter.IsStopping]() { return *isStopping; });
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

void FilterRun::EndWhereStopped()
{
  if (*this->Running.IsStopping)
  {
    vtkBitingCompat::EndAbort(this->Running.Filter);
    this->Refuse("Stopped, as was asked for. Apply again to mesh.");
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
  *this->Running.Summary += "Error: " + reason + "\n";
  vtkErrorWithObjectMacro(this->Running.Filter, << reason);
}

void FilterRun::Warn(const std::string& text) const
{
  this->Warn(text, text);
}

void FilterRun::Warn(const std::string& text, const std::string& inShort) const
{
  if (!text.empty() && !this->Running.IsSilent)
  {
    *this->Running.Summary += "Warning: " + inShort + "\n";
    vtkWarningWithObjectMacro(this->Running.Filter, << text);
  }
}

void FilterRun::WarnOfRepairs(const PlanarInput& planar) const
{
  for (const ProblemGroup& group : this->Problems.Groups())
  {
    if (!IsError(group.Code) && !IsNote(group.Code))
    {
      this->Warn(MessageFrom(group, planar), HeadingOf(group) + ", see Problems");
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
      SpacingArrayName + ", and no other was chosen." +
      (data.Chosen.IsOfCells ? CellDataAdvice : ""));
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
