// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingThreadsOfVtk_h
#define BitingThreadsOfVtk_h

#include "../../Kernel/Base/Executor.h"

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

} // namespace biting

#endif
