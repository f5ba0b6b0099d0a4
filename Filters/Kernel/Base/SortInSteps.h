// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSortInSteps_h
#define BitingSortInSteps_h

#include "Pulse.h"
#include "Tasks.h"

#include <algorithm> // for merge, min, sort
#include <cstddef>   // for counts
#include <vector>    // for the items

namespace biting
{

/// Sorts `items` as std::sort does, but short runs of them, which are merged two by two, as tasks:
/// the monitor is asked between. Equal items come out in an order that depends on nothing but the
/// items. False, and the items are in no order, where the monitor wants to stop.
template <typename Item, typename Before>
bool SortInSteps(std::vector<Item>& items, const Before& isBefore, Pulse& pulse)
{
  constexpr std::size_t Run = 1u << 14;
  const std::size_t size = items.size();
  if (size <= Run)
  {
    std::sort(items.begin(), items.end(), isBefore);
    return pulse.Ask();
  }
  const PulsePart part(pulse, 0.0, 0.0);
  const auto placeIn = [size](std::vector<Item>& list, std::size_t place)
  { return list.begin() + static_cast<std::ptrdiff_t>(std::min(size, place)); };
  DoTasks(pulse, (size + Run - 1) / Run,
    [&items, &isBefore, &placeIn](std::size_t k, Monitor&)
    { std::sort(placeIn(items, k * Run), placeIn(items, (k + 1) * Run), isBefore); });
  std::vector<Item> merged(items);
  for (std::size_t run = Run; run < size && !pulse.HasStopped(); run *= 2)
  {
    DoTasks(pulse, (size + 2 * run - 1) / (2 * run),
      [&items, &isBefore, &placeIn, &merged, run](std::size_t k, Monitor&)
      {
        const auto first = placeIn(items, 2 * k * run);
        const auto middle = placeIn(items, (2 * k + 1) * run);
        const auto last = placeIn(items, (2 * k + 2) * run);
        std::merge(first, middle, middle, last, placeIn(merged, 2 * k * run), isBefore);
      });
    if (!pulse.HasStopped())
    {
      items.swap(merged);
    }
  }
  return !pulse.HasStopped();
}

} // namespace biting

#endif
