// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Spacing/SegmentCone.h"

#include "SpacingSources.h"

#include <gtest/gtest.h>

namespace
{

using namespace biting;

const Point2 Low{ 0.2, 0.3 };
const Point2 High{ 0.5, 0.7 };

} // namespace

TEST(SegmentCone, IsTheGivenValueAlongItsSegment)
{
  const SegmentCone cone(Low, High, 0.1, 0.2, 0.3);
  EXPECT_NEAR(cone(Low, 0.3), 0.1, 1e-15);
  EXPECT_NEAR(cone(High, 0.3), 0.2, 1e-15);
  EXPECT_NEAR(cone(Midpoint(Low, High), 0.3), 0.15, 1e-15);
}

TEST(SegmentCone, DoesNotDependOnTheDirectionOfTheSegment)
{
  const SegmentCone cone(Low, High, 0.1, 0.2, 0.3);
  const SegmentCone reversed(High, Low, 0.2, 0.1, 0.3);
  Sampler sampler(1);
  for (int probe = 0; probe < 100; ++probe)
  {
    const Point2 x = sampler.NextIn(UnitBox());
    EXPECT_EQ(cone(x, 0.3), reversed(x, 0.3));
  }
}

TEST(SegmentCone, OfSteepValuesGrowsFromTheLowerEnd)
{
  const SegmentCone cone(Low, High, 0.1, 0.9, 0.3);
  EXPECT_EQ(cone.End(), Low);
  EXPECT_NEAR(cone(High, 0.3), 0.1 + 0.3 * Distance(Low, High), 1e-15);
}

TEST(SegmentCone, IsTheValueOfItsFootAndTheWayFromThere)
{
  const SegmentCone cone(Low, High, 0.1, 0.2, 0.3);
  Sampler sampler(2);
  for (int probe = 0; probe < 1000; ++probe)
  {
    const Point2 x = sampler.NextIn({ { -1.0, -1.0 }, { 2.0, 2.0 } });
    const SegmentCone::View view = cone.From(x);
    ASSERT_NEAR(cone(x, 0.3), view.Value + 0.3 * Length(view.Away), 1e-12);
    ASSERT_NEAR(cone(x - view.Away, 0.3), view.Value, 1e-12);
  }
}

/// The law by which ConeTree drops cones.
TEST(SegmentCone, IsNowhereBelowItsTangentPlanes)
{
  Sampler sampler(3);
  for (const double value : { 0.1, 0.15, 0.2, 0.24 })
  {
    const SegmentCone cone(Low, High, 0.1, value, 0.3);
    for (int probe = 0; probe < 3000; ++probe)
    {
      const Point2 x = sampler.NextIn({ { -1.0, -1.0 }, { 2.0, 2.0 } });
      const Point2 y = sampler.NextIn({ { -1.0, -1.0 }, { 2.0, 2.0 } });
      const SegmentCone::View view = cone.From(x);
      const Point2 gradient = (0.3 / Length(view.Away)) * view.Away;
      ASSERT_GE(cone(y, 0.3), cone(x, 0.3) + Dot(gradient, y - x) - 1e-12);
      const Point2 along = cone.Slope * cone.Direction;
      ASSERT_GE(cone(y, 0.3), view.Value + Dot(along, y - (x - view.Away)) - 1e-12);
    }
  }
}

TEST(SegmentCone, WithoutGradationTakesTheSlopeOfTheData)
{
  const SegmentSource sloped{ { { 0.0, 0.0 }, { 1.0, 0.0 } }, { 0.1, 0.6 }, { 0, 1 } };
  EXPECT_DOUBLE_EQ(SlopeOfCones(sloped, 0.0), 0.5);
  EXPECT_DOUBLE_EQ(SlopeOfCones(sloped, 0.2), 0.2);
  const SegmentSource level{ { { 0.0, 0.0 }, { 1.0, 0.0 } }, { 0.1, 0.6 }, { 0, 0, 1, 1 } };
  EXPECT_DOUBLE_EQ(SlopeOfCones(level, 0.0), SpacingOptions().Gradation);
}

TEST(SegmentCone, WithoutGradationIsNotSteeperThanFromTheLeastToTheMostWithinAnEdge)
{
  const SegmentSource noise{ { { 0.0, 0.0 }, { 1.0, 0.0 }, { 1.0, 1e-12 } }, { 0.1, 0.2, 0.7 },
    { 0, 1, 1, 2 } };
  EXPECT_DOUBLE_EQ(SlopeOfCones(noise, 0.0), 6.0);
  EXPECT_DOUBLE_EQ(SlopeOfCones(noise, 20.0), 20.0);
}

/// A line at .5 from below which a field falls: segments above it are, and those that cross it.
TEST(SegmentCone, IsBelowAFunctionWhereItIsOnItsOwnSegment)
{
  const SegmentSource source{ { { 0.1, 0.1 }, { 0.3, 0.2 }, { 0.1, 0.8 }, { 0.3, 0.9 },
                                { 0.5, 0.1 }, { 0.5, 0.9 }, { 0.7, 0.6 } },
    { 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5 }, { 0, 1, 2, 3, 4, 5, 6, 6 } };
  Pulse pulse(NoMonitor());
  const std::vector<SegmentCone> below = ConesBelow(
    MakeCones(source, 1.0, 0.3, pulse), [](const Point2& x) { return x.Y; }, pulse);
  ASSERT_EQ(below.size(), 3u);
  EXPECT_TRUE(below[0].Start == source.Points[2]);
  EXPECT_TRUE(below[1].Start == source.Points[4]);
  EXPECT_TRUE(below[2].Start == source.Points[6]);
}
