// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "MonitorOfFilter.h"

#include "../../vtkBitingCompat.h"
#include "vtkAlgorithm.h"

#include <algorithm> // for clamp, max, min
#include <utility>   // for move

namespace biting
{

MonitorOfFilter::MonitorOfFilter(
  vtkAlgorithm* filter, std::vector<double> shares, int numberOfThreads)
  : Filter(filter)
  , Workers(numberOfThreads)
  , Shares(std::move(shares))
  , ReportTime(Clock::now())
{
}

MonitorOfFilter::MonitorOfFilter(vtkAlgorithm* filter, int numberOfStages)
  : MonitorOfFilter(
      filter, std::vector<double>(static_cast<std::size_t>(numberOfStages), 1.0 / numberOfStages))
{
}

bool MonitorOfFilter::Advance(double fraction)
{
  constexpr double LeastStep = 0.01;
  constexpr std::chrono::milliseconds LongestSilence(100);
  const double progress = this->Begin + this->ShareOfStage() * std::clamp(fraction, 0.0, 1.0);
  const bool hasMoved = progress >= this->Reported + LeastStep;
  if (hasMoved || Clock::now() - this->ReportTime > LongestSilence)
  {
    this->Report(progress);
  }
  this->Stopped = this->Stopped || vtkBitingCompat::IsAborted(this->Filter) ||
    (this->IsUnwanted && this->IsUnwanted());
  return !this->Stopped;
}

void MonitorOfFilter::BeginStage(const char* text)
{
  this->Begin += this->ShareOfStage();
  ++this->NextStage;
  this->Filter->SetProgressText(text);
  this->Report(this->Begin);
}

// 0 before the first stage and after the last.
double MonitorOfFilter::ShareOfStage() const
{
  const bool isKnown = this->NextStage > 0 && this->NextStage <= this->Shares.size();
  return isKnown ? this->Shares[this->NextStage - 1] : 0.0;
}

// Never less than before, and never more than 1, by rounding either.
void MonitorOfFilter::Report(double progress)
{
  this->Reported = std::min(std::max(progress, this->Reported), 1.0);
  this->ReportTime = Clock::now();
  this->Filter->UpdateProgress(this->Reported);
}

} // namespace biting
