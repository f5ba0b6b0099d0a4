// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Spacing/AdaptiveCarrier.h"

#include "../Support/Monitors.h"
#include "SpacingSources.h"

#include <gtest/gtest.h>

#include <utility> // for move

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

std::vector<SegmentSource> Corpus()
{
  return { MakeScatter(1, 0.5, 1), MakeScatter(3, 0.5, 2), MakeScatter(40, 0.3, 3),
    MakeScatter(300, 0.02, 4), MakeScatter(300, 0.5, 5),
    MakeLoop(100, [](double angle) { return 0.02 + 0.01 * std::sin(angle); }),
    MakeLoop(400, [](double) { return 0.004; }) };
}

struct Errors
{
  double Above = 0.0;
  double Below = 0.0;
};

AdaptiveCarrier MakeCarrier(SegmentExtension extension, const Box2& box = UnitBox())
{
  AdaptiveCarrier carrier(std::move(extension), box);
  carrier.Refine({}, NoMonitor());
  return carrier;
}

SegmentExtension FineLoop()
{
  return SegmentExtension(MakeLoop(2000, [](double) { return 0.0005; }), 0.3);
}

Errors LargestErrors(const SegmentSource& source, double gradation, int probes)
{
  const SegmentExtension exact(source, gradation);
  const AdaptiveCarrier carrier = MakeCarrier(exact);
  Sampler sampler(11);
  Errors errors;
  for (int probe = 0; probe < probes; ++probe)
  {
    const Point2 x = sampler.NextIn(UnitBox());
    const double error = carrier(x) / exact(x) - 1.0;
    errors.Above = std::max(errors.Above, error);
    errors.Below = std::max(errors.Below, -error);
  }
  return errors;
}

} // namespace

TEST(SegmentExtension, IsTheInfimumOverTheSegments)
{
  for (const SegmentSource& source : Corpus())
  {
    for (double gradation : { 0.05, 0.3, 2.0 })
    {
      const SegmentExtension extension(source, gradation);
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
  for (const SegmentSource& source : Corpus())
  {
    const SegmentExtension extension(source, 0.3);
    Sampler sampler(13);
    for (int probe = 0; probe < 1000; ++probe)
    {
      const Point2 x = sampler.NextIn(UnitBox());
      const Point2 y = sampler.NextIn(UnitBox());
      ASSERT_LE(std::abs(extension(x) - extension(y)), 0.3 * Distance(x, y) * (1.0 + 1e-12));
    }
  }
}

TEST(SegmentExtension, WithoutGradationTakesTheSlopeOfTheData)
{
  const SegmentSource sloped{ { { 0.0, 0.0 }, { 1.0, 0.0 } }, { 0.1, 0.6 }, { 0, 1 } };
  EXPECT_DOUBLE_EQ(SegmentExtension(sloped, 0.0).Gradation(), 0.5);
  const SegmentSource level{ { { 0.0, 0.0 }, { 1.0, 0.0 } }, { 0.1, 0.6 }, { 0, 0, 1, 1 } };
  EXPECT_DOUBLE_EQ(SegmentExtension(level, 0.0).Gradation(), SpacingOptions().Gradation);
}

TEST(AdaptiveCarrier, IsWithinItsToleranceOfTheExtension)
{
  for (const SegmentSource& source : Corpus())
  {
    for (double gradation : { 0.02, 0.3, 1.0 })
    {
      const Errors errors = LargestErrors(source, gradation, 20000);
      EXPECT_LE(errors.Above, AdaptiveCarrier::Tolerance);
      EXPECT_LE(errors.Below, AdaptiveCarrier::Tolerance);
    }
  }
}

TEST(AdaptiveCarrier, IsTheGivenValueOnTheSegments)
{
  const SegmentSource source =
    MakeLoop(200, [](double angle) { return 0.02 + 0.015 * std::sin(3.0 * angle); });
  const AdaptiveCarrier carrier = MakeCarrier(SegmentExtension(source, 0.0));
  Sampler sampler(14);
  for (std::size_t point = 0; point < source.Points.size(); ++point)
  {
    const std::size_t next = (point + 1) % source.Points.size();
    const double weight = sampler.Next();
    const double given = (1.0 - weight) * source.Values[point] + weight * source.Values[next];
    const Point2 x = source.Points[point] + weight * (source.Points[next] - source.Points[point]);
    ASSERT_NEAR(carrier(x), given, AdaptiveCarrier::Tolerance * given);
  }
}

TEST(AdaptiveCarrier, IsNearlyLipschitzAndJumpsOnlyWithinItsTolerance)
{
  const SegmentSource source = MakeScatter(100, 0.2, 15);
  const AdaptiveCarrier carrier = MakeCarrier(SegmentExtension(source, 0.3));
  Sampler sampler(16);
  for (int probe = 0; probe < 20000; ++probe)
  {
    const Point2 x = sampler.NextIn(UnitBox());
    const Point2 y = x + 0.02 * (sampler.NextIn(UnitBox()) - Point2{ 0.5, 0.5 });
    const double jump = 2.0 * AdaptiveCarrier::Tolerance * carrier(x);
    ASSERT_LE(std::abs(carrier(x) - carrier(y)), 0.3 * Distance(x, y) + jump);
  }
}

TEST(AdaptiveCarrier, IsTheNearestValueBeyondItsBox)
{
  const AdaptiveCarrier carrier = MakeCarrier(SegmentExtension(MakeScatter(20, 0.2, 17), 0.3));
  EXPECT_EQ(carrier({ 7.0, 0.25 }), carrier({ 1.0, 0.25 }));
  EXPECT_EQ(carrier({ -7.0, 9.0 }), carrier({ 0.0, 1.0 }));
}

TEST(AdaptiveCarrier, TakesBoxesOfAnyProportion)
{
  const SegmentExtension exact(MakeScatter(20, 0.2, 18), 0.3);
  const Box2 thin{ { 0.0, 0.4 }, { 1.0, 0.4 + 1e-7 } };
  const AdaptiveCarrier carrier = MakeCarrier(exact, thin);
  Sampler sampler(19);
  for (int probe = 0; probe < 2000; ++probe)
  {
    const Point2 x = sampler.NextIn(thin);
    ASSERT_NEAR(carrier(x) / exact(x), 1.0, AdaptiveCarrier::Tolerance);
  }
}

/// Of a box whose border is a line between squares but for rounding, with points near it.
double LargestErrorOnBorder(const Box2& box, int seed)
{
  SegmentSource source = MakeScatter(40, 0.01, seed);
  for (Point2& point : source.Points)
  {
    point = { box.Low.X + point.X * box.Width(), box.Low.Y + point.Y * box.Height() };
  }
  const SegmentExtension exact(source, 0.3);
  const AdaptiveCarrier carrier = MakeCarrier(exact, box);
  double largest = 0.0;
  for (int part = 0; part <= 16; ++part)
  {
    const double x = std::min(box.Low.X + part / 16.0 * box.Width(), box.High.X);
    const double y = std::min(box.Low.Y + part / 16.0 * box.Height(), box.High.Y);
    for (const Point2& place : { Point2{ x, box.High.Y }, Point2{ box.High.X, y } })
    {
      largest = std::max(largest, std::abs(carrier(place) / exact(place) - 1.0));
    }
  }
  return largest;
}

TEST(AdaptiveCarrier, IsWithinItsToleranceOnABorderThatRoundingMovesIntoTheNextSquare)
{
  Sampler sampler(17);
  for (int seed = 0; seed < 400; ++seed)
  {
    const Point2 low{ -2.0 * sampler.Next(), -2.0 * sampler.Next() };
    const double width = 1.0 + sampler.Next();
    const double height = std::ldexp(width, -1 - seed % 3);
    const Box2 wide{ low, { low.X + width, low.Y + height } };
    const Box2 tall{ low, { low.X + height, low.Y + width } };
    ASSERT_LT(LargestErrorOnBorder(wide, seed), 0.01) << seed;
    ASSERT_LT(LargestErrorOnBorder(tall, seed), 0.01) << seed;
  }
}

TEST(AdaptiveCarrier, IsTheExtensionWhereTheSlopeIsLostInRounding)
{
  for (const double gradation : { 1e-200, 1e-20, 1e-16 })
  {
    const SegmentExtension exact(MakeScatter(40, 0.5, 3), gradation);
    const AdaptiveCarrier carrier = MakeCarrier(exact);
    Sampler sampler(5);
    for (int probe = 0; probe < 100; ++probe)
    {
      const Point2 x = sampler.NextIn(UnitBox());
      ASSERT_NEAR(carrier(x), exact(x), 0.005 * exact(x)) << gradation;
    }
  }
}

TEST(AdaptiveCarrier, StopsWhenAsked)
{
  StoppingMonitor monitor(0);
  AdaptiveCarrier carrier(FineLoop(), UnitBox());
  EXPECT_FALSE(carrier.Refine({}, monitor));
  EXPECT_FALSE(carrier.IsComplete());
}

TEST(AdaptiveCarrier, AsksOnceWhetherManyLeavesAreAffordable)
{
  for (const bool isAffordable : { false, true })
  {
    int questions = 0;
    AdaptiveCarrier::Relief relief;
    relief.ManyLeaves = 100;
    relief.ForecastVertices = [&questions, isAffordable](Monitor&)
    {
      ++questions;
      return isAffordable ? 1e6 : std::numeric_limits<double>::infinity();
    };
    AdaptiveCarrier carrier(FineLoop(), UnitBox());
    EXPECT_EQ(carrier.Refine(relief, NoMonitor()), isAffordable);
    EXPECT_EQ(questions, 1);
  }
}

TEST(AdaptiveCarrier, ShowsTheProgressOfTheForecastAndHearsThatItIsToStop)
{
  for (const bool isStopped : { false, true })
  {
    StoppingMonitor monitor(isStopped ? 3 : 1 << 30);
    AdaptiveCarrier::Relief relief;
    relief.ManyLeaves = 100;
    relief.ForecastVertices = [&monitor](Monitor& asked)
    {
      const double done = monitor.Fraction;
      for (const double fraction : { 0.1, 0.5, 1.0, 1.0, 1.0 })
      {
        asked.Advance(fraction);
        EXPECT_GE(monitor.Fraction, done);
        EXPECT_LE(monitor.Fraction, 1.0);
      }
      return 1e6;
    };
    AdaptiveCarrier carrier(FineLoop(), UnitBox());
    EXPECT_EQ(carrier.Refine(relief, monitor), !isStopped);
    EXPECT_EQ(monitor.HasStopped(), isStopped);
    EXPECT_TRUE(!isStopped || monitor.Calls == 4) << "asked again after it wanted to stop";
  }
}

TEST(AdaptiveCarrier, StaysExactWhereItWouldHaveManyMoreLeavesThanVertices)
{
  AdaptiveCarrier::Relief relief;
  relief.ManyLeaves = 1;
  for (const double vertices : { 1.0, 1e6 })
  {
    relief.ForecastVertices = [vertices](Monitor&) { return vertices; };
    AdaptiveCarrier carrier(FineLoop(), UnitBox());
    EXPECT_TRUE(carrier.Refine(relief, NoMonitor()));
    EXPECT_EQ(carrier.IsComplete(), vertices == 1e6);
    const Point2 x{ 0.4, 0.3 };
    const double exact = FineLoop()(x);
    EXPECT_NEAR(carrier(x), exact, vertices == 1.0 ? 0.0 : AdaptiveCarrier::Tolerance * exact);
  }
}

TEST(AdaptiveCarrier, IsExactWhereItIsNotComplete)
{
  const SegmentExtension exact = FineLoop();
  const AdaptiveCarrier carrier(exact, UnitBox());
  Sampler sampler(20);
  for (int probe = 0; probe < 100; ++probe)
  {
    const Point2 x = sampler.NextIn(UnitBox());
    EXPECT_EQ(carrier(x), exact(x));
  }
}
