// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Base/DisjointSets.h"

#include <gtest/gtest.h>

namespace biting
{

TEST(DisjointSets, AreCalledByTheirFirstItems)
{
  DisjointSets sets(5);
  EXPECT_EQ(sets.NumberOfSets(), 5u);
  EXPECT_EQ(sets.Unite(3, 4), 3);
  EXPECT_EQ(sets.Unite(4, 1), 1);
  EXPECT_EQ(sets.Unite(3, 1), 1);
  EXPECT_EQ(sets.NumberOfSets(), 3u);
  EXPECT_EQ(sets.SetOf(4), 1);
  EXPECT_EQ(sets.SizeOf(3), 3);
  EXPECT_EQ(sets.SizeOf(0), 1);
}

TEST(DisjointSets, OfOthersComeBehindThoseThatAreThere)
{
  DisjointSets sets;
  sets.Unite(sets.Add(), sets.Add());
  DisjointSets others(3);
  others.Unite(2, 1);
  sets.Append(others);
  EXPECT_EQ(sets.Size(), 5u);
  EXPECT_EQ(sets.NumberOfSets(), 3u);
  EXPECT_EQ(sets.SetOf(4), 3);
  EXPECT_EQ(sets.SizeOf(4), 2);
}

} // namespace biting
