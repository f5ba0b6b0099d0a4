// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Quality/PointTree.h"

#include "../Support/TestThreads.h"
#include "TestMesh.h"

#include <gtest/gtest.h>

#include <algorithm>  // for min
#include <functional> // for distributions

namespace
{

using biting::Dice;
using biting::Id;
using biting::Point2;
using biting::PointTree;

constexpr double FarAway = 1e30;

std::vector<PointTree::Item> MakeItems(int count, const std::function<Point2(Dice&)>& place)
{
  Dice dice(17);
  std::vector<PointTree::Item> items(static_cast<std::size_t>(count));
  for (Id name = 0; name < count; ++name)
  {
    items[static_cast<std::size_t>(name)] = { place(dice), name };
  }
  return items;
}

double NearestOfAll(const std::vector<PointTree::Item>& items, const Point2& place, Id name)
{
  double best = FarAway;
  for (const PointTree::Item& item : items)
  {
    const Point2 offset = item.Place - place;
    best = item.Name == name ? best : std::min(best, Dot(offset, offset));
  }
  return best;
}

void ExpectTruth(const std::vector<PointTree::Item>& items)
{
  biting::Pulse pulse(biting::NoMonitor());
  const PointTree tree(items, pulse);
  for (const PointTree::Item& item : items)
  {
    EXPECT_EQ(tree.NearestSquaredDistance(item.Place, item.Name, FarAway),
      NearestOfAll(items, item.Place, item.Name));
    const Point2 beside = item.Place + Point2{ 0.1, 0.2 };
    const double nearest = NearestOfAll(items, beside, biting::NoId);
    const PointTree::Item* found = tree.Nearest(beside, FarAway);
    ASSERT_TRUE(found);
    EXPECT_EQ(Dot(found->Place - beside, found->Place - beside), nearest);
    EXPECT_FALSE(tree.Nearest(beside, nearest));
  }
}

TEST(PointTree, FindsTheNearestOfUniformPoints)
{
  for (const int count : { 1, 2, 8, 9, 17, 500 })
  {
    ExpectTruth(MakeItems(count,
      [](Dice& dice) -> Point2
      {
        const double x = dice.Between(-1, 1);
        return { x, dice.Between(-1, 1) };
      }));
  }
}

TEST(PointTree, FindsTheNearestOfPointsOnALattice)
{
  ExpectTruth(MakeItems(500,
    [](Dice& dice) -> Point2
    {
      const double x = dice.Roll() % 8;
      return { x, static_cast<double>(dice.Roll() % 8) };
    }));
}

TEST(PointTree, FindsTheNearestOfClusters)
{
  ExpectTruth(MakeItems(500,
    [](Dice& dice) -> Point2
    {
      const double scale = 1.0 / (1 + dice.Roll() % 100000);
      const double x = scale * dice.Between(0, 1);
      return { x, scale };
    }));
}

TEST(PointTree, OfManyPointsIsBuiltOnThreads)
{
  const std::vector<PointTree::Item> items = MakeItems(100000,
    [](Dice& dice) -> Point2
    {
      const double x = dice.Between(-1, 1);
      return { x, x * dice.Between(-1, 1) };
    });
  for (const int threads : { 1, 3 })
  {
    biting::MonitorWithThreads monitor(threads);
    biting::Pulse pulse(monitor);
    const PointTree tree(items, pulse);
    for (std::size_t k = 0; k < items.size(); k += 997)
    {
      EXPECT_EQ(tree.NearestSquaredDistance(items[k].Place, items[k].Name, FarAway),
        NearestOfAll(items, items[k].Place, items[k].Name));
    }
  }
}

TEST(PointTree, FindsNothingNearerThanTheLimit)
{
  biting::Pulse pulse(biting::NoMonitor());
  const PointTree tree({ { { 0, 0 }, 0 }, { { 3, 4 }, 1 } }, pulse);
  EXPECT_EQ(tree.NearestSquaredDistance({ 0, 0 }, 0, 24.0), 24.0);
  EXPECT_EQ(tree.NearestSquaredDistance({ 0, 0 }, 0, 26.0), 25.0);
}

TEST(PointTree, FindsNothingAmongNothing)
{
  biting::Pulse pulse(biting::NoMonitor());
  EXPECT_EQ(PointTree({}, pulse).NearestSquaredDistance({ 0, 0 }, 0, 7.0), 7.0);
}

} // namespace
