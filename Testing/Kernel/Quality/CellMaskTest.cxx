// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Quality/CellMask.h"

#include <gtest/gtest.h>

#include <cmath>  // for sqrt
#include <random> // for places
#include <vector> // for points

namespace biting
{

namespace
{

std::vector<Point2> RandomPoints(std::size_t count)
{
  std::mt19937 random(5);
  std::vector<Point2> points;
  for (std::size_t k = 0; k < count; ++k)
  {
    const double x = static_cast<double>(random() % 10000);
    points.push_back({ 1e-3 * x - 4.0, 2e-4 * static_cast<double>(random() % 10000) + 7.0 });
  }
  return points;
}

} // namespace

TEST(CellMask, ContainsAllThatIsInTheDiscsAndNotEverything)
{
  const std::vector<Point2> points = RandomPoints(4000);
  constexpr double Radius = 0.11;
  Pulse pulse(NoMonitor());
  CellMask cells(points, 20, pulse);
  for (std::size_t k = 0; k < 20; ++k)
  {
    cells.Add(points[k], Radius);
  }
  ASSERT_FALSE(cells.IsFull());
  std::size_t outside = 0;
  for (const Point2& point : points)
  {
    bool isInDisc = false;
    for (std::size_t k = 0; k < 20; ++k)
    {
      isInDisc = isInDisc || Distance(point, points[k]) <= Radius;
    }
    EXPECT_TRUE(cells.Contains(point) || !isInDisc);
    outside += cells.Contains(point) ? 0 : 1;
  }
  EXPECT_GT(outside, points.size() / 2);
}

TEST(CellMask, DiscsThatReachIntoThePointsFromOutsideCount)
{
  Pulse pulse(NoMonitor());
  CellMask cells({ { 0.0, 0.0 }, { 1.0, 0.0 }, { 0.0, 1.0 }, { 1.0, 1.0 } }, 1, pulse);
  cells.Add({ 1.5, 1.5 }, 0.8);
  EXPECT_TRUE(cells.Contains({ 1.0, 1.0 }));
  EXPECT_FALSE(cells.Contains({ 0.0, 0.0 }));
}

/// Wide discs of many cost no more than all points do.
TEST(CellMask, IsFullWhereDiscsHaveMoreCellsThanThereArePoints)
{
  const std::vector<Point2> points = RandomPoints(1000);
  Pulse pulse(NoMonitor());
  CellMask cells(points, 10, pulse);
  for (std::size_t k = 0; k < 10; ++k)
  {
    cells.Add(points[k], 20.0);
  }
  EXPECT_TRUE(cells.IsFull());
}

TEST(CellMask, PointsAtOnePlaceHaveOneCell)
{
  Pulse pulse(NoMonitor());
  CellMask cells({ { 2.0, 3.0 }, { 2.0, 3.0 } }, 1, pulse);
  EXPECT_FALSE(cells.Contains({ 2.0, 3.0 }));
  cells.Add({ 2.0, 3.0 }, 0.0);
  EXPECT_TRUE(cells.Contains({ 2.0, 3.0 }));
}

} // namespace biting
