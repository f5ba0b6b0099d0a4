// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Biting/CandidateQueue.h"
#include "../Support/PolylineShapes.h"

#include <gtest/gtest.h>

#include <algorithm> // for min_element, max_element
#include <deque>     // for the oracle

namespace biting
{

namespace
{

Candidate RandomCandidate(Id birth, TestNumbers& numbers)
{
  Candidate candidate;
  candidate.Place = { static_cast<double>(numbers.Below(50)),
    static_cast<double>(numbers.Below(50)) };
  candidate.Birth = birth;
  return candidate;
}

TEST(CandidateQueue, LayersComeFirstInFirstOut)
{
  CandidateQueue queue(FrontOrder::Layers);
  std::deque<Candidate> oracle;
  TestNumbers numbers(1);
  EXPECT_TRUE(queue.IsEmpty());
  for (Id step = 0; step < 60000; ++step)
  {
    const bool isGrowing = step % 20000 < 10000;
    if (oracle.empty() || numbers.Below(100) < (isGrowing ? 70 : 30))
    {
      oracle.push_back(RandomCandidate(step, numbers));
      queue.Put(oracle.back());
      continue;
    }
    const Candidate taken = queue.Take();
    ASSERT_EQ(taken.Birth, oracle.front().Birth);
    ASSERT_EQ(taken.Place, oracle.front().Place);
    oracle.pop_front();
    ASSERT_EQ(queue.IsEmpty(), oracle.empty());
  }
}

TEST(CandidateQueue, SweepTakesTheLargestY)
{
  CandidateQueue queue(FrontOrder::LargestY);
  std::vector<Candidate> oracle;
  TestNumbers numbers(2);
  for (Id step = 0; step < 2000; ++step)
  {
    if (oracle.empty() || numbers.Below(100) < (step < 1000 ? 70 : 20))
    {
      oracle.push_back(RandomCandidate(step, numbers));
      queue.Put(oracle.back());
      continue;
    }
    const auto next = std::max_element(oracle.begin(), oracle.end(),
      [](const Candidate& a, const Candidate& b)
      { return a.Place.Y != b.Place.Y ? a.Place.Y < b.Place.Y : a.Birth > b.Birth; });
    ASSERT_EQ(queue.Take().Birth, next->Birth);
    oracle.erase(next);
    ASSERT_EQ(queue.IsEmpty(), oracle.empty());
  }
}

TEST(CandidateQueue, SweepTakesTheSmallestXOfOneBirth)
{
  CandidateQueue queue(FrontOrder::LargestY);
  for (double x : { 3.0, 1.0, 2.0 })
  {
    Candidate candidate;
    candidate.Place = { x, 5.0 };
    candidate.Birth = 7;
    queue.Put(candidate);
  }
  EXPECT_EQ(queue.Take().Place.X, 1.0);
  EXPECT_EQ(queue.Take().Place.X, 2.0);
  EXPECT_EQ(queue.Take().Place.X, 3.0);
}

TEST(CandidateQueue, TakesTheBestClassAndTheOldestOfIt)
{
  CandidateQueue queue(FrontOrder::BestFirst);
  std::vector<Candidate> oracle;
  TestNumbers numbers(3);
  for (Id step = 0; step < 4000; ++step)
  {
    if (oracle.empty() || numbers.Below(100) < (step < 2000 ? 70 : 20))
    {
      oracle.push_back(RandomCandidate(step, numbers));
      oracle.back().Class = numbers.Below(RuleOf(FrontOrder::BestFirst).NumberOfClasses);
      queue.Put(oracle.back());
      continue;
    }
    const auto next = std::min_element(oracle.begin(), oracle.end(),
      [](const Candidate& a, const Candidate& b)
      { return a.Class != b.Class ? a.Class < b.Class : a.Birth < b.Birth; });
    ASSERT_EQ(queue.Take().Birth, next->Birth);
    oracle.erase(next);
    ASSERT_EQ(queue.IsEmpty(), oracle.empty());
  }
}

TEST(CandidateQueue, ClassesGrowWithTheMisfit)
{
  const CandidateQueue layers(FrontOrder::Layers);
  EXPECT_EQ(layers.ClassOf(0.0), 0);
  EXPECT_EQ(layers.ClassOf(0.2), 1);
  const CandidateQueue bestFirst(FrontOrder::BestFirst);
  int last = 0;
  for (double misfit = 0.0; misfit < 2.0; misfit += 0.01)
  {
    EXPECT_GE(bestFirst.ClassOf(misfit), last);
    last = bestFirst.ClassOf(misfit);
  }
  EXPECT_EQ(last, RuleOf(FrontOrder::BestFirst).NumberOfClasses - 1);
}

} // namespace

} // namespace biting
