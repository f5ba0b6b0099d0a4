// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Spacing/GridInterpolator.h"

#include "Spacing/GridHoles.h"
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

} // namespace

TEST(GridInterpolator, IsExactOnALinearFieldWhateverItsNodes)
{
  for (double power : { 1.0, 2.0, 9.0 })
  {
    const GridInterpolator interpolate(Share(MakeGrid(37, 12, Plane, power)));
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
  const GridInterpolator interpolate(grid);
  for (std::size_t node = 0; node < grid->Values.size(); ++node)
  {
    ASSERT_EQ(interpolate({ grid->XNodes[node % 9], grid->YNodes[node / 9] }), grid->Values[node]);
  }
}

TEST(GridInterpolator, IsTheNearestBorderValueOutside)
{
  const GridInterpolator interpolate(Share(MakeGrid(5, 5, Plane)));
  Sampler sampler(5);
  for (int probe = 0; probe < 2000; ++probe)
  {
    const Point2 x = sampler.NextIn({ { -3.0, -3.0 }, { 4.0, 4.0 } });
    ASSERT_NEAR(interpolate(x), Plane(Clamped(x)), 1e-14);
  }
}

TEST(GridInterpolator, TakesASingleRowColumnOrNode)
{
  EXPECT_EQ(GridInterpolator(Share(GridSource{ { 0.0 }, { 0.0 }, { 3.0 } }))({ 7.0, -7.0 }), 3.0);
  const GridInterpolator row(Share(GridSource{ { 0.0, 2.0 }, { 5.0 }, { 1.0, 3.0 } }));
  EXPECT_EQ(row({ 1.0, -40.0 }), 2.0);
  const GridInterpolator column(Share(GridSource{ { 5.0 }, { 0.0, 2.0 }, { 1.0, 3.0 } }));
  EXPECT_EQ(column({ 40.0, 1.5 }), 2.5);
}

TEST(GridInterpolator, TakesRepeatedNodes)
{
  const GridInterpolator step(
    Share(GridSource{ { 0.0, 1.0, 1.0, 2.0 }, { 0.0 }, { 1.0, 1.0, 4.0, 4.0 } }));
  EXPECT_EQ(step({ 0.5, 0.0 }), 1.0);
  EXPECT_EQ(step({ 1.0, 0.0 }), 4.0);
  EXPECT_EQ(step({ 1.5, 0.0 }), 4.0);
}

TEST(FillHoles, SharesAGridWithoutHoles)
{
  const auto grid = Share(MakeGrid(3, 3, Plane));
  EXPECT_EQ(FillHoles(grid), grid);
}

TEST(FillHoles, GivesEachHoleTheValueOfANearestNode)
{
  Sampler sampler(6);
  GridSource grid = MakeGrid(
    23, 17, [](const Point2&) { return 1.0; }, 1.5);
  for (std::size_t node = 0; node < grid.Values.size(); ++node)
  {
    grid.Values[node] = sampler.Next() < 0.1 ? static_cast<double>(node + 1) : NotANumber;
  }
  const auto filled = FillHoles(Share(grid));
  const auto distance = [&grid](std::size_t a, std::size_t b)
  {
    return Distance(Point2{ grid.XNodes[a % 23], grid.YNodes[a / 23] },
      Point2{ grid.XNodes[b % 23], grid.YNodes[b / 23] });
  };
  for (std::size_t node = 0; node < grid.Values.size(); ++node)
  {
    const auto from = static_cast<std::size_t>(filled->Values[node]) - 1;
    ASSERT_EQ(grid.Values[from], filled->Values[node]);
    for (std::size_t other = 0; other < grid.Values.size(); ++other)
    {
      if (!std::isnan(grid.Values[other]))
      {
        ASSERT_LE(distance(node, from), distance(node, other) * (1.0 + 1e-12));
      }
    }
  }
}
