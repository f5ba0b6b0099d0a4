// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingTasks_h
#define BitingTasks_h

#include "Monitor.h"
#include "Pulse.h"

#include <algorithm>  // for max, min
#include <cstddef>    // for counts
#include <functional> // for tasks
#include <utility>    // for move
#include <vector>     // for parts of sums, and tasks

namespace biting
{

/// One of the tasks 0 .. count - 1. Its monitor has no threads to give, where there are other
/// tasks.
using Task = std::function<void(std::size_t, Monitor&)>;

/// Does all tasks, each once, on the threads of the pulse's monitor; they are all of the part at
/// hand. They are begun in their order and end in any. What they read none of them may write, and
/// no two may write the same. The monitor is asked by the calling thread only. What tasks throw is
/// thrown again here, once none runs any more: that of the first task in their order of those that
/// have thrown. False, and tasks are left undone or stopped on their way, where the monitor wants
/// to stop.
bool DoTasks(Pulse& pulse, std::size_t count, const Task& task);

/// The same for tasks that differ; each gets a pulse of its own.
bool DoEach(Pulse& pulse, const std::vector<std::function<void(Pulse&)>>& tasks);

/// How many cheap steps are a task: their time is far above that of taking it up. It decides what
/// sums are, and so does not depend on the number of threads.
constexpr std::size_t StepsPerTask = 1u << 15;

/// Pulse::ForEach on the threads of its monitor, in any order: step(i) writes what only it does.
template <typename Step>
bool ForEachAtOnce(Pulse& pulse, std::size_t count, const Step& step)
{
  if (count <= StepsPerTask || pulse.Threads().NumberOfThreads() == 1)
  {
    return pulse.ForEach(count, step);
  }
  return DoTasks(pulse, (count + StepsPerTask - 1) / StepsPerTask,
    [count, &step](std::size_t k, Monitor&)
    {
      const std::size_t end = std::min(count, (k + 1) * StepsPerTask);
      for (std::size_t i = k * StepsPerTask; i < end; ++i)
      {
        step(i);
      }
    });
}

/// Does rows(begin, end) for ranges of the rows 0 .. count - 1, of `size` cheap steps each, on the
/// threads of the pulse's monitor: it writes what only these rows do. Which ranges does not depend
/// on the number of threads.
template <typename Rows>
bool ForRowsAtOnce(Pulse& pulse, std::size_t count, std::size_t size, const Rows& rows)
{
  const std::size_t rowsPerTask = std::max<std::size_t>(StepsPerTask / (size + 1), 1);
  return DoTasks(pulse, (count + rowsPerTask - 1) / rowsPerTask,
    [count, rowsPerTask, &rows](std::size_t k, Monitor&)
    { rows(k * rowsPerTask, std::min(count, (k + 1) * rowsPerTask)); });
}

/// Adds up over i = 0 .. count - 1 on the threads of the pulse's monitor: add(sum, i) for the steps
/// of each task in their order, to a sum that begins as a copy of `zero`, then sum.Join(next) for
/// the tasks in their order. The same rounding whatever the number of threads.
template <typename Sum, typename Add>
Sum SumAtOnce(Pulse& pulse, std::size_t count, const Sum& zero, const Add& add)
{
  // Each task adds to a sum on its own stack: those in the list share cache lines.
  std::vector<Sum> sums((count + StepsPerTask - 1) / StepsPerTask, zero);
  if (count <= StepsPerTask || pulse.Threads().NumberOfThreads() == 1)
  {
    for (std::size_t k = 0; k < sums.size(); ++k)
    {
      const std::size_t begin = k * StepsPerTask;
      const std::size_t end = std::min(count, begin + StepsPerTask);
      const double all = static_cast<double>(count);
      const PulsePart part(pulse, static_cast<double>(begin) / all, static_cast<double>(end) / all);
      Sum sum = zero;
      pulse.ForEach(end - begin, [&sum, &add, begin](std::size_t i) { add(sum, begin + i); });
      sums[k] = std::move(sum);
    }
  }
  else
  {
    DoTasks(pulse, sums.size(),
      [count, &sums, &zero, &add](std::size_t k, Monitor&)
      {
        Sum sum = zero;
        const std::size_t end = std::min(count, (k + 1) * StepsPerTask);
        for (std::size_t i = k * StepsPerTask; i < end; ++i)
        {
          add(sum, i);
        }
        sums[k] = std::move(sum);
      });
  }
  Sum whole = zero;
  for (const Sum& sum : sums)
  {
    whole.Join(sum);
  }
  return whole;
}

} // namespace biting

#endif
