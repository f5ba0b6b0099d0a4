// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Biting/BiteLists.h"

#include <gtest/gtest.h>

#include <vector> // for lists

namespace biting
{

namespace
{

std::vector<Id> BitesOf(const BiteLists& lists, Id list)
{
  std::vector<Id> bites;
  lists.Visit(list,
    [&bites](const BiteEntry& entry)
    {
      bites.push_back(entry.Bite);
      return false;
    });
  return bites;
}

} // namespace

TEST(BiteLists, GiveTheNewestFirst)
{
  BiteLists lists;
  Id heads[3] = { NoId, NoId, NoId };
  std::vector<Id> expected[3];
  for (Id bite = 0; bite < 20000; ++bite)
  {
    const int which = bite % 7 == 0 ? 1 : (bite % 5 == 0 ? 2 : 0);
    lists.Append({ 0.0f, 0.0f, 1.0f, bite }, heads[which]);
    expected[which].insert(expected[which].end(), bite);
  }
  for (int which = 0; which < 3; ++which)
  {
    const std::vector<Id> reversed(expected[which].rbegin(), expected[which].rend());
    EXPECT_EQ(BitesOf(lists, heads[which]), reversed);
  }
  EXPECT_TRUE(BitesOf(lists, NoId).empty());
}

TEST(BiteLists, AreVisitedUntilTrue)
{
  BiteLists lists;
  Id head = NoId;
  for (Id bite = 0; bite < 100; ++bite)
  {
    lists.Append({ 0.0f, 0.0f, 1.0f, bite }, head);
  }
  int count = 0;
  EXPECT_TRUE(lists.Visit(head,
    [&count](const BiteEntry& entry)
    {
      ++count;
      return entry.Bite == 60;
    }));
  EXPECT_EQ(count, 40);
}

TEST(BiteLists, ThatAreEmptiedLeaveTheOthersAsTheyAre)
{
  BiteLists lists;
  Id heads[2] = { NoId, NoId };
  for (Id bite = 0; bite < 1000; ++bite)
  {
    lists.Append({ 0.0f, 0.0f, 1.0f, bite }, heads[bite % 2]);
  }
  const std::vector<Id> before = BitesOf(lists, heads[1]);
  lists.Empty(heads[0]);
  EXPECT_EQ(heads[0], NoId);
  for (Id bite = 1000; bite < 3000; ++bite)
  {
    lists.Append({ 0.0f, 0.0f, 1.0f, bite }, heads[0]);
  }
  EXPECT_EQ(BitesOf(lists, heads[1]), before);
  const std::vector<Id> after = BitesOf(lists, heads[0]);
  ASSERT_EQ(after.size(), 2000u);
  EXPECT_EQ(after.front(), 2999);
  EXPECT_EQ(after.back(), 1000);
}

} // namespace biting
