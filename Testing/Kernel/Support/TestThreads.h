// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingTestThreads_h
#define BitingTestThreads_h

#include "Base/Monitor.h"

#include <chrono> // for waiting
#include <future> // for threads
#include <vector> // for lists

namespace biting
{

/// So many threads, whatever the machine has. The calling thread looks after them every so often.
class TestThreads : public Executor
{
public:
  explicit TestThreads(
    int numberOfThreads, std::chrono::milliseconds betweenLooks = std::chrono::milliseconds(1))
    : Size(numberOfThreads)
    , BetweenLooks(betweenLooks)
  {
  }

  int NumberOfThreads() const override { return this->Size; }

  void Run(const std::function<void()>& work, const std::function<void()>& watch) override
  {
    std::vector<std::future<void>> threads;
    for (int k = 0; k < this->Size; ++k)
    {
      threads.push_back(std::async(std::launch::async, work));
    }
    for (const std::future<void>& thread : threads)
    {
      while (thread.wait_for(this->BetweenLooks) != std::future_status::ready)
      {
        watch();
      }
    }
  }

private:
  int Size;
  std::chrono::milliseconds BetweenLooks;
};

/// Shows nothing, never stops, and has threads.
class MonitorWithThreads : public SilentMonitor
{
public:
  explicit MonitorWithThreads(
    int numberOfThreads, std::chrono::milliseconds betweenLooks = std::chrono::milliseconds(1))
    : Workers(numberOfThreads, betweenLooks)
  {
  }

  Executor& Threads() override { return this->Workers; }

private:
  TestThreads Workers;
};

} // namespace biting

#endif
