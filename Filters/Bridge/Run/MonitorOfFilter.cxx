// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "MonitorOfFilter.h"

#include "../../vtkBitingCompat.h"

#include "vtkAlgorithm.h"
#include "vtkSMPTools.h"

#include <algorithm> // for max
#include <chrono>    // for the time between two looks
#include <future>    // for the thread that starts the others
#include <mutex>     // for one at a time
#include <string>    // for the backend
#include <thread>    // for the number of cores
#include <utility>   // for move

namespace biting
{

namespace
{

constexpr std::chrono::milliseconds BetweenLooks(20);

int SizeOf(int numberOfThreads)
{
  if (vtkSMPTools::IsParallelScope())
  {
    return 1;
  }
  return numberOfThreads > 0 ? numberOfThreads
                             : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

std::string Backend()
{
  const std::string backend = vtkSMPTools::GetBackend();
  return backend == "Sequential" ? "STDThread" : backend;
}

// The backend is one for the process.
void WorkAtOnce(int numberOfThreads, const std::function<void()>& work)
{
  static std::mutex oneAtATime;
  const std::lock_guard<std::mutex> lock(oneAtATime);
  vtkSMPTools::LocalScope(vtkSMPTools::Config(numberOfThreads, Backend(), false),
    [numberOfThreads, &work]
    {
      const auto call = [&work](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType k = begin; k < end; ++k)
        {
          work();
        }
      };
      vtkSMPTools::For(0, numberOfThreads, 1, call);
    });
}

} // namespace

ThreadsOfVtk::ThreadsOfVtk(int numberOfThreads)
  : Size(SizeOf(numberOfThreads))
{
}

// vtkSMPTools keeps the thread that calls it until all is done.
void ThreadsOfVtk::Run(const std::function<void()>& work, const std::function<void()>& watch)
{
  if (this->Size == 1)
  {
    work();
    return;
  }
  const std::future<void> all =
    std::async(std::launch::async, [this, &work] { WorkAtOnce(this->Size, work); });
  while (all.wait_for(BetweenLooks) != std::future_status::ready)
  {
    watch();
  }
}

MonitorOfFilter::MonitorOfFilter(
  vtkAlgorithm* filter, std::vector<double> shares, int numberOfThreads)
  : Filter(filter)
  , Workers(numberOfThreads)
  , Shares(std::move(shares))
  , ReportTime(Clock::now())
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
