// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Spacing/GridHoles.h"

#include "../Support/Monitors.h"
#include "SpacingSources.h"

#include <gtest/gtest.h>

namespace
{

using namespace biting;

double Value(const Point2& x)
{
  return 1.0 + x.X + 2.0 * x.Y;
}

} // namespace

TEST(GridHoles, AreFilledFromANodeThatIsNearlyTheNearest)
{
  Sampler sampler(3);
  for (double share : { 0.1, 0.5, 0.97 })
  {
    GridSource grid = MakeGrid(40, 30, Value, 1.5);
    const GridSource given = grid;
    for (std::size_t node = 1; node < grid.Values.size(); ++node)
    {
      grid.Values[node] = sampler.Next() < share ? NotANumber : grid.Values[node];
    }
    const auto filled = FillHoles(Share(grid));
    const auto place = [&grid](std::size_t node) {
      return Point2{ grid.XNodes[node % 40], grid.YNodes[node / 40] };
    };
    for (std::size_t node = 0; node < grid.Values.size(); ++node)
    {
      double nearest = 10.0;
      double found = 10.0;
      for (std::size_t other = 0; other < grid.Values.size(); ++other)
      {
        const double away = Distance(place(node), place(other));
        nearest = std::isnan(grid.Values[other]) ? nearest : std::min(nearest, away);
        found = grid.Values[other] == filled->Values[node] ? std::min(found, away) : found;
      }
      ASSERT_LE(found, 1.5 * nearest);
      ASSERT_TRUE(std::isnan(grid.Values[node]) || filled->Values[node] == given.Values[node]);
    }
  }
}

TEST(GridHoles, LeaveAGridWithoutThemAsItIs)
{
  const auto grid = Share(MakeGrid(5, 5, Value));
  EXPECT_EQ(FillHoles(grid), grid);
}

TEST(GridHoles, AreNotFilledWhereThatIsStopped)
{
  StoppingMonitor monitor(0);
  const auto holed = [](const Point2& x) { return x.X > 0.5 ? NotANumber : Value(x); };
  EXPECT_FALSE(FillHoles(Share(MakeGrid(200, 200, holed)), monitor));
}
