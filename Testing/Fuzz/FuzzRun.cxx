// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "FuzzRun.h"

#include "../Kernel/Support/TestThreads.h"

#include <cstdint> // for counts

namespace biting
{

namespace
{

/// Says stop at a given call and ever after; remembers what it was told.
class StoppingMonitor : public MonitorWithThreads
{
public:
  StoppingMonitor(std::int64_t stopAtCall, int numberOfThreads)
    : MonitorWithThreads(numberOfThreads)
    , Rest(stopAtCall)
  {
  }

  bool Advance(double fraction) override
  {
    this->HasBadFraction = this->HasBadFraction || !(fraction >= 0.0 && fraction <= 1.0);
    this->SaidStop = this->SaidStop || this->Rest == 0;
    --this->Rest;
    return !this->SaidStop;
  }

  bool SaidStop = false;
  bool HasBadFraction = false;

private:
  std::int64_t Rest;
};

} // namespace

FuzzRun Run(const FuzzCase& fuzzCase, int numberOfThreads)
{
  FuzzRun run;
  StoppingMonitor monitor(fuzzCase.StopAtCall, numberOfThreads);
  run.Mesh = MakeBitingMesh(fuzzCase.Input, fuzzCase.Options, run.Problems, monitor);
  run.SaidStop = monitor.SaidStop;
  run.HasBadFraction = monitor.HasBadFraction;
  return run;
}

} // namespace biting
