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

constexpr double MergingTolerance = 0.006;

std::vector<SegmentCone> Merged(const SegmentSource& source, double slope)
{
  Pulse pulse(NoMonitor());
  return MakeCones(source, 1.0, slope, pulse, MergingTolerance);
}

std::vector<SegmentCone> OneForEach(const SegmentSource& source, double slope)
{
  std::vector<SegmentCone> cones;
  for (std::size_t first = 0; first < source.Segments.size(); first += 2)
  {
    const auto a = static_cast<std::size_t>(source.Segments[first]);
    const auto b = static_cast<std::size_t>(source.Segments[first + 1]);
    cones.emplace_back(
      source.Points[a], source.Points[b], source.Values[a], source.Values[b], slope);
  }
  return cones;
}

double MinimumOf(const std::vector<SegmentCone>& cones, const Point2& x, double slope)
{
  double least = std::numeric_limits<double>::infinity();
  for (const SegmentCone& cone : cones)
  {
    least = std::min(least, cone(x, slope));
  }
  return least;
}

/// Near the segments, where it matters most.
void ExpectTheSameMinimum(const SegmentSource& source, double slope)
{
  const std::vector<SegmentCone> all = OneForEach(source, slope);
  const std::vector<SegmentCone> merged = Merged(source, slope);
  Sampler sampler(7);
  for (int probe = 0; probe < 500; ++probe)
  {
    const auto near = static_cast<std::size_t>(sampler.Next() * source.Points.size());
    const double away = 2.0 * std::pow(sampler.Next(), 3.0) * source.Values[near] / slope;
    const Point2 x = source.Points[near] + away * (sampler.NextIn(UnitBox()) - Point2{ 0.5, 0.5 });
    ASSERT_NEAR(MinimumOf(merged, x, slope) / MinimumOf(all, x, slope), 1.0, MergingTolerance);
  }
}

SegmentSource FineLoop(int count)
{
  return MakeLoop(count, [](double angle) { return 0.02 + 0.01 * std::sin(7.0 * angle); });
}

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

TEST(MergedCones, HaveTheSameMinimumWithinTheirTolerance)
{
  std::vector<SegmentSource> sources = SegmentCorpus();
  sources.push_back(FineLoop(5000));
  Sampler sampler(5);
  sources.push_back(MakeLoop(5000, [&sampler](double) { return 0.01 + 0.02 * sampler.Next(); }));
  for (const SegmentSource& source : sources)
  {
    for (double slope : { 0.05, 0.3, 2.0 })
    {
      ExpectTheSameMinimum(source, slope);
    }
  }
}

TEST(MergedCones, HaveTheSameMinimumWithoutATolerance)
{
  Pulse pulse(NoMonitor());
  for (const SegmentSource& source : SegmentCorpus())
  {
    const std::vector<SegmentCone> cones = MakeCones(source, 1.0, 0.3, pulse);
    Sampler sampler(8);
    for (int probe = 0; probe < 500; ++probe)
    {
      const Point2 x = sampler.NextIn(UnitBox());
      ASSERT_EQ(MinimumOf(cones, x, 0.3), MinimumOf(OneForEach(source, 0.3), x, 0.3));
    }
  }
}

TEST(MergedCones, AreNoMoreOfACurveThatIsDividedMoreFinely)
{
  const std::size_t coarse = Merged(FineLoop(10000), 0.3).size();
  EXPECT_LE(coarse, 2000u);
  EXPECT_LE(Merged(FineLoop(100000), 0.3).size(), coarse + coarse / 4);
}

TEST(MergedCones, AreNearlyAllWhereSegmentsAreAsLongAsTheirValues)
{
  const SegmentSource source = MakeLoop(100, [](double) { return 0.03; });
  EXPECT_GE(Merged(source, 0.3).size(), 90u);
}

TEST(MergedCones, OfAStraightLineWithEvenValuesAreOne)
{
  SegmentSource source;
  for (Id point = 0; point <= 1000; ++point)
  {
    const double share = point / 1000.0;
    source.Points.push_back({ 0.1 + 0.8 * share, 0.3 + 0.2 * share });
    source.Values.push_back(0.01 + 0.02 * share);
    source.Segments.insert(source.Segments.end(), { std::max(point - 1, 0), point });
  }
  EXPECT_EQ(Merged(source, 0.3).size(), 1u);
}

/// What each longer piece adds to the error adds up.
TEST(MergedCones, FollowACurveOfSegmentsThatHardlyTurn)
{
  SegmentSource source;
  for (Id point = 0; point <= 20000; ++point)
  {
    const double angle = 6.0 * point / 20000.0;
    const double radius = 0.45 * std::exp(-0.3 * angle);
    source.Points.push_back({ 0.5 + radius * std::cos(angle), 0.5 + radius * std::sin(angle) });
    source.Values.push_back(0.02 * radius * (1.0 + 1e-4 * (point % 2)));
    source.Segments.insert(source.Segments.end(), { std::max(point - 1, 0), point });
  }
  ExpectTheSameMinimum(source, 0.3);
}

TEST(DropHigh, LeavesTheMinimumWithinItsTolerance)
{
  Sampler sampler(9);
  Pulse pulse(NoMonitor());
  for (const double tolerance : { 0.01, 0.1 })
  {
    SegmentSource source = FineLoop(400);
    for (double& value : source.Values)
    {
      value *= 1.0 + 0.1 * sampler.Next();
    }
    const std::vector<SegmentCone> all = OneForEach(source, 0.3);
    std::vector<SegmentCone> kept = all;
    DropHigh(0.3, tolerance, kept, pulse);
    EXPECT_LT(kept.size(), all.size());
    for (int probe = 0; probe < 2000; ++probe)
    {
      const Point2 x = sampler.NextIn(UnitBox());
      const double most = std::pow(1.0 + 0.5 * tolerance, 2.0) * MinimumOf(all, x, 0.3);
      ASSERT_LE(MinimumOf(kept, x, 0.3), most);
    }
  }
}

TEST(MergedCones, AreNoneOfNoSegments)
{
  EXPECT_TRUE(Merged({}, 0.3).empty());
}
