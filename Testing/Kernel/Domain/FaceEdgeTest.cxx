// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Domain/FaceEdge.h"

#include <gtest/gtest.h>

#include <algorithm> // for next_permutation, sort

namespace biting
{

namespace
{

FaceEdge EdgeOf(const std::vector<Id>& runs)
{
  FaceEdge edge;
  for (const Id run : runs)
  {
    edge.AddRun(run);
  }
  return edge;
}

/// The same in every order of runs: how many are left, and the odd pair.
void ExpectInAnyOrder(std::vector<Id> runs, Id count, std::pair<Id, Id> pair)
{
  std::sort(runs.begin(), runs.end());
  do
  {
    const FaceEdge edge = EdgeOf(runs);
    const auto [first, second] = edge.OddPair();
    EXPECT_EQ(edge.Count, count);
    EXPECT_EQ(std::min(first, second), pair.first);
    EXPECT_EQ(std::max(first, second), pair.second);
  } while (std::next_permutation(runs.begin(), runs.end()));
}

const Id BackOf0 = FaceEdge::OtherSide(0);
const Id BackOf2 = FaceEdge::OtherSide(2);
const Id BackOf4 = FaceEdge::OtherSide(4);

TEST(FaceEdge, LosesRunsThereAndBack)
{
  ExpectInAnyOrder({ 0, BackOf0 }, 0, { NoId, NoId });
  ExpectInAnyOrder({ 2, BackOf4, 0, BackOf0 }, 2, { 2, 4 });
  ExpectInAnyOrder({ 2, 4, 6, 8, BackOf2 }, 3, { NoId, NoId });
}

TEST(FaceEdge, LiesBetweenTheTwoFacesThatRunAlongItAnOddNumberOfTimes)
{
  ExpectInAnyOrder({ 2, BackOf4 }, 2, { 2, 4 });
  ExpectInAnyOrder({ 2, 2 }, 2, { NoId, NoId });
  ExpectInAnyOrder({ 2, BackOf4, 6, 6 }, 4, { 2, 4 });
  ExpectInAnyOrder({ 2, 2, 2, 4, 6, 6 }, 6, { 2, 4 });
  ExpectInAnyOrder({ 0, 2, 4, 6 }, 4, { NoId, NoId });
}

TEST(FaceEdge, AbsorbsWhatIsDirectedTheOtherWay)
{
  FaceEdge edge = EdgeOf({ 2, 4, 6, 8, 10 });
  edge.Absorb(EdgeOf({ 6, 10, 0, 4 }), true);
  EXPECT_EQ(edge.Count, 3);
  edge.Absorb(EdgeOf({ 0, 8 }), false);
  EXPECT_EQ(edge.Count, 3);
  EXPECT_EQ(edge.OddPair(), (std::pair<Id, Id>(NoId, NoId)));
  edge.AddRun(2);
  EXPECT_EQ(edge.Count, 4);
  EXPECT_EQ(edge.OddPair(), (std::pair<Id, Id>(NoId, NoId)));
}

} // namespace

} // namespace biting
