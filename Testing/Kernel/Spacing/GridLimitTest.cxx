// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Spacing/GridLimit.h"

#include "SpacingSources.h"

#include <gtest/gtest.h>

namespace
{

using namespace biting;

constexpr double Gradation = 0.3;

/// Distances to seven by seven holes, as a field that is limited to `slope` already.
Field AroundHoles(double slope)
{
  return [slope](const Point2& x)
  {
    const Point2 inCell{ 7.0 * x.X - std::floor(7.0 * x.X), 7.0 * x.Y - std::floor(7.0 * x.Y) };
    const double away = std::max(Length(inCell - Point2{ 0.5, 0.5 }) / 7.0 - 0.02, 0.0);
    return 0.003 + slope * away;
  };
}

struct Limited
{
  std::size_t Cones;
  double LargestChange; ///< of a node, relative
};

Limited LimitOf(const GridSource& grid)
{
  ConeCollector cones({ 1.0, 0.0, 1e9 });
  const auto limited = LimitGrid(Share(grid), Gradation, UnitBox(), cones, NoMonitor());
  Limited result{ cones.Segments().Segments.size() / 2, 0.0 };
  for (std::size_t node = 0; node < grid.Values.size(); ++node)
  {
    result.LargestChange =
      std::max(result.LargestChange, 1.0 - limited->Values[node] / grid.Values[node]);
  }
  return result;
}

} // namespace

TEST(GridLimit, KeepsAFieldThatIsAsSteepAsTheGradation)
{
  for (int nodes : { 257, 513, 769 })
  {
    const Limited limited = LimitOf(MakeGrid(nodes, nodes, AroundHoles(Gradation)));
    EXPECT_LE(limited.Cones, static_cast<std::size_t>(40 * nodes)) << nodes;
    EXPECT_LE(limited.LargestChange, 0.005) << nodes;
  }
}

TEST(GridLimit, KeepsAPlaneOfThatSlopeInAnyDirection)
{
  for (double angle = 0.0; angle < 6.3; angle += 0.1)
  {
    const Point2 slope{ Gradation * std::cos(angle), Gradation * std::sin(angle) };
    const Limited limited =
      LimitOf(MakeGrid(65, 65, [&slope](const Point2& x) { return 0.5 + Dot(slope, x); }));
    EXPECT_EQ(limited.Cones, 0u) << angle;
    EXPECT_EQ(limited.LargestChange, 0.0) << angle;
  }
}

/// Also between the directions of the sides and diagonals of cells.
TEST(GridLimit, LowersAPlaneThatIsALittleSteeperInAnyDirection)
{
  for (double angle = 0.0; angle < 6.3; angle += 0.1)
  {
    const Point2 along{ std::cos(angle), std::sin(angle) };
    const double slope = 1.03 * Gradation;
    const Limited limited = LimitOf(MakeGrid(65, 65,
      [&along, slope](const Point2& x) {
        return 0.7 + slope * Dot(along, x - Point2{ 0.5, 0.5 });
      }));
    EXPECT_GT(limited.LargestChange, 0.005) << angle;
    EXPECT_LT(limited.LargestChange, 0.03) << angle;
  }
}

TEST(GridLimit, HasNodesOutsideAsFarAsTheBoundsReach)
{
  ConeCollector cones({ 1.0, 0.0, 1e9 });
  const auto steep = [](const Point2& x) { return 0.1 + 2.0 * x.Y; };
  const auto limited = LimitGrid(
    Share(MakeGrid(5, 5, steep)), Gradation, { { -1.0, 0.5 }, { 3.0, 2.0 } }, cones, NoMonitor());
  EXPECT_EQ(limited->XNodes.front(), -1.0);
  EXPECT_EQ(limited->XNodes.back(), 3.0);
  EXPECT_EQ(limited->YNodes.front(), 0.0);
  EXPECT_EQ(limited->YNodes.back(), 2.0);
  EXPECT_EQ(limited->Values.size(), 7u * 6u);
}
