// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Base/Tasks.h"
#include "Support/TestThreads.h"

#include <gtest/gtest.h>

#include <atomic>    // for counts
#include <stdexcept> // for what tasks throw
#include <thread>    // for the calling thread

namespace biting
{

namespace
{

constexpr int ThreadCounts[] = { 1, 2, 3, 8 };

struct Sum
{
  double Value = 0.0;
  void Join(const Sum& other) { this->Value += other.Value; }
};

/// Asked from the thread that made it only; wants to stop from a given call on.
class Watch : public SilentMonitor
{
public:
  explicit Watch(int numberOfThreads, int callsUntilStop = 1 << 30)
    : Workers(numberOfThreads)
    , Calls(callsUntilStop)
  {
  }

  bool Advance(double fraction) override
  {
    EXPECT_EQ(std::this_thread::get_id(), this->Caller);
    EXPECT_GE(fraction, this->Fraction);
    EXPECT_LE(fraction, 1.0);
    this->Fraction = fraction;
    return this->Calls-- > 0;
  }

  Executor& Threads() override { return this->Workers; }

  double Fraction = 0.0;

private:
  TestThreads Workers;
  int Calls;
  std::thread::id Caller = std::this_thread::get_id();
};

} // namespace

TEST(Tasks, ThoseThatDifferAreDoneOnce)
{
  for (const int threads : ThreadCounts)
  {
    Watch watch(threads);
    Pulse pulse(watch);
    std::vector<int> numbers;
    double value = 0.0;
    EXPECT_TRUE(DoEach(pulse,
      { [&numbers](Pulse& own) { numbers.assign(100000, own.Ask() ? 7 : 0); },
        [&value](Pulse& own) { value += own.Ask() ? 1.0 : 0.0; } }));
    EXPECT_EQ(numbers, std::vector<int>(100000, 7));
    EXPECT_EQ(value, 1.0);
    EXPECT_EQ(watch.Fraction, 1.0);
  }
}

TEST(Tasks, EachIsDoneOnceAndTheMonitorHearsOfAll)
{
  for (const int threads : ThreadCounts)
  {
    Watch watch(threads);
    Pulse pulse(watch);
    std::vector<std::atomic<int>> calls(100);
    EXPECT_TRUE(DoTasks(pulse, calls.size(),
      [&calls](std::size_t k, Monitor& monitor)
      {
        ++calls[k];
        EXPECT_TRUE(monitor.Advance(0.5));
        EXPECT_EQ(monitor.Threads().NumberOfThreads() > 1, false);
      }));
    for (const std::atomic<int>& count : calls)
    {
      EXPECT_EQ(count, 1);
    }
    EXPECT_EQ(watch.Fraction, 1.0);
  }
}

TEST(Tasks, ATaskThatIsAloneHasTheThreads)
{
  Watch watch(3);
  Pulse pulse(watch);
  int threads = 0;
  DoTasks(pulse, 1,
    [&threads](std::size_t, Monitor& monitor) { threads = monitor.Threads().NumberOfThreads(); });
  EXPECT_EQ(threads, 3);
}

TEST(Tasks, AllStopWhereTheMonitorWantsTo)
{
  for (const int threads : ThreadCounts)
  {
    Watch watch(threads, 5);
    Pulse pulse(watch);
    EXPECT_FALSE(DoTasks(pulse, 20,
      [](std::size_t, Monitor& monitor)
      {
        while (monitor.Advance(0.0))
        {
        }
      }));
    EXPECT_TRUE(pulse.HasStopped());
    EXPECT_FALSE(DoTasks(pulse, 20, [](std::size_t, Monitor&) { ADD_FAILURE(); }));
  }
}

TEST(Tasks, WhatATaskThrowsComesToTheCaller)
{
  for (const int threads : ThreadCounts)
  {
    Watch watch(threads);
    Pulse pulse(watch);
    EXPECT_THROW(DoTasks(pulse, 50,
                   [](std::size_t k, Monitor&)
                   {
                     if (k == 30)
                     {
                       throw std::runtime_error("the task failed");
                     }
                   }),
      std::runtime_error);
  }
}

TEST(Tasks, SumsAreTheSameToTheLastBitForAnyNumberOfThreads)
{
  const auto sumOf = [](int threads)
  {
    Watch watch(threads);
    Pulse pulse(watch);
    return SumAtOnce(pulse, 7 * StepsPerTask + 11, Sum(),
      [](Sum& sum, std::size_t i) { sum.Value += 1.0 / (1.0 + static_cast<double>(i)); })
      .Value;
  };
  for (const int threads : ThreadCounts)
  {
    EXPECT_EQ(sumOf(threads), sumOf(1));
  }
}

TEST(Tasks, StepsAreDoneOnceOnAnyNumberOfThreads)
{
  for (const int threads : ThreadCounts)
  {
    Watch watch(threads);
    Pulse pulse(watch);
    std::vector<int> calls(3 * StepsPerTask + 1, 0);
    EXPECT_TRUE(ForEachAtOnce(pulse, calls.size(), [&calls](std::size_t i) { ++calls[i]; }));
    EXPECT_EQ(calls, std::vector<int>(calls.size(), 1));
  }
}

TEST(Tasks, RowsAreDoneOnceOnAnyNumberOfThreads)
{
  for (const int threads : ThreadCounts)
  {
    for (const std::size_t size : { std::size_t{ 0 }, std::size_t{ 7 }, 3 * StepsPerTask })
    {
      Watch watch(threads);
      Pulse pulse(watch);
      std::vector<int> calls(StepsPerTask / 2, 0);
      EXPECT_TRUE(ForRowsAtOnce(pulse, calls.size(), size,
        [&calls](std::size_t first, std::size_t last)
        {
          for (std::size_t row = first; row < last; ++row)
          {
            ++calls[row];
          }
        }));
      EXPECT_EQ(calls, std::vector<int>(calls.size(), 1));
    }
  }
}

TEST(Tasks, OneMayWaitForThoseBeforeItOnAnyNumberOfThreads)
{
  for (const int threads : ThreadCounts)
  {
    Watch watch(threads);
    Pulse pulse(watch);
    std::atomic<std::size_t> next{ 0 };
    EXPECT_TRUE(DoTasks(pulse, 100,
      [&next](std::size_t k, Monitor& monitor)
      {
        while (next != k && monitor.Advance(0.0))
        {
          std::this_thread::yield();
        }
        ++next;
      }));
    EXPECT_EQ(next, 100u);
  }
}

} // namespace biting
