// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Domain/SlantedBox.h"
#include "Support/PolylineShapes.h"

#include <gtest/gtest.h>

namespace biting
{

namespace
{

SlantedBox RandomBox(TestNumbers& numbers)
{
  SlantedBox box;
  box.Center = { numbers.Unit(), numbers.Unit() };
  const double angle = 6.28 * numbers.Unit();
  box.Axis = { std::cos(angle), std::sin(angle) };
  box.Along = 0.3 * numbers.Unit();
  box.Across = 0.1 * numbers.Unit();
  return box;
}

Point2 PointOf(const SlantedBox& box, TestNumbers& numbers)
{
  return box.Center + (box.Along * (2.0 * numbers.Unit() - 1.0)) * box.Axis +
    (box.Across * (2.0 * numbers.Unit() - 1.0)) * Perpendicular(box.Axis);
}

bool Holds(const SlantedBox& box, const Point2& p)
{
  const Point2 offset = p - box.Center;
  return std::abs(Dot(offset, box.Axis)) <= box.Along + 1e-12 &&
    std::abs(Cross(offset, box.Axis)) <= box.Across + 1e-12;
}

} // namespace

TEST(SlantedBox, AroundTwoHoldsThePointsOfBoth)
{
  TestNumbers numbers(17);
  for (int k = 0; k < 2000; ++k)
  {
    const SlantedBox first = RandomBox(numbers);
    const SlantedBox second = RandomBox(numbers);
    SlantedBox both;
    both.SlantAround(first, second);
    const SlantedBox& longer = first.Along >= second.Along ? first : second;
    EXPECT_EQ(both.Axis, longer.Axis);
    EXPECT_TRUE(Holds(both, PointOf(first, numbers)));
    EXPECT_TRUE(Holds(both, PointOf(second, numbers)));
  }
}

TEST(SlantedBox, IsBesideAnotherOnlyWhereTheyHaveNoCommonPoint)
{
  TestNumbers numbers(23);
  int apart = 0;
  for (int k = 0; k < 5000; ++k)
  {
    SlantedBox first = RandomBox(numbers);
    const SlantedBox second = RandomBox(numbers);
    apart += first.IsBeside(second, 0.0) ? 1 : 0;
    first.Center = first.Center + PointOf(second, numbers) - PointOf(first, numbers);
    EXPECT_FALSE(first.IsBeside(second, 1e-12));
    EXPECT_FALSE(second.IsBeside(first, 1e-12));
  }
  EXPECT_GT(apart, 1000);
}

} // namespace biting
