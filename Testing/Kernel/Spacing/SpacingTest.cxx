// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Spacing/Spacing.h"

#include "SpacingSources.h"
#include "Support/TestThreads.h"

#include <gtest/gtest.h>

#include <thread> // for evaluation from several threads

namespace
{

using namespace biting;

double Wave(const Point2& x)
{
  return 0.05 + 0.03 * std::sin(7.0 * x.X) * std::cos(5.0 * x.Y);
}

SpacingOptions WithEverything()
{
  SpacingOptions options = With(MakeGrid(21, 31, Wave));
  options.Sources.emplace_back(
    Share(MakeTriangulation(15, [](const Point2& x) { return 0.03 + 0.1 * x.X; })));
  options.Sources.emplace_back(
    Share(MakeLoop(90, [](double angle) { return 0.03 + 0.01 * std::sin(angle); })));
  options.Uniform = 0.06;
  return options;
}

std::vector<Point2> Probes(int count)
{
  Sampler sampler(21);
  std::vector<Point2> probes;
  for (int probe = 0; probe < count; ++probe)
  {
    probes.push_back(sampler.NextIn({ { -0.2, -0.2 }, { 1.2, 1.2 } }));
  }
  return probes;
}

void ScaleBy(double factor, std::vector<double>& numbers)
{
  for (double& number : numbers)
  {
    number *= factor;
  }
}

SpacingOptions ScaledBy(double factor, const SpacingOptions& options)
{
  SpacingOptions scaled = Changed(options,
    [factor](auto& source)
    {
      Stretch({ factor, factor }, {}, source);
      ScaleBy(factor, source.Values);
    });
  scaled.Uniform *= factor;
  return scaled;
}

SpacingOptions ShiftedBy(const Point2& shift, const SpacingOptions& options)
{
  return Changed(options, [&shift](auto& source) { Stretch({ 1.0, 1.0 }, shift, source); });
}

} // namespace

TEST(Spacing, IsOneByDefault)
{
  EXPECT_EQ(Spacing()({ 3.0, 4.0 }), 1.0);
  EXPECT_TRUE(Spacing().IsUniform());
}

TEST(Spacing, IsTwoPercentOfTheDiagonalWhereNothingIsGiven)
{
  SpacingOptions options;
  const Spacing spacing = MakeGoodSpacing(options, { { 1.0, 1.0 }, { 4.0, 5.0 } });
  EXPECT_DOUBLE_EQ(spacing({ 2.0, 2.0 }), 0.1);
  EXPECT_TRUE(spacing.IsUniform());
  options.Sources.emplace_back(Share(GridSource()));
  options.Sources.emplace_back(Share(TriangulatedSource()));
  options.Sources.emplace_back(Share(SegmentSource()));
  EXPECT_DOUBLE_EQ(MakeGoodSpacing(options, { { 1.0, 1.0 }, { 4.0, 5.0 } })({ 0.0, 0.0 }), 0.1);
}

TEST(Spacing, IsPositiveInABoxOfNoExtent)
{
  EXPECT_GT(MakeGoodSpacing({}, Box2())({ 0.0, 0.0 }), 0.0);
  EXPECT_GT(MakeGoodSpacing({}, { { 1.0, 1.0 }, { 1.0, 1.0 } })({ 0.0, 0.0 }), 0.0);
  const Spacing point = MakeGoodSpacing(
    With(SegmentSource{ { { 1.0, 2.0 } }, { 0.25 }, { 0, 0 } }), { { 1.0, 2.0 }, { 1.0, 2.0 } });
  EXPECT_NEAR(point({ 1.0, 2.0 }), 0.25, 0.004);
}

TEST(Spacing, IsTheMinimumOfItsSources)
{
  const SpacingOptions all = WithEverything();
  SpacingOptions grid;
  grid.Sources = { all.Sources[0] };
  SpacingOptions triangulation;
  triangulation.Sources = { all.Sources[1] };
  SpacingOptions segments;
  segments.Sources = { all.Sources[2] };
  const Spacing f = MakeGoodSpacing(all);
  const Spacing fGrid = MakeGoodSpacing(grid);
  const Spacing fTriangulation = MakeGoodSpacing(triangulation);
  const Spacing fSegments = MakeGoodSpacing(segments);
  for (const Point2& x : Probes(2000))
  {
    ASSERT_EQ(f(x), std::min({ fGrid(x), fTriangulation(x), fSegments(x), 0.06 }));
  }
  EXPECT_FALSE(f.IsUniform());
}

TEST(Spacing, IsScaledThenClamped)
{
  SpacingOptions options = WithEverything();
  options.Gradation = 0.0;
  const Spacing plain = MakeGoodSpacing(options);
  options.Scale = 3.0;
  options.Minimum = 0.1;
  options.Maximum = 0.15;
  const Spacing bounded = MakeGoodSpacing(options);
  for (const Point2& x : Probes(2000))
  {
    ASSERT_NEAR(bounded(x), std::min(std::max(3.0 * plain(x), 0.1), 0.15), 1e-14);
    ASSERT_TRUE(bounded(x) >= 0.1 && bounded(x) <= 0.15);
  }
  options.Maximum = options.Minimum;
  EXPECT_EQ(MakeGoodSpacing(options)({ 0.3, 0.3 }), 0.1);
}

// The plane touches a sphere of radius 1 at the origin: lengths at x are 1 + |x|^2 / 4 times as
// large.
TEST(Spacing, OnASphereIsWhatIsGivenInLengthsOfTheSphere)
{
  SpacingOptions options;
  options.Uniform = 0.04;
  options.Curvature = 0.25;
  const Spacing uniform = MakeGoodSpacing(options);
  EXPECT_FALSE(uniform.IsUniform());
  options.Uniform = 0.0;
  options.Scale = 2.0;
  options.Minimum = 0.07;
  options.Sources.emplace_back(Share(MakeTriangulation(15, [](const Point2&) { return 0.02; })));
  const Spacing bounded = MakeGoodSpacing(options);
  for (const Point2& x : Probes(100))
  {
    EXPECT_DOUBLE_EQ(uniform(x), 0.04 * (1.0 + 0.25 * Dot(x, x)));
    EXPECT_DOUBLE_EQ(bounded(x), 0.07 * (1.0 + 0.25 * Dot(x, x)));
  }
}

// A jump from 0.2 to 0.02 on the sphere: f rises from there with the gradation, in the plane.
TEST(Spacing, OnASphereIsGradedInThePlane)
{
  SpacingOptions options;
  options.Curvature = 0.25;
  options.Gradation = 0.2;
  options.Sources.emplace_back(
    Share(MakeGrid(81, 81, [](const Point2& x) { return x.X < 0.5 ? 0.02 : 0.2; })));
  const Spacing f = MakeGoodSpacing(options);
  const auto stretch = [](const Point2& x) { return 1.0 + 0.25 * Dot(x, x); };
  for (const double y : { 0.1, 0.5, 0.9 })
  {
    EXPECT_NEAR(f({ 0.3, y }), 0.02 * stretch({ 0.3, y }), 1e-6);
    const double jump = 0.4875; // the last node with 0.02
    EXPECT_NEAR(f({ 0.8, y }), 0.02 * stretch({ jump, y }) + 0.2 * (0.8 - jump), 0.004);
  }
}

TEST(Spacing, GrowsWithEachSource)
{
  const SpacingOptions options = WithEverything();
  const SpacingOptions larger =
    Changed(options, [](auto& source) { ScaleBy(1.25, source.Values); });
  const Spacing f = MakeGoodSpacing(options);
  const Spacing g = MakeGoodSpacing(larger);
  for (const Point2& x : Probes(2000))
  {
    ASSERT_LE(f(x), g(x));
  }
}

TEST(Spacing, KnowsTheLargestSlopeOfWhatIsGiven)
{
  const auto plane = [](const Point2& x) { return 2.0 + 0.3 * x.X - 0.4 * x.Y; };
  EXPECT_NEAR(MakeGoodSpacing(With(MakeGrid(7, 9, plane))).GivenLipschitz(), 0.5, 1e-12);
  EXPECT_NEAR(MakeGoodSpacing(With(MakeTriangulation(7, plane))).GivenLipschitz(), 0.5, 1e-12);
  SpacingOptions segments =
    With(SegmentSource{ { { 0.0, 0.0 }, { 3.0, 4.0 } }, { 1.0, 2.0 }, { 0, 1 } });
  segments.Scale = 10.0;
  EXPECT_NEAR(MakeGoodSpacing(segments).GivenLipschitz(), 2.0, 1e-12);
  segments.Sources.clear();
  EXPECT_EQ(MakeGoodSpacing(segments).GivenLipschitz(), 0.0);
}

TEST(Spacing, OfSourcesWithOneValueIsUniform)
{
  const auto level = [](const Point2&) { return 0.5; };
  SpacingOptions options = With(MakeGrid(4, 4, level));
  options.Sources.emplace_back(Share(MakeTriangulation(4, level)));
  options.Sources.emplace_back(Share(MakeLoop(10, [](double) { return 0.25; })));
  options.Gradation = 0.0;
  const Spacing spacing = MakeGoodSpacing(options);
  EXPECT_TRUE(spacing.IsUniform());
  EXPECT_EQ(spacing({ 0.5, 0.5 }), 0.25);
  options.Gradation = 0.3;
  EXPECT_FALSE(MakeGoodSpacing(options).IsUniform()); // it grows from the boundary
}

TEST(Spacing, OfOneValueAndHolesIsUniform)
{
  const auto level = [](const Point2& x) { return x.X > 0.6 ? NotANumber : 0.5; };
  EXPECT_TRUE(MakeGoodSpacing(With(MakeGrid(4, 4, level))).IsUniform());
  const auto step = [](const Point2& x) { return x.X > 0.6 ? NotANumber : x.Y > 0.6 ? 0.6 : 0.5; };
  EXPECT_FALSE(MakeGoodSpacing(With(MakeGrid(4, 4, step))).IsUniform());
}

/// Slopes of the largest number there is were not finite, and f not limited at all.
TEST(Spacing, KeepsTheGradationBesideFillValuesHoweverLarge)
{
  for (const double fill : { 1e75, 1e200, std::numeric_limits<double>::max() })
  {
    const auto field = [fill](const Point2& x) { return x.X + x.Y < 0.9 ? 0.02 : fill; };
    for (const SpacingOptions& options :
      { With(MakeGrid(17, 17, field)), With(MakeTriangulation(17, field)) })
    {
      const Spacing f = MakeGoodSpacing(options);
      Sampler sampler(4);
      for (int probe = 0; probe < 500; ++probe)
      {
        const Point2 x = sampler.NextIn(UnitBox());
        const Point2 y = sampler.NextIn(UnitBox());
        const double rise = std::abs(f(x) - f(y)) - options.Gradation * Distance(x, y);
        ASSERT_LE(rise, 0.02 * std::min(f(x), f(y))) << fill;
      }
    }
  }
}

TEST(Spacing, FillsHolesFromTheirBorder)
{
  const auto holed = [](const Point2& x) { return x.X > 0.45 ? NotANumber : 1.0 + x.Y; };
  SpacingOptions withGrid = With(MakeGrid(11, 11, holed));
  SpacingOptions withTriangles = With(MakeTriangulation(11, holed));
  withGrid.Gradation = withTriangles.Gradation = 0.0;
  const Spacing grid = MakeGoodSpacing(withGrid);
  const Spacing triangulation = MakeGoodSpacing(withTriangles);
  for (const Point2& x : Probes(1000))
  {
    const double expected = 1.0 + std::min(std::max(x.Y, 0.0), 1.0);
    ASSERT_NEAR(grid(x), expected, 1e-12);
    ASSERT_NEAR(triangulation(x), expected, 1e-12);
  }
}

TEST(Spacing, IsTheSameFromAnyThread)
{
  const Spacing spacing = MakeGoodSpacing(WithEverything());
  const std::vector<Point2> probes = Probes(20000);
  std::vector<std::vector<double>> values(4, std::vector<double>(probes.size()));
  std::vector<std::thread> threads;
  for (std::vector<double>& own : values)
  {
    threads.emplace_back(
      [&spacing, &probes, &own]()
      {
        std::transform(probes.begin(), probes.end(), own.begin(),
          [&spacing](const Point2& x) { return spacing(x); });
      });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  for (const std::vector<double>& own : values)
  {
    EXPECT_EQ(own, values.front());
  }
}

TEST(Spacing, ScalesExactlyWithPowersOfTwo)
{
  const SpacingOptions options = WithEverything();
  const Spacing spacing = MakeGoodSpacing(options);
  for (double factor : { std::ldexp(1.0, -40), 0.5, std::ldexp(1.0, 33) })
  {
    const Spacing scaled =
      MakeGoodSpacing(ScaledBy(factor, options), { { 0.0, 0.0 }, { factor, factor } });
    for (const Point2& x : Probes(2000))
    {
      ASSERT_EQ(scaled(factor * x), factor * spacing(x));
    }
  }
}

TEST(Spacing, MovesWithItsSources)
{
  const SpacingOptions options = WithEverything();
  const Spacing spacing = MakeGoodSpacing(options);
  const Point2 shift{ 1e6, -2e6 };
  const Spacing shifted =
    MakeGoodSpacing(ShiftedBy(shift, options), { shift, shift + Point2{ 1.0, 1.0 } });
  for (const Point2& x : Probes(2000))
  {
    ASSERT_NEAR(shifted(x + shift) / spacing(x), 1.0, 0.025);
  }
}

/// Found by fuzzing: products with 3e307 overflowed while biting.
TEST(Spacing, FarAboveAnyDrawingHasFourthPowersAndMore)
{
  SpacingOptions options;
  options.Uniform = std::numeric_limits<double>::max();
  const double f = MakeGoodSpacing(options)({ 0.3, 0.3 });
  EXPECT_TRUE(f >= 1e70 && std::isfinite(f * f * f * f));
  options.Maximum = 7.0;
  EXPECT_EQ(MakeGoodSpacing(options)({ 0.3, 0.3 }), 7.0);
}

TEST(Spacing, IsPositiveAndFiniteWhereverItIsAsked)
{
  const Spacing spacing = MakeGoodSpacing(WithEverything());
  const double infinity = std::numeric_limits<double>::infinity();
  for (double wild : { NotANumber, infinity, -infinity, 1e300, -1e300 })
  {
    for (const Point2& x : { Point2{ wild, 0.5 }, Point2{ 0.5, wild }, Point2{ wild, wild } })
    {
      EXPECT_TRUE(spacing(x) > 0.0 && std::isfinite(spacing(x)));
    }
  }
}

TEST(MakeSpacing, LooksForNoJumpsOutsideOfTrianglesThatCoverTheDomain)
{
  TriangulatedSource source =
    MakeTriangulation(9, [](const Point2& x) { return 0.02 + 0.1 * x.X; });
  source.Values[40] = NotANumber; // in the middle
  SpacingOptions options = With(source);
  options.Gradation = 0.3;
  const Spacing limited = MakeGoodSpacing(options);
  source.CoversDomain = true;
  options.Sources = { Share(source) };
  const Spacing covering = MakeGoodSpacing(options);
  for (const Point2& inside : { Point2{ 0.1, 0.3 }, Point2{ 0.37, 0.37 }, Point2{ 0.7, 0.9 } })
  {
    EXPECT_EQ(covering(inside), limited(inside));
  }
  const Point2 left{ 0.499, 0.5 };
  const Point2 right{ 0.501, 0.5 };
  EXPECT_GT(covering(right) - covering(left), 0.01);
  EXPECT_LT(limited(right) - limited(left), 0.1 * limited(left));
}

/// More triangles than are a task; they are steep, have holes and do not fill the bounds.
TEST(MakeSpacing, OfTrianglesIsTheSameOnAnyNumberOfThreads)
{
  Sampler sampler(29);
  const SpacingOptions options = With(MakeTriangulation(151,
    [&sampler](const Point2& x) {
      return Length(x - Point2{ 0.6, 0.5 }) < 0.1 ? NotANumber : 0.02 + 0.02 * sampler.Next();
    }));
  const Box2 bounds{ { -0.2, -0.2 }, { 1.2, 1.2 } };
  const Spacing expected = MakeGoodSpacing(options, bounds);
  for (const int threads : { 2, 3 })
  {
    MonitorWithThreads monitor(threads);
    ProblemList problems;
    const Spacing f = MakeSpacing(options, bounds, problems, monitor);
    for (const Point2& x : Probes(20000))
    {
      ASSERT_EQ(f(x), expected(x));
    }
  }
}
