// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "FilterRun.h"

#include "../Source/SourceData.h"
#include "../Source/SourceSpacing.h"
#include "ProblemReport.h"
#include "SummaryText.h"

#include "vtkAlgorithm.h"
#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm> // for all_of, min, max
#include <new>       // for bad_alloc
#include <set>       // for times
#include <utility>   // for move
#include <vector>    // for times as VTK takes them

namespace biting
{

namespace
{

using Pipeline = vtkStreamingDemandDrivenPipeline;

// Of inputs that change with time.
struct Times
{
  std::set<double> Steps;
  double Range[2] = { 0.0, 0.0 };
  bool AreAny = false;

  void Add(vtkInformation* input);
};

void Times::Add(vtkInformation* input)
{
  if (!input->Has(Pipeline::TIME_RANGE()))
  {
    return;
  }
  const double* range = input->Get(Pipeline::TIME_RANGE());
  this->Range[0] = this->AreAny ? std::min(this->Range[0], range[0]) : range[0];
  this->Range[1] = this->AreAny ? std::max(this->Range[1], range[1]) : range[1];
  this->AreAny = true;
  if (input->Has(Pipeline::TIME_STEPS()))
  {
    const double* steps = input->Get(Pipeline::TIME_STEPS());
    this->Steps.insert(steps, steps + input->Length(Pipeline::TIME_STEPS()));
  }
}

} // namespace

void EmptyOutputs(vtkInformationVector* outputs)
{
  for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
  {
    vtkDataObject::GetData(outputs, port)->Initialize();
  }
}

int RunOnFirstRank(vtkAlgorithm* filter, unsigned long& errorCode, const PipelineRequest& request,
  const std::function<void(const WholeInputs&)>& run)
{
  errorCode = vtkErrorCode::NoError;
  const Ranks ranks(request.Request, request.Outputs);
  WholeInputs inputs;
  inputs.reserve(static_cast<std::size_t>(filter->GetNumberOfInputPorts()));
  for (int port = 0; port < filter->GetNumberOfInputPorts(); ++port)
  {
    inputs.emplace_back(ranks, request.Inputs[port]);
  }
  if (ranks.IsFirst())
  {
    run(inputs);
  }
  errorCode = ranks.ShareOutcome(errorCode, false, filter, request.Outputs);
  return 1;
}

FilterRun::FilterRun(const RunningFilter& filter, std::vector<double> shares)
  : Progress(filter.Filter, std::move(shares), filter.NumberOfThreads)
  , Running(filter)
{
  if (const bool* isStopping = filter.IsStopping)
  {
    this->Progress.StopWhere([isStopping]() { return *isStopping; });
  }
}

void FilterRun::Guard(
  vtkInformationVector* outputs, const std::function<void()>& run, const char* noMemory)
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
    this->Refuse(noMemory);
  }
}

void FilterRun::EndWhereStopped()
{
  if (this->Running.IsStopping && *this->Running.IsStopping)
  {
    vtkBitingCompat::EndAbort(this->Running.Filter);
    this->Refuse("Stopped, as was asked for. Apply again to mesh.");
  }
}

bool FilterRun::AcceptComplete(std::initializer_list<const WholeInput*> inputs)
{
  const bool areComplete = std::all_of(
    inputs.begin(), inputs.end(), [](const WholeInput* input) { return input->IsComplete(); });
  return this->Accept(areComplete ? "" : NotGathered);
}

bool FilterRun::AcceptProblems(const PlanarInput* planar)
{
  for (const ProblemGroup& group : this->Problems.Groups())
  {
    if (IsError(group.Code) && group.Code != ProblemCode::Aborted)
    {
      this->Refuse(planar ? MessageFrom(group, *planar) : MessageInSpace(group));
    }
  }
  return !this->IsRefused;
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
  this->Note("Error: " + reason + "\n");
  vtkErrorWithObjectMacro(this->Running.Filter, << reason);
}

// In the summary, where there is one.
void FilterRun::Note(const std::string& line) const
{
  if (this->Running.Summary)
  {
    *this->Running.Summary += line;
  }
}

void FilterRun::Warn(const std::string& text) const
{
  this->Warn(text, text);
}

void FilterRun::Warn(const std::string& text, const std::string& inShort) const
{
  if (!text.empty() && !this->Running.IsSilent)
  {
    this->Note("Warning: " + inShort + "\n");
    vtkWarningWithObjectMacro(this->Running.Filter, << text);
  }
}

void FilterRun::WarnOfRepairs(const PlanarInput* planar) const
{
  for (const ProblemGroup& group : this->Problems.Groups())
  {
    if (!IsError(group.Code) && !IsNote(group.Code))
    {
      this->Warn(planar ? MessageFrom(group, *planar) : MessageInSpace(group),
        HeadingOf(group) + ", see Problems");
    }
  }
}

SourceData FilterRun::Choose(vtkInformation* information, vtkDataObject* source)
{
  SourceData data = ChooseSource(information, source);
  if (data.Chosen.IsMissing)
  {
    this->Warn(std::string("The spacing source is not used: it has no point array named ") +
      SpacingArrayName + ", and no other was chosen." +
      (data.Chosen.IsOfCells ? CellDataAdvice : ""));
  }
  return data;
}

std::string FilterRun::AddSource(vtkInformation* information, vtkDataObject* source,
  const PlaneFrame& frame, const std::function<bool(const Point2&)>& isWanted,
  SpacingOptions& spacing, Monitor& part)
{
  const SourceData data = this->Choose(information, source);
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

int PassTimes(vtkInformationVector** inputs, int numberOfPorts, vtkInformationVector* outputs)
{
  Times times;
  for (int port = 0; port < numberOfPorts; ++port)
  {
    for (int k = 0; k < inputs[port]->GetNumberOfInformationObjects(); ++k)
    {
      times.Add(inputs[port]->GetInformationObject(k));
    }
  }
  const std::vector<double> steps(times.Steps.begin(), times.Steps.end());
  for (int port = 0; times.AreAny && port < outputs->GetNumberOfInformationObjects(); ++port)
  {
    vtkInformation* output = outputs->GetInformationObject(port);
    output->Set(Pipeline::TIME_RANGE(), times.Range, 2);
    if (!steps.empty())
    {
      output->Set(Pipeline::TIME_STEPS(), steps.data(), static_cast<int>(steps.size()));
    }
  }
  return 1;
}

std::string CheckMesherParameters(const BitingMeshOptions& options)
{
  const SimplificationOptions& simplification = options.Simplification;
  const double phi = options.Phi;
  return FirstRefusal(
    { CheckSpacingParameters(options.Spacing), CheckMergeTolerance(options.Domain.MergeTolerance),
      CheckAtLeastZero("End Tolerance", options.Domain.EndTolerance),
      CheckAtLeastZero("Boundary Tolerance", simplification.Tolerance),
      CheckAtLeastZero("Corner Angle", simplification.CornerAngle),
      CheckAtLeastZero("Minimum Loop Size", simplification.MinimumLoopSize),
      CheckBitingConstant(options.BitingConstant),
      phi > 0.0 && phi <= 1.0 ? ""
                              : "Phi is " + Figure(phi, 6) + "; it must be above 0 and at most 1.",
      CheckMostBites(options.MaximumNumberOfBites),
      CheckMostVertices(options.MaximumNumberOfVertices) });
}

} // namespace biting
