// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "InputTimes.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm> // for min, max
#include <set>       // for times
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

} // namespace biting
