// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Delaunay/SpatialOrder.h"

#include "Delaunay/Scene.h"

#include <gtest/gtest.h>

#include <numeric> // for iota

namespace
{

using namespace biting;

void ExpectPermutation(std::vector<Id> order, std::size_t size)
{
  std::sort(order.begin(), order.end());
  std::vector<Id> all(size);
  std::iota(all.begin(), all.end(), 0);
  EXPECT_EQ(order, all);
}

std::vector<Id> SpatialOrder(const std::vector<Point2>& points)
{
  Pulse pulse(NoMonitor());
  return biting::SpatialOrder(points, pulse);
}

double MeanStep(const std::vector<Point2>& points, const std::vector<Id>& order)
{
  double sum = 0.0;
  for (std::size_t i = 1; i < order.size(); ++i)
  {
    sum += Distance(points[order[i - 1]], points[order[i]]);
  }
  return sum / static_cast<double>(order.size() - 1);
}

} // namespace

TEST(SpatialOrder, IsAPermutationForAnySize)
{
  for (const int count : { 0, 1, 2, 3, 63, 64, 65, 1000, 5000, 20000 })
  {
    ExpectPermutation(
      SpatialOrder(RandomPoints(count, 100000, 1)), static_cast<std::size_t>(count));
  }
}

TEST(SpatialOrder, IsAPermutationWherePointsCoincideOrAlign)
{
  std::vector<Point2> points(500, Point2{ 3.0, 4.0 });
  ExpectPermutation(SpatialOrder(points), 500);
  for (int i = 0; i < 500; ++i)
  {
    points.push_back({ 3.0, static_cast<double>(i) });
  }
  ExpectPermutation(SpatialOrder(points), 1000);
}

TEST(SpatialOrder, HasStepsOfTheLengthOfTheSpacing)
{
  const int size = 1 << 20;
  const std::vector<Point2> points = RandomPoints(20000, size, 2);
  const double spacing = size / std::sqrt(20000.0);
  EXPECT_LT(MeanStep(points, SpatialOrder(points)), 2.0 * spacing);
}

TEST(SpatialOrder, HasShortStepsInATinyCluster)
{
  std::vector<Point2> points = RandomPoints(20000, 1 << 20, 3);
  for (std::size_t i = 0; i < 19000; ++i)
  {
    points[i] = 1e-9 * points[i];
  }
  const std::vector<Id> order = SpatialOrder(points);
  double sum = 0.0;
  for (std::size_t i = 1; i < order.size(); ++i)
  {
    const bool isInCluster = order[i] < 19000 && order[i - 1] < 19000;
    sum += isInCluster ? Distance(points[order[i - 1]], points[order[i]]) : 0.0;
  }
  const double spacing = 1e-9 * (1 << 20) / std::sqrt(19000.0);
  EXPECT_LT(sum / 19000.0, 2.0 * spacing);
}

TEST(SpatialOrder, BeginsWithPointsFromEverywhere)
{
  const int size = 1 << 20;
  const std::vector<Point2> points = RandomPoints(20000, size, 4);
  const std::vector<Id> order = SpatialOrder(points);
  std::array<int, 4> quadrants{};
  for (std::size_t i = 0; i < 100; ++i)
  {
    const Point2& p = points[order[i]];
    ++quadrants[(p.X > size / 2 ? 1 : 0) + (p.Y > size / 2 ? 2 : 0)];
  }
  for (const int count : quadrants)
  {
    EXPECT_GT(count, 4);
  }
}
