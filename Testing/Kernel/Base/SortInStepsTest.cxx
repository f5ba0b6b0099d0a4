// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "../Support/Monitors.h"

#include "Base/SortInSteps.h"
#include "Support/TestThreads.h"

#include <gtest/gtest.h>

#include <cstdint>    // for random numbers
#include <functional> // for less

namespace biting
{

namespace
{

std::vector<int> RandomNumbers(std::size_t count, std::uint32_t bound)
{
  std::uint64_t state = 1;
  std::vector<int> numbers;
  for (std::size_t k = 0; k < count; ++k)
  {
    state = state * 6364136223846793005u + 1442695040888963407u;
    numbers.push_back(static_cast<int>((state >> 33) % bound));
  }
  return numbers;
}

TEST(SortInSteps, SortsAsStandardSortDoes)
{
  constexpr std::size_t Run = 1u << 14;
  for (const std::uint32_t bound : { 1u, 10u, 1000000u })
  {
    for (const std::size_t count : { std::size_t(0), std::size_t(1), Run - 1, Run, Run + 1, 2 * Run,
           2 * Run + 1, 3 * Run, 100001 + Run })
    {
      std::vector<int> numbers = RandomNumbers(count, bound);
      std::vector<int> expected = numbers;
      std::sort(expected.begin(), expected.end());
      Pulse pulse(NoMonitor());
      EXPECT_TRUE(SortInSteps(numbers, std::less<int>(), pulse));
      EXPECT_EQ(numbers, expected);
    }
  }
}

TEST(SortInSteps, EqualItemsHaveTheSameOrderOnAnyNumberOfThreads)
{
  struct Item
  {
    int Key;
    std::size_t Place;
  };
  const std::vector<int> keys = RandomNumbers(200000, 1000);
  std::vector<std::size_t> expected;
  for (const int threads : { 1, 2, 3, 8 })
  {
    std::vector<Item> items;
    for (std::size_t k = 0; k < keys.size(); ++k)
    {
      items.push_back({ keys[k], k });
    }
    MonitorWithThreads monitor(threads);
    Pulse pulse(monitor);
    EXPECT_TRUE(SortInSteps(
      items, [](const Item& a, const Item& b) { return a.Key < b.Key; }, pulse));
    std::vector<std::size_t> places;
    for (std::size_t k = 0; k < items.size(); ++k)
    {
      EXPECT_TRUE(k == 0 || items[k - 1].Key <= items[k].Key);
      places.push_back(items[k].Place);
    }
    expected = expected.empty() ? places : expected;
    EXPECT_EQ(places, expected);
  }
}

TEST(SortInSteps, StopsWhereverTheMonitorAsks)
{
  const std::vector<int> given = RandomNumbers(100000, 1000);
  for (int calls = 0; calls < 100; ++calls)
  {
    StoppingMonitor monitor(calls);
    Pulse pulse(monitor);
    std::vector<int> numbers = given;
    const bool isSorted = SortInSteps(numbers, std::less<int>(), pulse);
    EXPECT_EQ(isSorted, !monitor.HasStopped());
    EXPECT_EQ(isSorted, std::is_sorted(numbers.begin(), numbers.end()));
    EXPECT_EQ(numbers.size(), given.size());
    if (isSorted)
    {
      EXPECT_GT(calls, 6);
      return;
    }
  }
  FAIL() << "more calls than there are runs and merges";
}

} // namespace

} // namespace biting
