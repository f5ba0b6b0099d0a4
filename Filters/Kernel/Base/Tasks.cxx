// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Tasks.h"

#include "Monitor.h"

#include <atomic>    // for what threads share
#include <exception> // for what tasks throw
#include <mutex>     // for the same

namespace biting
{

namespace
{

// The tasks of one call, as the threads see them.
class TaskList
{
public:
  TaskList(std::size_t count, const Task& task)
    : Body(task)
    , Fractions(count)
  {
  }

  void Work(); ///< takes tasks up until none is left; from any thread

  bool IsStopped() const { return this->Stopped.load(std::memory_order_relaxed); }
  void Stop() { this->Stopped.store(true, std::memory_order_relaxed); }
  void SetFraction(std::size_t k, double fraction)
  {
    this->Fractions[k].store(fraction, std::memory_order_relaxed);
  }
  double Fraction() const; ///< of all that is to be done
  void ThrowAgain() const;

private:
  void Do(std::size_t k);
  void Remember(std::size_t k);

  const Task& Body;
  std::vector<std::atomic<double>> Fractions;
  std::atomic<std::size_t> Next{ 0 };
  std::atomic<bool> Stopped{ false };
  std::mutex Failing;
  std::exception_ptr Failure;
  std::size_t FailedTask = 0;
};

// What a task tells, and is told.
class TaskMonitor : public SilentMonitor
{
public:
  TaskMonitor(TaskList& list, std::size_t k)
    : List(list)
    , K(k)
  {
  }

  bool Advance(double fraction) override
  {
    this->List.SetFraction(this->K, fraction);
    return !this->List.IsStopped();
  }

private:
  TaskList& List;
  std::size_t K;
};

void TaskList::Work()
{
  for (std::size_t k = this->Next++; k < this->Fractions.size() && !this->IsStopped();
       k = this->Next++)
  {
    this->Do(k);
  }
}

void TaskList::Do(std::size_t k)
{
  try
  {
    TaskMonitor monitor(*this, k);
    this->Body(k, monitor);
    this->SetFraction(k, 1.0);
  }
  catch (...)
  {
    this->Remember(k);
    this->Stop();
  }
}

void TaskList::Remember(std::size_t k)
{
  const std::lock_guard<std::mutex> lock(this->Failing);
  if (!this->Failure || k < this->FailedTask)
  {
    this->Failure = std::current_exception();
    this->FailedTask = k;
  }
}

double TaskList::Fraction() const
{
  double sum = 0.0;
  for (const std::atomic<double>& fraction : this->Fractions)
  {
    sum += fraction.load(std::memory_order_relaxed);
  }
  return sum / static_cast<double>(this->Fractions.size());
}

void TaskList::ThrowAgain() const
{
  if (this->Failure)
  {
    std::rethrow_exception(this->Failure);
  }
}

bool DoOnThreads(Pulse& pulse, std::size_t count, const Task& task)
{
  if (pulse.HasStopped())
  {
    return false;
  }
  TaskList list(count, task);
  const auto watch = [&pulse, &list]
  {
    pulse.SetFraction(list.Fraction());
    if (!pulse.Ask())
    {
      list.Stop();
    }
  };
  pulse.Threads().Run([&list] { list.Work(); }, watch);
  list.ThrowAgain();
  pulse.SetFraction(1.0);
  return pulse.Ask();
}

// The tasks of the calling thread ask the monitor themselves.
bool DoOneByOne(Pulse& pulse, std::size_t count, const Task& task)
{
  const double size = static_cast<double>(count);
  for (std::size_t k = 0; k < count && pulse.Ask(); ++k)
  {
    const PulsePart part(pulse, static_cast<double>(k) / size, static_cast<double>(k + 1) / size);
    PulseMonitor monitor(pulse);
    task(k, monitor);
    pulse.SetFraction(1.0);
  }
  return pulse.Ask();
}

} // namespace

bool DoTasks(Pulse& pulse, std::size_t count, const Task& task)
{
  const bool isAlone = count <= 1 || pulse.Threads().NumberOfThreads() == 1;
  return isAlone ? DoOneByOne(pulse, count, task) : DoOnThreads(pulse, count, task);
}

bool DoEach(Pulse& pulse, const std::vector<std::function<void(Pulse&)>>& tasks)
{
  return DoTasks(pulse, tasks.size(),
    [&tasks](std::size_t k, Monitor& monitor)
    {
      Pulse own(monitor);
      tasks[k](own);
    });
}

} // namespace biting
