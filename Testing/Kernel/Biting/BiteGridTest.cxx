// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Biting/BiteGrid.h"
#include "../Support/MeshShapes.h"
#include "Biting/BiteOutline.h"

#include <gtest/gtest.h>

#include <algorithm> // for is_sorted
#include <cstdint>   // for counts
#include <set>       // for what was visited

namespace biting
{

namespace
{

Box2 UnitBox()
{
  Box2 box;
  box.Add({ 0.0, 0.0 });
  box.Add({ 1.0, 1.0 });
  return box;
}

void AddBite(const Point2& center, const Point2& axis, double halfWidth, Bites& bites)
{
  bites.Centers.push_back(center);
  bites.Axes.push_back(axis);
  bites.HalfWidths.push_back(halfWidth);
  bites.Orders.push_back(bites.Size() - 1);
  bites.Phases.push_back(BitePhase::Interior);
}

/// Squares with half-widths from `least`, times up to `ratio`, about `focus` where it is small.
Bites RandomBites(int count, double least, double ratio, const Point2& focus, std::uint64_t seed)
{
  TestNumbers numbers(seed);
  Bites bites;
  for (int k = 0; k < count; ++k)
  {
    const double size = least * std::pow(ratio, numbers.Unit());
    const double distance = std::min(0.7, 20.0 * size * numbers.Unit());
    const Point2 center = focus + distance * UnitVector(DegreesPerTurn * numbers.Unit());
    const Point2 axis = k % 3 == 0 ? UnitVector(90.0 * numbers.Unit()) : Point2{ 1.0, 0.0 };
    AddBite(center, axis, size, bites);
  }
  return bites;
}

/// Every bite that holds p is found, also while the grid grows.
void CheckContaining(const Bites& bites, double expectedBites, std::uint64_t seed)
{
  BiteGrid grid(bites, UnitBox(), expectedBites);
  TestNumbers numbers(seed);
  for (Id filed = 0; filed < bites.Size(); ++filed)
  {
    grid.File(filed);
    const bool isProbed = filed % 50 == 0 || filed == bites.Size() - 1;
    for (int probe = 0; isProbed && probe < 20; ++probe)
    {
      const Id near = numbers.Below(filed + 1);
      const double reach = 1.5 * bites.HalfWidths[near];
      const Point2 p = bites.Centers[near] +
        Point2{ reach * (2.0 * numbers.Unit() - 1.0), reach * (2.0 * numbers.Unit() - 1.0) };
      std::vector<Id> visited;
      grid.VisitLeaf(p,
        [&visited](Id bite)
        {
          visited.push_back(bite);
          return false;
        });
      ASSERT_TRUE(std::is_sorted(visited.rbegin(), visited.rend()));
      const std::set<Id> found(visited.begin(), visited.end());
      ASSERT_EQ(found.size(), visited.size());
      for (Id bite = 0; bite <= filed; ++bite)
      {
        ASSERT_TRUE(Depth(bites, bite, p) < 0.0 || found.count(bite) > 0);
      }
    }
  }
}

TEST(BiteGrid, FindsEveryBiteThatHoldsAPoint)
{
  CheckContaining(RandomBites(1000, 0.02, 2.0, { 0.5, 0.5 }, 1), 1000.0, 2);
  CheckContaining(RandomBites(1000, 0.02, 2.0, { 0.5, 0.5 }, 3), 1.0, 4);
}

TEST(BiteGrid, FindsEveryBiteThatHoldsAPointWhereSpacingIsGraded)
{
  CheckContaining(RandomBites(1500, 1e-5, 1e4, { 0.3, 0.7 }, 5), 1000.0, 6);
  CheckContaining(RandomBites(1500, 1e-9, 1e8, { 1.0, 1.0 }, 7), 1500.0, 8);
}

TEST(BiteGrid, FindsEveryBiteThatHoldsAPointWhereTheyCrowd)
{
  CheckContaining(RandomBites(1500, 1e-4, 1.2, { 0.25, 0.25 }, 9), 100.0, 10);
}

// Crowds far larger than the cells that the grid begins with.
TEST(BiteGrid, FindsEveryBiteThatHoldsAPointWhereCellsWereTooSmall)
{
  CheckContaining(RandomBites(1500, 0.2, 1.5, { 0.5, 0.5 }, 19), 1500.0, 20);
}

/// In how many leaves the bites stand, each counted as often as it is filed.
std::int64_t CountEntries(const Bites& bites)
{
  BiteGrid grid(bites, UnitBox(), bites.Size());
  for (Id bite = 0; bite < bites.Size(); ++bite)
  {
    grid.File(bite);
  }
  std::int64_t filed = 0;
  grid.VisitSquare({ 0.5, 0.5 }, 1.0,
    [&filed](Id)
    {
      ++filed;
      return false;
    });
  return filed;
}

TEST(BiteGrid, FilesABiteInFewLeavesWhereTheyCrowd)
{
  const Bites bites = RandomBites(20000, 0.2, 1.5, { 0.5, 0.5 }, 21);
  EXPECT_LT(CountEntries(bites), 40 * bites.Size());
}

// Remeshing, fuzz seed 8011040: gigabytes.
TEST(BiteGrid, DoesNotCopyACrowdOfLargeBitesToEachOfTheTinyOnesAmongThem)
{
  TestNumbers numbers(22);
  Bites bites = RandomBites(1000, 0.2, 1.5, { 0.5, 0.5 }, 23);
  for (int k = 0; k < 1000; ++k)
  {
    AddBite({ numbers.Unit(), numbers.Unit() }, { 1.0, 0.0 }, 1e-10, bites);
  }
  EXPECT_LT(CountEntries(bites), 40 * bites.Size());
}

TEST(BiteGrid, FindsBitesBeyondItsBounds)
{
  Bites bites = RandomBites(500, 0.05, 3.0, { 1.1, -0.1 }, 11);
  CheckContaining(bites, 500.0, 12);
}

TEST(BiteGrid, DoesNotDivideForEverWhereBitesCoincide)
{
  Bites bites;
  for (int k = 0; k < 1000; ++k)
  {
    AddBite({ 0.5, 0.5 }, { 1.0, 0.0 }, 0.1, bites);
  }
  BiteGrid grid(bites, UnitBox(), 10.0);
  for (Id bite = 0; bite < bites.Size(); ++bite)
  {
    grid.File(bite);
  }
  int count = 0;
  grid.VisitLeaf({ 0.55, 0.45 },
    [&count](Id)
    {
      ++count;
      return false;
    });
  EXPECT_EQ(count, 1000);
}

TEST(BiteGrid, StopsVisitingALeafWhenTold)
{
  Bites bites;
  AddBite({ 0.5, 0.5 }, { 1.0, 0.0 }, 0.1, bites);
  AddBite({ 0.55, 0.5 }, { 1.0, 0.0 }, 0.1, bites);
  BiteGrid grid(bites, UnitBox(), 2.0);
  grid.File(0);
  grid.File(1);
  std::vector<Id> visited;
  const auto visit = [&visited](Id bite)
  {
    visited.push_back(bite);
    return true;
  };
  EXPECT_TRUE(grid.VisitLeaf({ 0.52, 0.5 }, visit));
  EXPECT_EQ(visited, std::vector<Id>{ 1 });
}

TEST(BiteGrid, VisitsOfALeafTheBitesAfterABirth)
{
  Bites bites;
  BiteGrid grid(bites, UnitBox(), 2.0);
  for (Id bite = 0; bite < 4; ++bite)
  {
    AddBite({ 0.5 + 0.01 * bite, 0.5 }, { 1.0, 0.0 }, 0.1, bites);
    grid.File(bite);
  }
  std::vector<Id> visited;
  const auto isSecond = [&visited](Id bite)
  {
    visited.push_back(bite);
    return bite == 1;
  };
  EXPECT_FALSE(grid.VisitLeaf({ 0.52, 0.5 }, isSecond, 1));
  EXPECT_EQ(visited, (std::vector<Id>{ 3, 2 }));
  EXPECT_TRUE(grid.VisitLeaf({ 0.52, 0.5 }, isSecond));
  EXPECT_EQ(visited, (std::vector<Id>{ 3, 2, 3, 2, 1 }));
}

TEST(BiteGrid, FindsEveryBiteThatMeetsASquare)
{
  const Bites bites = RandomBites(1500, 1e-4, 1e3, { 0.6, 0.4 }, 13);
  BiteGrid grid(bites, UnitBox(), 1500.0);
  for (Id bite = 0; bite < bites.Size(); ++bite)
  {
    grid.File(bite);
  }
  for (Id k = 0; k < bites.Size(); k += 5)
  {
    const double reach = bites.HalfWidths[k];
    std::set<Id> found;
    grid.VisitSquare(bites.Centers[k], reach,
      [&found](Id bite)
      {
        found.insert(bite);
        return false;
      });
    for (Id bite = 0; bite < bites.Size(); ++bite)
    {
      const Point2 offset = bites.Centers[bite] - bites.Centers[k];
      const double gap = std::max(std::abs(offset.X), std::abs(offset.Y));
      ASSERT_TRUE(gap > reach + bites.HalfWidths[bite] || found.count(bite) > 0);
    }
  }
}

Bites CirclesOf(Bites bites)
{
  bites.Axes.assign(bites.Axes.size(), Point2{});
  return bites;
}

TEST(BiteGrid, FindsEveryCircleThatHoldsAPoint)
{
  CheckContaining(CirclesOf(RandomBites(1000, 0.02, 2.0, { 0.5, 0.5 }, 14)), 1000.0, 15);
  CheckContaining(CirclesOf(RandomBites(1500, 1e-9, 1e8, { 1.0, 1.0 }, 16)), 1500.0, 17);
}

TEST(BiteGrid, FindsEveryBiteThatIsNear)
{
  constexpr double NearReach = 1.7;
  for (const bool areCircles : { false, true })
  {
    const Bites squares = RandomBites(1500, 1e-6, 1e5, { 0.6, 0.4 }, 18);
    const Bites bites = areCircles ? CirclesOf(squares) : squares;
    BiteGrid grid(bites, UnitBox(), 1500.0, NearReach);
    for (Id bite = 0; bite < bites.Size(); ++bite)
    {
      grid.File(bite);
    }
    for (const Point2& p : bites.Centers)
    {
      std::set<Id> found;
      grid.VisitNear(p, NearReach,
        [&found](Id bite)
        {
          found.insert(bite);
          return false;
        });
      for (Id bite = 0; bite < bites.Size(); ++bite)
      {
        const double reach = NearReach * bites.HalfWidths[bite];
        ASSERT_TRUE(Distance(p, bites.Centers[bite]) > reach || found.count(bite) > 0);
      }
    }
  }
}

} // namespace

} // namespace biting
