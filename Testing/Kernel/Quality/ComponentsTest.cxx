// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Quality/Components.h"

#include <gtest/gtest.h>

namespace biting
{

TEST(Parts, AreOneOnceTheyAreJoined)
{
  Parts parts;
  const Id a = parts.Begin();
  const Id b = parts.Begin();
  const Id c = parts.Begin();
  EXPECT_EQ(parts.Count(), 3);
  EXPECT_EQ(parts.Join(b, c), b);
  EXPECT_EQ(parts.Join(c, b), b);
  EXPECT_EQ(parts.Count(), 2);
  EXPECT_EQ(parts.Join(NoId, c), b);
  EXPECT_EQ(parts.Join(c, a), a);
  EXPECT_EQ(parts.Count(), 1);
  EXPECT_EQ(parts.Size(), 3);
}

TEST(Parts, OfAnotherAreNumberedBehindThese)
{
  Parts parts;
  parts.Join(parts.Begin(), parts.Begin());
  Parts others;
  others.Begin();
  const Id second = others.Begin();
  others.Join(others.Begin(), second);
  parts.Append(others);
  EXPECT_EQ(parts.Size(), 5);
  EXPECT_EQ(parts.Count(), 3);
  EXPECT_EQ(parts.Join(NoId, 4), 3) << "what was joined still is";
}

TEST(ComponentSum, KeepsWhatConnectsTasks)
{
  ComponentSum sum;
  for (int task = 0; task < 3; ++task)
  {
    ComponentSum own;
    own.Components.Begin();
    own.Components.Begin();
    own.Links.push_back({ 1, 10 * task });
    sum.Join(own);
  }
  EXPECT_EQ(sum.Begins, (std::vector<Id>{ 0, 2, 4 }));
  EXPECT_EQ(sum.Components.Count(), 6);
  ASSERT_EQ(sum.Links.size(), 3u);
  EXPECT_EQ(sum.Links[2].Part, 5);
  EXPECT_EQ(sum.Links[2].Across, 20);
}

} // namespace biting
