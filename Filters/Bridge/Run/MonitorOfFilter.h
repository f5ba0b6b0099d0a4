// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingMonitorOfFilter_h
#define BitingMonitorOfFilter_h

#include "../../Kernel/Base/Monitor.h"
#include "../../vtkBitingCompat.h" // for the ABI namespace

#include <chrono>     // for the time of the last report
#include <cstddef>    // for the number of the stage
#include <functional> // for who else may stop it
#include <utility>    // for move
#include <vector>     // for shares

VTK_ABI_NAMESPACE_BEGIN
class vtkAlgorithm;
VTK_ABI_NAMESPACE_END

namespace biting
{

/// Threads through vtkSMPTools: by its backend, or STDThread for the time of a call where that is
/// Sequential. The calling thread watches meanwhile. Calls of several filters at once wait for each
/// other; within a parallel scope of others no thread is started.
class ThreadsOfVtk : public Executor
{
public:
  /// 0: as many as the machine has cores, for this process. 1: none is started.
  explicit ThreadsOfVtk(int numberOfThreads);

  int NumberOfThreads() const override { return this->Size; }
  void Run(const std::function<void()>& work, const std::function<void()>& watch) override;

private:
  int Size;
};

/// Shows stages as progress text and progress of a filter, and asks the filter whether to stop.
/// Once the filter has asked to stop, all later answers are the same.
/// Progress is reported when it has moved by one percent or when a tenth of a second has passed.
class MonitorOfFilter : public Monitor
{
public:
  /// `shares` of the whole that the stages take, in their order; their sum is 1. The number of
  /// threads is as in ThreadsOfVtk.
  MonitorOfFilter(vtkAlgorithm* filter, std::vector<double> shares, int numberOfThreads);

  bool Advance(double fraction) override;
  void BeginStage(const char* text) override;
  Executor& Threads() override { return this->Workers; }

  /// Adds a question that stops the run where it is answered with true.
  void StopWhere(std::function<bool()> isUnwanted) { this->IsUnwanted = std::move(isUnwanted); }

  bool HasStopped() const { return this->Stopped; }

private:
  using Clock = std::chrono::steady_clock;

  double ShareOfStage() const;
  void Report(double progress);

  vtkAlgorithm* Filter;
  ThreadsOfVtk Workers;
  std::vector<double> Shares;
  std::size_t NextStage = 0;
  double Begin = 0.0; ///< progress where the stage begins
  double Reported = 0.0;
  Clock::time_point ReportTime;
  bool Stopped = false;
  std::function<bool()> IsUnwanted; ///< may be none
};

} // namespace biting

#endif
