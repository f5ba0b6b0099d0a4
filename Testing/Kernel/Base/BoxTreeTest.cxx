// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Base/BoxTree.h"

#include "../Support/Dice.h"
#include "../Support/Monitors.h"

#include <gtest/gtest.h>

#include <limits> // for infinity

namespace
{

using namespace biting;

const Box2 UnitBox{ { 0.0, 0.0 }, { 1.0, 1.0 } };

Point2 PlaceIn(const Box2& box, Dice& dice)
{
  const double u = dice.Unit();
  return { box.Low.X + u * box.Width(), box.Low.Y + dice.Unit() * box.Height() };
}

struct Item
{
  int Number;
  Box2 Place;
  double Value;

  const Box2& Box() const { return this->Place; }
  double Least() const { return this->Value; }
};

std::vector<Item> MakeItems(int count)
{
  Dice dice(3);
  std::vector<Item> items;
  for (int number = 0; number < count; ++number)
  {
    const Point2 low = PlaceIn(UnitBox, dice);
    const Box2 place{ low, low + 0.05 * PlaceIn(UnitBox, dice) };
    items.push_back({ number, place, 0.1 * dice.Unit() });
  }
  return items;
}

BoxTree<Item> TreeOf(const std::vector<Item>& items)
{
  Pulse pulse(NoMonitor());
  return BoxTree<Item>(items, pulse);
}

double CostOf(const Item& item, const Point2& x, double slope)
{
  const Point2 nearest{ std::min(std::max(x.X, item.Place.Low.X), item.Place.High.X),
    std::min(std::max(x.Y, item.Place.Low.Y), item.Place.High.Y) };
  return item.Value + slope * Distance(x, nearest);
}

} // namespace

TEST(BoxTree, FindsTheItemOfTheLeastCost)
{
  for (const int count : { 1, 4, 5, 300 })
  {
    const std::vector<Item> items = MakeItems(count);
    const BoxTree<Item> tree = TreeOf(items);
    Dice dice(4);
    for (int probe = 0; probe < 300; ++probe)
    {
      const Point2 x = PlaceIn({ { -1.0, -1.0 }, { 2.0, 2.0 } }, dice);
      double least = std::numeric_limits<double>::infinity();
      for (const Item& item : items)
      {
        least = std::min(least, CostOf(item, x, 0.3));
      }
      double found = std::numeric_limits<double>::infinity();
      tree.Search(x, 0.3, found,
        [&](const Item& item, double)
        {
          found = std::min(found, CostOf(item, x, 0.3));
          return found;
        });
      ASSERT_EQ(found, least);
    }
  }
}

TEST(BoxTree, LooksAtFewItems)
{
  const std::vector<Item> items = MakeItems(20000);
  const BoxTree<Item> tree = TreeOf(items);
  int looks = 0;
  Dice dice(5);
  for (int probe = 0; probe < 100; ++probe)
  {
    const Point2 x = PlaceIn(UnitBox, dice);
    double found = 0.002;
    tree.Search(x, 1.0, found,
      [&](const Item& item, double)
      {
        ++looks;
        found = std::min(found, CostOf(item, x, 1.0));
        return found;
      });
  }
  EXPECT_LE(looks, 100 * 100);
}

TEST(BoxTree, OfNothingFindsNothing)
{
  const auto fail = [](const Item&, double limit)
  {
    ADD_FAILURE();
    return limit;
  };
  TreeOf({}).Search({ 0.5, 0.5 }, 1.0, std::numeric_limits<double>::infinity(), fail);
  StoppingMonitor monitor(0);
  Pulse pulse(monitor);
  const BoxTree<Item> stopped(MakeItems(20000), pulse);
  EXPECT_TRUE(stopped.Items().empty());
  stopped.Search({ 0.5, 0.5 }, 1.0, std::numeric_limits<double>::infinity(), fail);
}
