// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Base/Problem.h"

#include <gtest/gtest.h>

namespace biting
{

TEST(ProblemList, CountsAllThatAGroupCountsAndKeepsTheFirst)
{
  constexpr std::int64_t Most = ProblemList::KeptPerKind;
  ProblemList found;
  for (std::int64_t k = 0; k < Most + 5; ++k)
  {
    found.Add({ ProblemCode::Folds, { k }, {}, "" });
  }
  ProblemList all;
  all.Add({ ProblemCode::Folds, { -1 }, {}, "" });
  all.Add(found.Groups().front());
  EXPECT_EQ(all.Count(ProblemCode::Folds), Most + 6);
  ASSERT_EQ(all.Groups().size(), 1u);
  EXPECT_EQ(all.Groups().front().First.size(), ProblemList::KeptPerKind);
  EXPECT_EQ(all.Groups().front().First[1].Ids.front(), 0);
}

} // namespace biting
