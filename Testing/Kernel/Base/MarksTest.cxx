// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "../Support/TestThreads.h"

#include "Base/Marks.h"
#include "Base/Tasks.h"

#include <gtest/gtest.h>

namespace biting
{

TEST(Marks, AreZeroUntilTheyAreSetFromAnyThread)
{
  constexpr std::size_t Size = 5 * StepsPerTask;
  Marks marks(Size);
  EXPECT_EQ(marks.Size(), Size);
  MonitorWithThreads monitor(4);
  Pulse pulse(monitor);
  // Each mark is set twice, by different tasks.
  ForEachAtOnce(pulse, Size, [&marks](std::size_t k) { marks.Set(2 * k % Size / 2 * 2, 3); });
  for (std::size_t k = 0; k < Size; ++k)
  {
    ASSERT_EQ(marks[k], k % 2 == 0 ? 3 : 0) << k;
  }
}

} // namespace biting
