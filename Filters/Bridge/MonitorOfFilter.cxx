// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "MonitorOfFilter.h"

#include "../vtkBitingCompat.h"
#include "vtkAlgorithm.h"

#include <algorithm> // for min

namespace biting
{

MonitorOfFilter::MonitorOfFilter(vtkAlgorithm* filter, int numberOfStages)
  : Filter(filter)
  , NumberOfStages(numberOfStages)
  , ReportTime(Clock::now())
{
}

bool MonitorOfFilter::Advance(double fraction)
{
  constexpr double LeastStep = 0.01;
  constexpr std::chrono::milliseconds LongestSilence(100);
  const int stage = std::min(std::max(this->Stage, 0), this->NumberOfStages - 1);
  const double progress = (stage + std::min(fraction, 1.0)) / this->NumberOfStages;
  const bool hasMoved = progress >= this->Reported + LeastStep;
  if (hasMoved || Clock::now() - this->ReportTime > LongestSilence)
  {
    this->Report(std::max(progress, this->Reported));
  }
  return !vtkBitingCompat::IsAborted(this->Filter);
}

void MonitorOfFilter::BeginStage(const char* text)
{
  ++this->Stage;
  this->Filter->SetProgressText(text);
  this->Report(this->Reported);
}

void MonitorOfFilter::Report(double progress)
{
  this->Reported = progress;
  this->ReportTime = Clock::now();
  this->Filter->UpdateProgress(progress);
}

} // namespace biting
