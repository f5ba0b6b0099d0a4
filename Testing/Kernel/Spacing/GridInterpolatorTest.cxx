// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Spacing/GridInterpolator.h"

#include "SpacingSources.h"

#include <gtest/gtest.h>

namespace
{

using namespace biting;

double Plane(const Point2& x)
{
  return 2.0 + 0.5 * x.X - 0.75 * x.Y;
}

Point2 Clamped(const Point2& x)
{
  return { std::min(std::max(x.X, 0.0), 1.0), std::min(std::max(x.Y, 0.0), 1.0) };
}

GridInterpolator Interpolator(const GridSource& grid)
{
  Pulse pulse(NoMonitor());
  return { Share(grid), UnitBox(), pulse };
}

} // namespace

TEST(GridInterpolator, IsExactOnALinearFieldWhateverItsNodes)
{
  for (double power : { 1.0, 2.0, 9.0 })
  {
    const GridInterpolator interpolate = Interpolator(MakeGrid(37, 12, Plane, power));
    Sampler sampler(3);
    for (int probe = 0; probe < 20000; ++probe)
    {
      const Point2 x = sampler.NextIn(UnitBox());
      ASSERT_NEAR(interpolate(x), Plane(x), 1e-14);
    }
  }
}

TEST(GridInterpolator, IsTheGivenValueAtEveryNode)
{
  Sampler sampler(4);
  const auto grid = Share(MakeGrid(
    9, 7, [&sampler](const Point2&) { return 1.0 + sampler.Next(); }, 1.7));
  const GridInterpolator interpolate = Interpolator(*grid);
  for (std::size_t node = 0; node < grid->Values.size(); ++node)
  {
    ASSERT_EQ(interpolate({ grid->XNodes[node % 9], grid->YNodes[node / 9] }), grid->Values[node]);
  }
}

TEST(GridInterpolator, IsTheNearestBorderValueOutside)
{
  const GridInterpolator interpolate = Interpolator(MakeGrid(5, 5, Plane));
  Sampler sampler(5);
  for (int probe = 0; probe < 2000; ++probe)
  {
    const Point2 x = sampler.NextIn({ { -3.0, -3.0 }, { 4.0, 4.0 } });
    ASSERT_NEAR(interpolate(x), Plane(Clamped(x)), 1e-14);
  }
}

TEST(GridInterpolator, TakesASingleRowColumnOrNode)
{
  EXPECT_EQ(Interpolator({ { 0.0 }, { 0.0 }, { 3.0 } })({ 7.0, -7.0 }), 3.0);
  EXPECT_EQ(Interpolator({ { 0.5 }, { 2.0 }, { 3.0 } })({ 0.2, 0.7 }), 3.0);
  const GridInterpolator row = Interpolator({ { 0.0, 2.0 }, { 5.0 }, { 1.0, 3.0 } });
  EXPECT_EQ(row({ 1.0, -40.0 }), 2.0);
  const GridInterpolator column = Interpolator({ { 5.0 }, { 0.0, 2.0 }, { 1.0, 3.0 } });
  EXPECT_EQ(column({ 40.0, 1.5 }), 2.5);
}

TEST(GridInterpolator, TakesRepeatedNodes)
{
  const GridInterpolator step =
    Interpolator({ { 0.0, 1.0, 1.0, 2.0 }, { 0.0 }, { 1.0, 1.0, 4.0, 4.0 } });
  EXPECT_EQ(step({ 0.5, 0.0 }), 1.0);
  EXPECT_EQ(step({ 1.0, 0.0 }), 4.0);
  EXPECT_EQ(step({ 1.5, 0.0 }), 4.0);
}

TEST(GridInterpolator, GivesEachHoleTheValueOfTheNearestNode)
{
  Sampler sampler(6);
  for (const double share : { 0.1, 0.5, 0.97 })
  {
    GridSource grid = MakeGrid(
      23, 17, [](const Point2&) { return 1.0; }, 1.5);
    std::vector<std::size_t> given;
    for (std::size_t node = 0; node < grid.Values.size(); ++node)
    {
      const bool isGiven = node == 0 || sampler.Next() > share;
      grid.Values[node] = isGiven ? static_cast<double>(node + 1) : NotANumber;
      given.insert(given.end(), isGiven ? 1 : 0, node);
    }
    const GridInterpolator interpolate = Interpolator(grid);
    const auto place = [&grid](std::size_t node) {
      return Point2{ grid.XNodes[node % 23], grid.YNodes[node / 23] };
    };
    for (std::size_t node = 0; node < grid.Values.size(); ++node)
    {
      const auto from = static_cast<std::size_t>(interpolate(place(node))) - 1;
      for (const std::size_t other : given)
      {
        ASSERT_LE(Distance(place(node), place(from)), Distance(place(node), place(other)));
      }
    }
  }
}
