// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Spacing/OutsideJumps.h"

#include "SpacingSources.h"

#include <gtest/gtest.h>

namespace
{

using namespace biting;

constexpr double Gradation = 0.3;

SegmentSource JumpsOf(const TriangulatedSource& source)
{
  const TriangleInterpolator field(source);
  ConeCollector cones({ 1.0, 0.0, 1e9 });
  EXPECT_TRUE(AddOutsideJumps(field, UnitBox(), Gradation, cones, NoMonitor()));
  return cones.Segments();
}

/// Strips along the lower and the upper side of the unit square, with a value each.
TriangulatedSource Strips(double low, double high)
{
  return { { { 0.0, 0.0 }, { 1.0, 0.0 }, { 1.0, 0.4 }, { 0.0, 0.4 }, { 0.0, 0.6 }, { 1.0, 0.6 },
             { 1.0, 1.0 }, { 0.0, 1.0 } },
    { low, low, low, low, high, high, high, high }, { 0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7 } };
}

double LargestDistanceToLine(const SegmentSource& cones, double y)
{
  double largest = 0.0;
  for (const Id point : cones.Segments)
  {
    largest = std::max(largest, std::abs(cones.Points[static_cast<std::size_t>(point)].Y - y));
  }
  return largest;
}

} // namespace

TEST(OutsideJumps, AreNoneWhereTrianglesCoverTheBounds)
{
  EXPECT_TRUE(JumpsOf(MakeTriangulation(9, [](const Point2& x) { return x.X < 0.5 ? 0.01 : 1.0; }))
                .Segments.empty());
}

TEST(OutsideJumps, AreNoneBetweenEqualValues)
{
  EXPECT_TRUE(JumpsOf(Strips(0.1, 0.1)).Segments.empty());
}

TEST(OutsideJumps, LieInTheMiddleBetweenTwoParts)
{
  const SegmentSource cones = JumpsOf(Strips(0.1, 1.0));
  EXPECT_FALSE(cones.Segments.empty());
  EXPECT_LT(LargestDistanceToLine(cones, 0.5), 0.03 * 0.1 / Gradation);
}

TEST(OutsideJumps, HaveTheValueOfTheLowerSide)
{
  for (const double value : JumpsOf(Strips(0.1, 1.0)).Values)
  {
    EXPECT_DOUBLE_EQ(value, 0.1);
  }
}
