// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Spacing/FeatureSize.h"

#include "../Support/TestThreads.h"
#include "SpacingSources.h"

#include <gtest/gtest.h>

#include <cmath> // for log1p

namespace
{

using namespace biting;

/// Closed loops with the domain on their left.
FeatureSource Loops(const std::vector<std::vector<Point2>>& loops)
{
  FeatureSource source;
  for (const std::vector<Point2>& loop : loops)
  {
    const auto first = static_cast<Id>(source.Points.size());
    const auto count = static_cast<Id>(loop.size());
    source.Points.insert(source.Points.end(), loop.begin(), loop.end());
    for (Id corner = 0; corner < count; ++corner)
    {
      source.Starts.push_back(first + corner);
      source.Ends.push_back(first + (corner + 1) % count);
    }
  }
  source.LeftInside.assign(source.Starts.size(), 1);
  source.RightInside.assign(source.Starts.size(), 0);
  return source;
}

std::vector<Point2> Rectangle(double lowX, double lowY, double highX, double highY)
{
  return { { lowX, lowY }, { highX, lowY }, { highX, highY }, { lowX, highY } };
}

std::vector<Point2> Reversed(std::vector<Point2> loop)
{
  return { loop.rbegin(), loop.rend() };
}

void AddPoint(const Point2& place, FeatureSource& source)
{
  const auto point = static_cast<Id>(source.Points.size());
  source.Points.push_back(place);
  source.Starts.push_back(point);
  source.Ends.push_back(point);
  source.LeftInside.push_back(1);
  source.RightInside.push_back(1);
}

double SizeAt(const FeatureSource& source, Id segment, const Point2& x)
{
  Pulse pulse(NoMonitor());
  return FeatureSize(source, pulse)(segment, x, 100.0);
}

Spacing WithFeatures(FeatureSource source, double uniform, const Box2& bounds = UnitBox())
{
  SpacingOptions options;
  options.Uniform = uniform;
  options.Features = Share(std::move(source));
  return MakeGoodSpacing(options, bounds);
}

/// The segments as if they were of a drawing with none longer than that.
std::shared_ptr<const SegmentSource> Drawn(const FeatureSource& source, double longest)
{
  auto drawn = std::make_shared<SegmentSource>();
  for (std::size_t segment = 0; segment < source.Starts.size(); ++segment)
  {
    const Point2& start = source.Points[static_cast<std::size_t>(source.Starts[segment])];
    const Point2& end = source.Points[static_cast<std::size_t>(source.Ends[segment])];
    const auto first = static_cast<Id>(2 * segment);
    drawn->Segments.insert(drawn->Segments.end(), { first, first + 1 });
    drawn->Points.insert(drawn->Points.end(), { start, end });
    drawn->Values.resize(drawn->Points.size(), std::min(longest, Distance(start, end)));
  }
  return drawn;
}

/// A wide hall of 5000 segments that is narrow, but for rounding, at its right end: with as many
/// samples as that takes, caps end before all of it is capped.
FeatureSource NarrowHall(double gap)
{
  constexpr int Steps = 2500;
  std::vector<Point2> loop;
  for (int step = 0; step < Steps; ++step)
  {
    loop.push_back({ static_cast<double>(step) / Steps, 0.0 });
  }
  for (int step = Steps; step > 0; --step)
  {
    const double x = static_cast<double>(step) / Steps;
    loop.push_back({ x, x > 0.9 ? gap : 0.3 });
  }
  FeatureSource hall = Loops({ loop });
  hall.Drawn = Drawn(hall, 1e-7);
  return hall;
}

Spacing OnThreads(const FeatureSource& source, double uniform, int threads)
{
  SpacingOptions options;
  options.Uniform = uniform;
  options.Features = Share(source);
  ProblemList problems;
  MonitorWithThreads monitor(threads);
  return MakeSpacing(options, UnitBox(), problems, monitor);
}

void ExpectSameAlong(const FeatureSource& source, const Spacing& f, const Spacing& expected)
{
  for (const Point2& point : source.Points)
  {
    ASSERT_EQ(f(point), expected(point));
  }
}

/// By sampling the definition: points of the others on the inner side of the own segment.
double SampledSize(const FeatureSource& source, std::size_t own, const Point2& x)
{
  const Point2 start = source.Points[static_cast<std::size_t>(source.Starts[own])];
  const Point2 end = source.Points[static_cast<std::size_t>(source.Ends[own])];
  double least = 100.0;
  for (std::size_t other = 0; other < source.Starts.size(); ++other)
  {
    const Id a = source.Starts[other];
    const Id b = source.Ends[other];
    const bool isIncident = a == source.Starts[own] || a == source.Ends[own] ||
      b == source.Starts[own] || b == source.Ends[own];
    for (int step = 0; step <= 400 && !isIncident; ++step)
    {
      const Point2& from = source.Points[static_cast<std::size_t>(a)];
      const Point2 y = from + (step / 400.0) * (source.Points[static_cast<std::size_t>(b)] - from);
      if (Cross(end - start, y - start) > 0.0)
      {
        least = std::min(least, Distance(x, y));
      }
    }
  }
  return least;
}

} // namespace

TEST(FeatureSize, IsTheWidthOfAChannel)
{
  const FeatureSource channel = Loops({ Rectangle(0.0, 0.0, 2.0, 0.1) });
  EXPECT_NEAR(SizeAt(channel, 0, { 1.0, 0.0 }), 0.1, 1e-12);
  EXPECT_NEAR(SizeAt(channel, 2, { 0.3, 0.1 }), 0.1, 1e-12);
}

TEST(FeatureSize, IsWhatIsKnownWhereNothingIsNearer)
{
  const FeatureSource square = Loops({ Rectangle(0.0, 0.0, 1.0, 1.0) });
  Pulse pulse(NoMonitor());
  EXPECT_EQ(FeatureSize(square, pulse)(0, { 0.5, 0.0 }, 0.3), 0.3);
}

/// f by its own lengths is no cap.
TEST(FeatureSize, ADrawingThatStandsForItselfIsAsOneThatWasNotSimplified)
{
  const FeatureSource alone = Loops({ Rectangle(0.0, 0.0, 1.0, 1.0),
    Reversed(Rectangle(0.1, 0.01, 0.15, 0.5)), Reversed(Rectangle(0.16, 0.01, 0.9, 0.5)) });
  FeatureSource simplified = alone;
  simplified.Drawn = Drawn(alone, 100.0);
  const Spacing without = WithFeatures(alone, 0.3);
  const Spacing with = WithFeatures(simplified, 0.3);
  Sampler sampler(7);
  for (int k = 0; k < 1000; ++k)
  {
    const Point2 x{ sampler.Next(), sampler.Next() };
    ASSERT_NEAR(with(x), without(x), 0.02 * without(x));
  }
}

/// Below a quarter of what is given, but no further than the drawing's own segments asked for.
TEST(FeatureSize, GapsBesideASimplifiedDrawingAreFollowedAsFarAsItsSegmentsWere)
{
  const double gap = 0.004;
  FeatureSource channel = Loops({ Rectangle(0.0, 0.0, 1.0, gap) });
  EXPECT_NEAR(WithFeatures(channel, 0.4)({ 0.5, gap }), 0.1, 0.002);
  channel.Drawn = Drawn(channel, 0.05);
  EXPECT_NEAR(WithFeatures(channel, 0.4)({ 0.5, gap }), 1.4 * 0.05, 0.002);
}

/// A short segment far from the place does not make the whole gap fine.
TEST(FeatureSize, GapsAreFollowedByTheSegmentsOfTheDrawingNearThePlace)
{
  const double gap = 0.004;
  FeatureSource channel = Loops({ Rectangle(0.0, 0.0, 1.0, gap) });
  const auto drawn = std::make_shared<SegmentSource>();
  drawn->Points = { { 0.4, 0.0 }, { 0.401, 0.0 } };
  drawn->Values = { 0.001, 0.001 };
  drawn->Segments = { 0, 1 };
  channel.Drawn = drawn;
  const Spacing f = WithFeatures(channel, 0.4);
  EXPECT_NEAR(f({ 0.4, 0.0 }), gap, 1e-4);
  EXPECT_NEAR(f({ 0.5, gap }), 0.3 * 0.1, 0.002);
}

TEST(FeatureSize, DoesNotCountSegmentsThatShareAnEnd)
{
  const FeatureSource wedge = Loops({ { { 0.0, 0.0 }, { 1.0, 0.0 }, { 1.0, 0.05 } } });
  EXPECT_EQ(SizeAt(wedge, 0, { 0.01, 0.0 }), 100.0);
}

TEST(FeatureSize, DoesNotLookThroughTheOutside)
{
  const FeatureSource slab =
    Loops({ Rectangle(-1.0, -1.0, 2.0, 2.0), Reversed(Rectangle(0.0, 0.4, 1.0, 0.4 + 1e-3)) });
  EXPECT_NEAR(SizeAt(slab, 4, { 0.5, 0.4 + 1e-3 }), 1.5, 1e-12);
  EXPECT_NEAR(SizeAt(slab, 6, { 0.5, 0.4 }), 1.4, 1e-12);
}

TEST(FeatureSize, CountsEmbeddedPoints)
{
  FeatureSource square = Loops({ Rectangle(0.0, 0.0, 1.0, 1.0) });
  AddPoint({ 0.5, 0.02 }, square);
  EXPECT_NEAR(SizeAt(square, 0, { 0.5, 0.0 }), 0.02, 1e-12);
  EXPECT_NEAR(SizeAt(square, 4, { 0.5, 0.02 }), 0.02, 1e-12);
}

TEST(FeatureSize, IsTheDistanceThatItsDefinitionSays)
{
  std::vector<Point2> star;
  Sampler sampler(41);
  for (int corner = 0; corner < 60; ++corner)
  {
    const double angle = 6.283185307179586 * corner / 60.0;
    const double radius = 0.1 + 0.4 * sampler.Next();
    star.push_back({ 0.5 + radius * std::cos(angle), 0.5 + radius * std::sin(angle) });
  }
  const FeatureSource source = Loops({ star });
  for (std::size_t segment = 0; segment < star.size(); ++segment)
  {
    const Point2 x = Midpoint(star[segment], star[(segment + 1) % star.size()]);
    const double sampled = SampledSize(source, segment, x);
    const double size = SizeAt(source, static_cast<Id>(segment), x);
    ASSERT_LE(size, sampled + 1e-12);
    ASSERT_GE(size, sampled - 0.002);
  }
}

TEST(FeatureSize, IsExactAboveWhatIsEnoughAndNoMoreThanThatBelow)
{
  std::vector<Point2> star;
  for (int corner = 0; corner < 40; ++corner)
  {
    const double radius = corner % 2 == 0 ? 1.0 : 0.3 + 0.01 * corner;
    const double angle = 2.0 * std::acos(-1.0) * corner / 40.0;
    star.push_back({ radius * std::cos(angle), radius * std::sin(angle) });
  }
  const FeatureSource source = Loops({ star });
  Pulse pulse(NoMonitor());
  const FeatureSize size(source, pulse);
  int numberAbove = 0;
  for (Id segment = 0; segment < 40; ++segment)
  {
    const Point2 x = Midpoint(star[segment], star[(segment + 1) % 40]);
    const double exact = size(segment, x, 100.0);
    for (const double enough : { 0.1, 0.2, 0.4 })
    {
      const double found = size(segment, x, 100.0, enough);
      numberAbove += exact > enough ? 1 : 0;
      EXPECT_GE(found, exact);
      EXPECT_LE(found, std::max(exact, enough));
    }
  }
  EXPECT_GT(numberAbove, 10);
  EXPECT_LT(numberAbove, 110); // of 120
}

TEST(FeatureLimit, IsTheFeatureSizeInAChannel)
{
  const Spacing f = WithFeatures(Loops({ Rectangle(0.0, 0.0, 1.0, 0.05) }), 0.1);
  EXPECT_NEAR(f({ 0.5, 0.0 }), 0.05, 0.05 * 0.01);
  EXPECT_NEAR(f({ 0.5, 0.05 }), 0.05, 0.05 * 0.01);
}

TEST(FeatureLimit, IsNotBelowAQuarterOfWhatIsGiven)
{
  const Spacing f = WithFeatures(Loops({ Rectangle(0.0, 0.0, 1.0, 1e-5) }), 0.1);
  Sampler sampler(42);
  for (int probe = 0; probe < 1000; ++probe)
  {
    const double value = f({ 0.2 + 0.6 * sampler.Next(), 1e-5 * sampler.Next() });
    ASSERT_GE(value, 0.025 * 0.99);
    ASSERT_LE(value, 0.025 * 1.01);
  }
}

/// Cells whose sizes grow with g from both sides: the integral of 1/f across is their number.
TEST(FeatureLimit, LeavesRoomForTheCellsAcross)
{
  constexpr double Width = 0.096;
  constexpr double Slope = 0.3;
  FeatureSource channel = Loops({ Rectangle(0.0, 0.0, 1.0, Width) });
  EXPECT_NEAR(WithFeatures(channel, 0.1)({ 0.5, 0.0 }), Width, Width * 0.01);
  for (const int cells : { 2, 3 })
  {
    channel.CellsAcross = cells;
    const double least = WithFeatures(channel, 0.1)({ 0.5, 0.0 });
    EXPECT_NEAR(2.0 / Slope * std::log1p(0.5 * Slope * Width / least), cells, 0.02 * cells);
  }
  channel.CellsAcross = 8;
  EXPECT_NEAR(WithFeatures(channel, 0.1)({ 0.5, 0.0 }), 0.025, 0.025 * 0.01);
  SpacingOptions options;
  options.Uniform = 0.1;
  options.Minimum = 0.001;
  channel.IsDownToMinimum = true;
  options.Features = Share(channel);
  EXPECT_NEAR(MakeGoodSpacing(options)({ 0.5, 0.0 }), 0.0062, 0.0001);
  options.Minimum = 0.015;
  EXPECT_NEAR(MakeGoodSpacing(options)({ 0.5, 0.0 }), 0.015, 1e-12);
}

/// Neighbors of neighbors on a bent outline are no walls of a channel.
TEST(FeatureLimit, CountsCellsAcrossBetweenLinesThatFaceEachOther)
{
  for (const int corners : { 12, 16, 60, 400 })
  {
    std::vector<Point2> circle;
    for (int k = 0; k < corners; ++k)
    {
      const double angle = 2.0 * 3.14159265358979324 * k / corners;
      circle.push_back({ std::cos(angle), std::sin(angle) });
    }
    FeatureSource source = Loops({ circle });
    const Spacing once = WithFeatures(source, 0.1);
    source.CellsAcross = 8;
    const Spacing more = WithFeatures(source, 0.1);
    for (const Point2& p : { Point2{ 1.0, 0.0 }, Midpoint(circle[0], circle[1]), Point2{} })
    {
      EXPECT_EQ(more(p), once(p)) << corners;
    }
    source.CellsAcross = 40; // more than fit between the far sides
    EXPECT_TRUE(corners > 100 || WithFeatures(source, 0.1)({ 1.0, 0.0 }) < 0.05);
  }
}

TEST(FeatureLimit, LeavesShortSegmentsNoShorterThanEdgesShouldBe)
{
  std::vector<Point2> loop = Rectangle(0.0, 0.0, 1.0, 1.0);
  loop.insert(loop.begin() + 1, { { 0.5, 0.0 }, { 0.5 + 1e-3, 0.0 } });
  const Spacing f = WithFeatures(Loops({ loop }), 0.1);
  EXPECT_NEAR(f({ 0.5, 0.0 }), 1.4e-3, 1.4e-5);
  EXPECT_LT(f({ 0.5, 0.0 }), std::sqrt(2.0) * 1e-3);
  EXPECT_NEAR(f({ 0.5, 0.1 }), 1.4e-3 + 0.03, 1e-3);
  EXPECT_EQ(f({ 0.5, 0.9 }), 0.1);
}

/// In a side of a square.
Spacing AroundSegment(double length)
{
  std::vector<Point2> loop = Rectangle(0.0, 0.0, 1.0, 1.0);
  loop.insert(loop.begin() + 1, { { 0.5, 0.0 }, { 0.5 + length, 0.0 } });
  return WithFeatures(Loops({ loop }), 0.1);
}

TEST(FeatureLimit, FollowsSegmentsAsShortAsFloatsTellLengthsApart)
{
  for (const double length : { 1e-3, 1e-5, 1e-7 })
  {
    EXPECT_NEAR(AroundSegment(length)({ 0.5, 0.0 }), 1.4 * length, 0.02 * length) << length;
  }
}

TEST(FeatureLimit, DoesNotFollowSegmentsShorterThanThat)
{
  EXPECT_NEAR(AroundSegment(1e-12)({ 0.5, 0.0 }), 0x1p-23 * 0.1, 1e-3 * 0x1p-23);
}

TEST(FeatureLimit, IsNotBelowTheMinimum)
{
  SpacingOptions options;
  options.Uniform = 0.1;
  options.Minimum = 0.08;
  options.Features = Share(Loops({ Rectangle(0.0, 0.0, 1.0, 0.01) }));
  EXPECT_NEAR(MakeGoodSpacing(options)({ 0.5, 0.0 }), 0.08, 1e-12);
}

TEST(FeatureLimit, LeavesAWideDomainAlone)
{
  const Spacing f = WithFeatures(Loops({ Rectangle(0.0, 0.0, 1.0, 1.0) }), 0.1);
  EXPECT_TRUE(f.IsUniform());
  EXPECT_EQ(f({ 0.0, 0.0 }), 0.1);
}

TEST(FeatureLimit, FindsANarrowPlaceInTheMiddleOfLongSegments)
{
  const Spacing f =
    WithFeatures(Loops({ Rectangle(0.0, 0.0, 1.0, 1.0),
                   { { 0.37, 0.5 }, { 0.5, 0.9 }, { 0.39, 0.51 }, { 0.372, 0.03 } } }),
      0.1);
  EXPECT_NEAR(f({ 0.372, 0.0 }), 0.03, 0.03 * 0.1);
  EXPECT_NEAR(f({ 0.9, 0.0 }), 0.1, 1e-12);
}

/// What is that fine will be refused: the limit may be left out, but not searched for without end.
TEST(FeatureLimit, IsNotSearchedForBeyondTheWantedNumberOfPieces)
{
  SpacingOptions options = With(MakeGrid(3, 3, [](const Point2& x) { return 1e-9 + 1e-9 * x.X; }));
  FeatureSource features =
    Loops({ Rectangle(0.0, 0.0, 1.0, 1.0), Rectangle(0.0, 1.0 + 1e-10, 1.0, 2.0) });
  features.MostPieces = 5000.0;
  options.Features = Share(features);
  const Spacing f = MakeGoodSpacing(options);
  EXPECT_NEAR(f({ 0.5, 1.0 }), 1.5e-9, 1e-12);
}

TEST(FeatureLimit, IsTheSameOnAnyNumberOfThreads)
{
  const FeatureSource hall = NarrowHall(1e-4);
  const Spacing expected = OnThreads(hall, 0.01, 1);
  for (const int threads : { 2, 3, 8 })
  {
    ExpectSameAlong(hall, OnThreads(hall, 0.01, threads), expected);
  }
}

/// The first 20,000 samples or so are those of the first segments, whoever takes them.
TEST(FeatureLimit, EndsAtTheSamePieceOnAnyNumberOfThreads)
{
  FeatureSource hall = NarrowHall(1e-5);
  hall.MostPieces = 3000.0;
  const Spacing expected = OnThreads(hall, 0.01, 1);
  EXPECT_LT(expected({ 0.905, 0.0 }), 2e-5);
  EXPECT_GT(expected({ 0.99, 0.0 }), 1e-3);
  for (const int threads : { 2, 3, 8 })
  {
    ExpectSameAlong(hall, OnThreads(hall, 0.01, threads), expected);
  }
}

TEST(FeatureLimit, IsLipschitz)
{
  std::vector<Point2> comb;
  for (int tooth = 0; tooth < 20; ++tooth)
  {
    comb.push_back({ 0.05 * tooth, 0.9 });
    comb.push_back({ 0.05 * tooth + 0.02, 0.05 });
  }
  comb.insert(comb.end(), { { 1.0, 1.0 }, { 0.0, 1.0 } });
  const Spacing f = WithFeatures(Loops({ comb }), 0.1);
  Sampler sampler(43);
  for (int probe = 0; probe < 20000; ++probe)
  {
    const Point2 x = sampler.NextIn(UnitBox());
    const Point2 y = x + 0.1 * (sampler.NextIn(UnitBox()) - Point2{ 0.5, 0.5 });
    if (UnitBox().Contains(y))
    {
      ASSERT_LE(std::abs(f(x) - f(y)), 0.3 * Distance(x, y) + 0.01 * std::min(f(x), f(y)));
    }
  }
}

TEST(FeatureLimit, FollowsWhatIsGiven)
{
  SpacingOptions options = With(MakeGrid(20, 20, [](const Point2& x) { return 0.02 + 0.2 * x.X; }));
  options.Features = Share(Loops({ Rectangle(0.0, 0.0, 1.0, 0.1) }));
  const Spacing f = MakeGoodSpacing(options);
  EXPECT_NEAR(f({ 0.1, 0.0 }), 0.04, 1e-3);
  EXPECT_NEAR(f({ 0.7, 0.0 }), 0.1, 1e-3);
}

TEST(FeatureLimit, IsNotInTheSpacingBeforeFeatures)
{
  SpacingOptions options = With(MakeScatter(40, 0.3, 3));
  options.Sources.emplace_back(
    Share(MakeGrid(20, 20, [](const Point2& x) { return 0.02 + 0.2 * x.X; })));
  const Spacing without = MakeGoodSpacing(options);
  options.Features = Share(Loops({ Rectangle(0.0, 0.0, 1.0, 0.02) }));
  const Spacing f = MakeGoodSpacing(options);
  Sampler sampler(47);
  int numberLower = 0;
  for (int probe = 0; probe < 2000; ++probe)
  {
    const Point2 x = sampler.NextIn(UnitBox());
    ASSERT_NEAR(f.BeforeFeatures(x), without(x), 0.01 * without(x));
    numberLower += f(x) < 0.95 * without(x) ? 1 : 0;
  }
  EXPECT_GT(numberLower, 50);
}

TEST(FeatureLimit, IsNoPartOfASpacingWithoutFeatures)
{
  SpacingOptions options = With(MakeScatter(40, 0.3, 3));
  const Spacing f = MakeGoodSpacing(options);
  EXPECT_EQ(f.BeforeFeatures({ 0.3, 0.4 }), f({ 0.3, 0.4 }));
}
