// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "ThreadsOfVtk.h"

#include "vtkSMPTools.h"

#include <algorithm> // for max
#include <chrono>    // for the time between two looks
#include <future>    // for the thread that starts the others
#include <mutex>     // for one at a time
#include <string>    // for the backend
#include <thread>    // for the number of cores

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

} // namespace biting
