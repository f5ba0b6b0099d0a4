// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Spacing/MergedCones.h"

#include "SpacingSources.h"

#include <gtest/gtest.h>

namespace
{

using namespace biting;

std::vector<SegmentCone> Merged(const SegmentSource& source, double slope)
{
  Pulse pulse(NoMonitor());
  return MergeCones(source, 1.0, slope, pulse);
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
  Pulse pulse(NoMonitor());
  const std::vector<SegmentCone> all = MakeCones(source, 1.0, slope, pulse);
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

TEST(MergedCones, AreNoneOfNoSegments)
{
  EXPECT_TRUE(Merged({}, 0.3).empty());
}
