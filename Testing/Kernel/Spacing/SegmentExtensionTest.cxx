// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Spacing/SegmentCone.h"

#include "Base/Numbers.h"

#include "../Support/Monitors.h"
#include "SpacingSources.h"

#include <gtest/gtest.h>

namespace
{

using namespace biting;

/// By sampling the definition: min over points y of the segment of f(y) + g |x - y|.
double SampledExtension(const SegmentSource& source, const Point2& x, double gradation)
{
  constexpr int samples = 200;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t end = 0; end < source.Segments.size(); end += 2)
  {
    const auto a = static_cast<std::size_t>(source.Segments[end]);
    const auto b = static_cast<std::size_t>(source.Segments[end + 1]);
    for (int sample = 0; sample <= samples; ++sample)
    {
      const double weight = sample / static_cast<double>(samples);
      const Point2 y = source.Points[a] + weight * (source.Points[b] - source.Points[a]);
      const double value = (1.0 - weight) * source.Values[a] + weight * source.Values[b];
      least = std::min(least, value + gradation * Distance(x, y));
    }
  }
  return least;
}

SegmentExtension ExtensionOf(const SegmentSource& source, double slope, double scale = 1.0)
{
  Pulse pulse(NoMonitor());
  return SegmentExtension(MakeCones(source, scale, slope, pulse), slope, pulse);
}

} // namespace

TEST(SegmentExtension, IsTheInfimumOverTheSegments)
{
  for (const SegmentSource& source : SegmentCorpus())
  {
    for (double gradation : { 0.05, 0.3, 2.0 })
    {
      const SegmentExtension extension = ExtensionOf(source, gradation);
      Sampler sampler(12);
      for (int probe = 0; probe < 20; ++probe)
      {
        const Point2 x = sampler.NextIn({ { -0.5, -0.5 }, { 1.5, 1.5 } });
        const double sampled = SampledExtension(source, x, gradation);
        ASSERT_LE(extension(x), sampled * (1.0 + 1e-12));
        ASSERT_GE(extension(x), sampled - (gradation + 0.4) * 0.5 / 200.0);
      }
    }
  }
}

TEST(SegmentExtension, IsLipschitzWithItsGradation)
{
  for (const SegmentSource& source : SegmentCorpus())
  {
    const SegmentExtension extension = ExtensionOf(source, 0.3);
    Sampler sampler(13);
    for (int probe = 0; probe < 1000; ++probe)
    {
      const Point2 x = sampler.NextIn(UnitBox());
      const Point2 y = sampler.NextIn(UnitBox());
      ASSERT_LE(std::abs(extension(x) - extension(y)), 0.3 * Distance(x, y) * (1.0 + 1e-12));
    }
  }
}

TEST(SegmentExtension, IsWhatIsKnownWhereThatIsLess)
{
  const SegmentExtension extension = ExtensionOf(MakeScatter(50, 0.1, 3), 0.3);
  const Point2 x{ 0.4, 0.6 };
  const double value = extension(x);
  EXPECT_EQ(extension(x, 0.5 * value), 0.5 * value);
  EXPECT_EQ(extension(x, 2.0 * value), value);
}

TEST(SegmentExtension, OfNegativeValuesFallsFromThem)
{
  const SegmentSource source{ { { 0.2, 0.5 }, { 0.6, 0.5 } }, { 0.1, 0.2 }, { 0, 1 } };
  const SegmentExtension extension = ExtensionOf(source, 0.5, -1.0);
  EXPECT_NEAR(extension({ 0.2, 0.5 }), -0.1, 1e-12);
  EXPECT_NEAR(extension({ 0.4, 0.5 }), -0.15, 1e-12);
  EXPECT_NEAR(extension({ 0.8, 0.5 }), -0.1, 1e-12);
  EXPECT_EQ(extension({ 9.0, 9.0 }, -0.01), -0.01);
}

TEST(SegmentExtension, IsEmptyWhereItIsStopped)
{
  StoppingMonitor monitor(0);
  Pulse pulse(monitor);
  const SegmentSource source = MakeLoop(20000, [](double) { return 0.01; });
  const SegmentExtension stopped(MakeCones(source, 1.0, 0.3, pulse), 0.3, pulse);
  EXPECT_EQ(stopped({ 0.5, 0.5 }), Infinity);
}

TEST(Spacing, IsRaisedByItsFloorLastOfAll)
{
  SpacingOptions options;
  options.Uniform = 0.02;
  options.Scale = 2.0;
  options.Maximum = 0.03;
  options.Floor = Share(SegmentSource{ { { 0.2, 0.5 }, { 0.6, 0.5 } }, { 0.1, 0.2 }, { 0, 1 } });
  const Spacing f = MakeGoodSpacing(options);
  EXPECT_FALSE(f.IsUniform());
  EXPECT_NEAR(f({ 0.6, 0.5 }), 0.2, 1e-12);
  EXPECT_NEAR(f({ 0.6, 0.6 }), 0.17, 1e-12);
  EXPECT_NEAR(f({ 0.9, 0.0 }), 0.03, 1e-12);
  options.Gradation = 0.0;
  EXPECT_NEAR(MakeGoodSpacing(options)({ 0.6, 0.6 }), 0.17, 1e-12);
}
