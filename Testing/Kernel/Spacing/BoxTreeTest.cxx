// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Spacing/BoxTree.h"

#include "../Support/Monitors.h"
#include "SpacingSources.h"

#include <gtest/gtest.h>

#include <limits> // for infinity
#include <set>    // for leaves

namespace
{

using namespace biting;

std::vector<BoxTree::Item> MakeItems(int count)
{
  Sampler sampler(3);
  std::vector<BoxTree::Item> items(static_cast<std::size_t>(count));
  for (BoxTree::Item& item : items)
  {
    const Point2 low = sampler.NextIn(UnitBox());
    item.Box = { low, low + 0.05 * sampler.NextIn(UnitBox()) };
    item.Value = 0.1 * sampler.Next();
  }
  return items;
}

BoxTree TreeOf(const std::vector<BoxTree::Item>& items)
{
  Pulse pulse(NoMonitor());
  return BoxTree(items, pulse);
}

double CostOf(const BoxTree::Item& item, const Point2& x, double slope)
{
  const Point2 nearest{ std::min(std::max(x.X, item.Box.Low.X), item.Box.High.X),
    std::min(std::max(x.Y, item.Box.Low.Y), item.Box.High.Y) };
  return item.Value + slope * Distance(x, nearest);
}

} // namespace

TEST(BoxTree, FindsTheItemOfTheLeastCost)
{
  for (const int count : { 1, 4, 5, 300 })
  {
    const std::vector<BoxTree::Item> items = MakeItems(count);
    const BoxTree tree = TreeOf(items);
    Sampler sampler(4);
    for (int probe = 0; probe < 300; ++probe)
    {
      const Point2 x = sampler.NextIn({ { -1.0, -1.0 }, { 2.0, 2.0 } });
      double least = std::numeric_limits<double>::infinity();
      for (const BoxTree::Item& item : items)
      {
        least = std::min(least, CostOf(item, x, 0.3));
      }
      double found = std::numeric_limits<double>::infinity();
      tree.Search(x, 0.3, found,
        [&](Id position, double)
        {
          const Id item = tree.Order()[static_cast<std::size_t>(position)];
          found = std::min(found, CostOf(items[static_cast<std::size_t>(item)], x, 0.3));
          return found;
        });
      ASSERT_EQ(found, least);
    }
  }
}

TEST(BoxTree, LooksAtFewItems)
{
  const std::vector<BoxTree::Item> items = MakeItems(20000);
  const BoxTree tree = TreeOf(items);
  int looks = 0;
  Sampler sampler(5);
  for (int probe = 0; probe < 100; ++probe)
  {
    const Point2 x = sampler.NextIn(UnitBox());
    double found = 0.002;
    tree.Search(x, 1.0, found,
      [&](Id position, double)
      {
        ++looks;
        const Id item = tree.Order()[static_cast<std::size_t>(position)];
        found = std::min(found, CostOf(items[static_cast<std::size_t>(item)], x, 1.0));
        return found;
      });
  }
  EXPECT_LE(looks, 100 * 100);
}

TEST(BoxTree, StopsWhereTheLimitIsZero)
{
  const BoxTree tree = TreeOf(MakeItems(300));
  int looks = 0;
  tree.Search({ 0.5, 0.5 }, 1.0, std::numeric_limits<double>::infinity(),
    [&looks](Id, double)
    {
      ++looks;
      return 0.0;
    });
  EXPECT_EQ(looks, 1);
}

/// Libraries may leave what nth_element parts in any order: within leaves it is that of ids.
TEST(BoxTree, HasAllItemsInAnOrderOfItsOwn)
{
  const std::vector<BoxTree::Item> items = MakeItems(7);
  const std::vector<Id> order = TreeOf(items).Order();
  ASSERT_EQ(order.size(), 7u);
  EXPECT_EQ(std::set<Id>(order.begin(), order.end()).size(), 7u);
  EXPECT_TRUE(std::is_sorted(order.begin(), order.begin() + 3));
  EXPECT_TRUE(std::is_sorted(order.begin() + 3, order.end()));
}

TEST(BoxTree, HasItsItemsInAnOrderWithShortWays)
{
  std::vector<BoxTree::Item> items(3000);
  for (std::size_t k = 0; k < items.size(); ++k)
  {
    items[k].Box.Add({ static_cast<double>(k * 1471 % 3000) / 3000.0, 0.5 });
  }
  double way = 0.0;
  Point2 last{ 0.0, 0.5 };
  const BoxTree tree = TreeOf(items);
  for (const Id item : tree.Order())
  {
    const Point2& next = items[static_cast<std::size_t>(item)].Box.Low;
    way += Distance(last, next);
    last = next;
  }
  EXPECT_LE(way, 5.0);
}

TEST(BoxTree, OfNothingFindsNothing)
{
  const auto fail = [](Id, double limit)
  {
    ADD_FAILURE();
    return limit;
  };
  TreeOf({}).Search({ 0.5, 0.5 }, 1.0, std::numeric_limits<double>::infinity(), fail);
  StoppingMonitor monitor(0);
  Pulse pulse(monitor);
  const BoxTree stopped(MakeItems(20000), pulse);
  EXPECT_TRUE(stopped.Order().empty());
  stopped.Search({ 0.5, 0.5 }, 1.0, std::numeric_limits<double>::infinity(), fail);
}
