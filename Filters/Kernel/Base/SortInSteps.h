// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSortInSteps_h
#define BitingSortInSteps_h

#include "Pulse.h"
#include "Tasks.h"

#include <algorithm> // for sort, merge, lower_bound
#include <cstddef>   // for counts
#include <vector>    // for the items

namespace biting
{

/// Sorts short runs of the items and merges them two by two, as tasks: std::sort of millions of
/// items takes seconds in which no monitor is asked.
template <typename Item, typename Before>
class StepwiseSorter
{
public:
  StepwiseSorter(std::vector<Item>& items, const Before& isBefore, Pulse& pulse)
    : Items(items)
    , IsBefore(isBefore)
    , Beats(pulse)
  {
  }

  bool Sort()
  {
    const std::size_t size = this->Items.size();
    if (size <= Run)
    {
      std::sort(this->Items.begin(), this->Items.end(), this->IsBefore);
      return this->Beats.Ask();
    }
    const PulsePart part(this->Beats, 0.0, 0.0);
    DoTasks(this->Beats, (size + Run - 1) / Run,
      [this, size](std::size_t k, Monitor&)
      { std::sort(this->At(k * Run), this->At(std::min(size, (k + 1) * Run)), this->IsBefore); });
    for (std::size_t run = Run; run < size && !this->Beats.HasStopped(); run *= 2)
    {
      this->MergeRuns(run);
    }
    return !this->Beats.HasStopped();
  }

private:
  static constexpr std::size_t Run = 1u << 14;

  auto At(std::size_t place) { return this->Items.begin() + static_cast<std::ptrdiff_t>(place); }

  // Makes sorted runs of twice the size.
  void MergeRuns(std::size_t run)
  {
    const std::size_t size = this->Items.size();
    this->Merged.resize(size, this->Items.front());
    DoTasks(this->Beats, (size + 2 * run - 1) / (2 * run),
      [this, size, run](std::size_t k, Monitor& monitor)
      {
        const std::size_t begin = 2 * run * k;
        const std::size_t middle = std::min(size, begin + run);
        Pulse own(monitor);
        this->MergePair(begin, middle, std::min(size, middle + run), own);
      });
    if (!this->Beats.HasStopped())
    {
      this->Items.swap(this->Merged);
    }
  }

  // Merges a part of the first run, and what comes before its end of the second, at a time.
  void MergePair(std::size_t begin, std::size_t middle, std::size_t end, Pulse& pulse)
  {
    std::size_t second = middle;
    auto next = this->Merged.begin() + static_cast<std::ptrdiff_t>(begin);
    for (std::size_t first = begin; first < middle && pulse.Ask(); first += Run)
    {
      const std::size_t last = std::min(middle, first + Run);
      const bool isEnd = last == middle;
      const auto stop = isEnd
        ? this->At(end)
        : std::lower_bound(this->At(second), this->At(end), *this->At(last - 1), this->IsBefore);
      next =
        std::merge(this->At(first), this->At(last), this->At(second), stop, next, this->IsBefore);
      second = static_cast<std::size_t>(stop - this->Items.begin());
    }
  }

  std::vector<Item>& Items;
  const Before& IsBefore;
  Pulse& Beats;
  std::vector<Item> Merged;
};

/// Sorts `items` as std::sort does, asking the monitor every few thousand of them; equal items come
/// out in an order that depends on nothing but the items. False, and the items are in no order,
/// where the monitor wants to stop.
template <typename Item, typename Before>
bool SortInSteps(std::vector<Item>& items, const Before& isBefore, Pulse& pulse)
{
  return StepwiseSorter<Item, Before>(items, isBefore, pulse).Sort();
}

} // namespace biting

#endif
