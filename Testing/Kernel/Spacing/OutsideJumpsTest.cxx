// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Spacing/OutsideJumps.h"

#include "SpacingSources.h"
#include "Support/Monitors.h"
#include "Support/TestThreads.h"

#include <gtest/gtest.h>

#include <algorithm> // for fill, count_if

namespace
{

using namespace biting;

SegmentSource JumpsOf(const TriangulatedSource& source, Monitor& monitor = NoMonitor())
{
  const TriangleInterpolator field(Share(source));
  ConeCollector cones({ 1.0, 0.0, 1e9 });
  EXPECT_TRUE(AddOutsideJumps(field, UnitBox(), Gradation, cones, monitor));
  return cones.Segments();
}

/// Strips along the lower and the upper side of the unit square, with a value each.
TriangulatedSource Strips(double low, double high)
{
  return { { { 0.0, 0.0 }, { 1.0, 0.0 }, { 1.0, 0.4 }, { 0.0, 0.4 }, { 0.0, 0.6 }, { 1.0, 0.6 },
             { 1.0, 1.0 }, { 0.0, 1.0 } },
    { low, low, low, low, high, high, high, high }, { 0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7 } };
}

/// The corners of a square, at which f is low and high in turns: what is nearest to most places.
TriangulatedSource Corners(double low, double high)
{
  TriangulatedSource source;
  for (const Point2& corner :
    { Point2{ 0.0, 0.0 }, Point2{ 1.0, 0.0 }, Point2{ 1.0, 1.0 }, Point2{ 0.0, 1.0 } })
  {
    const auto first = static_cast<Id>(source.Points.size());
    const Point2 inwards = 0.02 * (Point2{ 0.5, 0.5 } - corner);
    source.Points.insert(
      source.Points.end(), { corner, corner + inwards, corner + Point2{ inwards.X, 0.0 } });
    source.Values.insert(source.Values.end(), 3, first % 2 == 0 ? low : high);
    source.Triangles.insert(source.Triangles.end(), { first, first + 1, first + 2 });
  }
  return source;
}

/// Triangles that meet in the middle of the unit square, with gaps as wide as they are.
TriangulatedSource Star(int spikes)
{
  TriangulatedSource source{ { { 0.5, 0.5 } }, { 0.01 }, {} };
  Sampler sampler(3);
  for (Id spike = 0; spike < spikes; ++spike)
  {
    const auto first = static_cast<Id>(source.Points.size());
    for (const double turn : { 0.0, 0.5 })
    {
      const double angle = 6.283185307179586 * (spike + turn) / spikes;
      source.Points.push_back({ 0.5 + 0.45 * std::cos(angle), 0.5 + 0.45 * std::sin(angle) });
    }
    source.Values.insert(source.Values.end(), 2, 0.02 + 0.08 * sampler.Next());
    source.Triangles.insert(source.Triangles.end(), { 0, first, first + 1 });
  }
  return source;
}

/// Whether no corner of the other triangle is on the inner side of some side of one.
bool HasOutside(const Point2* corners, const Point2* others)
{
  for (int k = 0; k < 3; ++k)
  {
    const Point2 along = corners[(k + 1) % 3] - corners[k];
    const double inner = Cross(along, corners[(k + 2) % 3] - corners[k]);
    if (std::all_of(others, others + 3,
          [&along, inner, corners, k](const Point2& other)
          { return Cross(along, other - corners[k]) * inner < 0.0; }))
    {
      return true;
    }
  }
  return false;
}

/// No two of them meet; some are thirty times as long as others, or as they are wide. Values
/// differ by up to `range`, as a factor.
TriangulatedSource LooseTriangles(std::size_t count, double range)
{
  TriangulatedSource source;
  Sampler sampler(4);
  const double size = 1.0 / std::sqrt(static_cast<double>(count));
  while (source.Points.size() < 3 * count)
  {
    const Point2 center = sampler.NextIn(UnitBox());
    const double length = size * std::pow(30.0, sampler.Next() - 0.8);
    const double width = length * std::pow(30.0, -sampler.Next());
    const double turn = 6.283185307179586 * sampler.Next();
    const Point2 axis{ std::cos(turn), std::sin(turn) };
    const Point2 corners[3] = { center - length * axis, center + length * axis,
      center + width * Perpendicular(axis) };
    bool isLoose = true;
    for (std::size_t first = 0; first < source.Points.size() && isLoose; first += 3)
    {
      const Point2* other = &source.Points[first];
      isLoose = HasOutside(corners, other) || HasOutside(other, corners);
    }
    for (int k = 0; k < 3 && isLoose; ++k)
    {
      source.Triangles.push_back(static_cast<Id>(source.Points.size()));
      source.Points.push_back(corners[k]);
      source.Values.push_back(size * std::pow(range, sampler.Next() - 0.9));
    }
  }
  return source;
}

/// Of places near each other, most of them within some f.
void ExpectLaw(const TriangulatedSource& source, double gradation, int pairs)
{
  SpacingOptions options = WithTriangles(source);
  options.Gradation = gradation;
  const Spacing f = MakeGoodSpacing(options);
  Sampler sampler(9);
  for (int pair = 0; pair < pairs; ++pair)
  {
    const Point2 x = sampler.NextIn(UnitBox());
    const double reach = f(x) * std::exp(4.0 * sampler.Next() - 3.0);
    const Point2 y = x + reach * (sampler.NextIn(UnitBox()) - Point2{ 0.5, 0.5 });
    ASSERT_LE(std::abs(f(x) - f(y)), gradation * Distance(x, y) + 0.02 * std::min(f(x), f(y)))
      << x.X << ' ' << x.Y;
  }
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

/// Straight ones are some segments, whatever f is.
TEST(OutsideJumps, AreFewSegmentsHoweverLongTheyAre)
{
  for (const double low : { 0.05, 0.005, 1e-3, 1e-5 })
  {
    EXPECT_LT(JumpsOf(Corners(low, 1.0)).Segments.size() / 2, 2000u) << low;
  }
}

TEST(OutsideJumps, AreNearTheLineBetweenPartsWhateverItsDirection)
{
  TriangulatedSource source = Corners(0.005, 1.0);
  source.Values.assign(12, 1.0);
  std::fill(source.Values.begin(), source.Values.begin() + 3, 0.005);
  // The first corner is nearest below and left of the lines in the middle between it and others.
  const SegmentSource cones = JumpsOf(source);
  double length = 0.0;
  for (std::size_t k = 0; k < cones.Segments.size(); k += 2)
  {
    const Point2& start = cones.Points[static_cast<std::size_t>(cones.Segments[k])];
    const Point2& end = cones.Points[static_cast<std::size_t>(cones.Segments[k + 1])];
    length += Distance(start, end);
    for (const Point2& place : { start, end, Midpoint(start, end) })
    {
      const double away = std::min(std::abs(place.X - 0.5), std::abs(place.Y - 0.5));
      EXPECT_LT(away, 0.03 * 0.005 / Gradation + 0.02);
    }
  }
  EXPECT_GT(length, 0.9);
}

TEST(OutsideJumps, HaveTheValueOfTheLowerSideHoweverLongTheyAre)
{
  for (const double low : { 1e-3, 1e-5 })
  {
    for (const double value : JumpsOf(Corners(low, 1.0)).Values)
    {
      ASSERT_DOUBLE_EQ(value, low);
    }
  }
}

/// Found by fuzzing: halving what is between down to a share of f, which rounding does not allow.
TEST(OutsideJumps, AreFoundWhereFIsFarBelowRounding)
{
  EXPECT_LT(JumpsOf(Corners(1e-200, 1.0)).Segments.size(), 400000u);
}

/// The monitor is called once in so many steps of rays.
TEST(OutsideJumps, TakeStepsLinearInTheSpikesThatMeetInAHub)
{
  constexpr int MostCalls = 1 << 30;
  StoppingMonitor few(MostCalls);
  StoppingMonitor many(MostCalls);
  EXPECT_LT(JumpsOf(Star(100), few).Segments.size() / 2, 100u * 40u);
  EXPECT_LT(JumpsOf(Star(800), many).Segments.size() / 2, 800u * 40u);
  EXPECT_LT(many.Calls, 10 * few.Calls);
}

/// Gaps are some thousandths of f wide.
TEST(OutsideJumps, KeepTheLawWhereSpikesMeetInAHub)
{
  ExpectLaw(Star(400), Gradation, 20000);
}

/// Its long edge is some 200 f long, and all of its first rays pass the small one.
TEST(OutsideJumps, AreFoundBeforeALongEdgeWhereSomethingSmallIsNear)
{
  TriangulatedSource source{ { { 0.05, 0.1 }, { 0.95, 0.1 }, { 0.5, 0.05 } }, {}, { 0, 1, 2 } };
  for (const double x : { 0.21, 0.3301, 0.447, 0.556, 0.673, 0.781 })
  {
    const auto first = static_cast<Id>(source.Points.size());
    source.Points.insert(
      source.Points.end(), { { x, 0.104 }, { x + 0.002, 0.104 }, { x + 0.001, 0.107 } });
    source.Triangles.insert(source.Triangles.end(), { first, first + 1, first + 2 });
  }
  source.Values.assign(source.Points.size(), 0.05);
  std::fill(source.Values.begin(), source.Values.begin() + 3, 0.001);
  ExpectLaw(source, 1.0, 40000);
}

/// Of all sizes and shapes.
TEST(OutsideJumps, KeepTheLawBetweenLooseTriangles)
{
  for (const double gradation : { 0.3, 1.0, 3.0 })
  {
    ExpectLaw(LooseTriangles(120, 50.0), gradation, 40000);
    ExpectLaw(LooseTriangles(30, 1e5), gradation, 10000);
  }
}

/// Between two corners, in a hole that is small beside the bounds.
TEST(OutsideJumps, AreFoundBetweenCornersInASmallHole)
{
  const Point2 center{ 0.337, 0.613 };
  const auto field = [&center](const Point2& x)
  {
    const Point2 offset = x - center;
    return Length(offset) < 0.02 ? NotANumber : offset.X + 0.3 * offset.Y < 0.0 ? 0.01 : 1.0;
  };
  const SegmentSource cones = JumpsOf(MakeTriangulation(201, field));
  double least = 1.0;
  for (const Point2& place : cones.Points)
  {
    least = std::min(least, Distance(place, center));
  }
  EXPECT_LT(least, 0.005);
}

/// Only the rays from the left part of the long edge meet the bounds, and none of its ends sees the
/// triangle above.
TEST(OutsideJumps, AreFoundBeforeEdgesThatLeaveTheBounds)
{
  const TriangulatedSource source{ { { 0.2, 0.9 }, { 1.8, 1.1 }, { 1.0, 0.5 }, { 0.3, 0.98 },
                                     { 0.5, 0.98 }, { 0.4, 1.2 } },
    { 0.001, 0.001, 0.001, 1.0, 1.0, 1.0 }, { 0, 1, 2, 3, 4, 5 } };
  double least = 1.0;
  for (const Point2& place : JumpsOf(source).Points)
  {
    least = std::min(least, Distance(place, { 0.4, 0.9525 }));
  }
  EXPECT_LT(least, 0.01);
}

/// What is nearest to the middle one of three tips widens from where it is far narrower than f.
TEST(OutsideJumps, AreFoundOnBothSidesOfWhatIsNearestToATipBetweenOthers)
{
  TriangulatedSource source;
  for (const double value : { 0.42, 0.32, 0.42 })
  {
    const auto tip = static_cast<Id>(source.Points.size());
    const Point2 place{ 0.48 + 0.02 / 3.0 * tip, 0.9 };
    source.Points.insert(source.Points.end(),
      { place, place + Point2{ -0.005, 0.02 }, place + Point2{ 0.005, 0.02 } });
    source.Values.insert(source.Values.end(), 3, value);
    source.Triangles.insert(source.Triangles.end(), { tip, tip + 1, tip + 2 });
  }
  SpacingOptions options = WithTriangles(source);
  options.Gradation = 0.1;
  const Spacing f = MakeGoodSpacing(options);
  for (const double y : { 0.1, 0.3, 0.5, 0.7, 0.85 })
  {
    EXPECT_EQ(f({ 0.5, y }), 0.32);
    EXPECT_NEAR(f({ 0.485, y }), 0.32 + 0.1 * 0.005, 0.004) << y;
    EXPECT_NEAR(f({ 0.515, y }), 0.32 + 0.1 * 0.005, 0.004) << y;
  }
}

/// Along the lower edge of the triangle it is up to x = 0.65.
TEST(OutsideJumps, OfSheetsAreAtTheLeastValueWhereverItRaisesWhatIsGiven)
{
  TriangulatedSource source = MakeTriangulation(2, [](const Point2&) { return 1.0; });
  source.Points.insert(source.Points.end(), { { 0.2, 0.2 }, { 0.8, 0.2 }, { 0.5, 0.8 } });
  source.Values.insert(source.Values.end(), { 0.01, 0.13, 0.07 });
  source.Triangles.insert(source.Triangles.end(), { 4, 5, 6 });
  source.MayOverlap = true;
  SpacingOptions options = WithTriangles(source);
  options.Minimum = 0.1;
  const Spacing f = MakeGoodSpacing(options);
  for (double x = 0.2; x < 0.65; x += 0.05)
  {
    EXPECT_NEAR(f({ x, 0.19 }), 0.1 + Gradation * 0.01, 0.002) << x;
  }
}

/// They reach it at x = 0.444, and are cut from there on.
TEST(OutsideJumps, BesideOtherCornersAreNotBelowValuesThatReachTheGreatestOne)
{
  const TriangulatedSource source{ { { 0.0, 0.0 }, { 1.0, 0.0 }, { 1.0, 0.5 }, { 0.0, 0.5 },
                                     { 0.0, 0.5 }, { 1.0, 0.5 }, { 1.0, 1.0 }, { 0.0, 1.0 } },
    { 0.02, 0.2, 0.2, 0.02, 1.0, 1.0, 1.0, 1.0 }, { 0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7 } };
  SpacingOptions options = WithTriangles(source);
  options.Maximum = 0.1;
  const Spacing f = MakeGoodSpacing(options);
  EXPECT_NEAR(f({ 0.4, 0.499 }), 0.02 + 0.18 * 0.4, 0.001);
  EXPECT_NEAR(f({ 0.4, 0.501 }), 0.02 + 0.18 * 0.4, 0.001);
  EXPECT_NEAR(f({ 0.6, 0.501 }), 0.1, 0.001);
}

/// A border that is several tasks.
TEST(OutsideJumps, AreTheSameOnAnyNumberOfThreads)
{
  const TriangulatedSource source = MakeTriangulation(81,
    [](const Point2& x)
    {
      const double wave = std::sin(20.0 * x.X) * std::sin(20.0 * x.Y);
      return wave > 0.2 ? NotANumber : 0.02 + 0.01 * wave + (x.X < 0.47 ? 0.1 : 0.0);
    });
  ASSERT_GT(TriangleInterpolator(Share(source)).BorderEdges().size(), 600u);
  const SegmentSource expected = JumpsOf(source);
  ASSERT_FALSE(expected.Segments.empty());
  for (const int threads : { 2, 3 })
  {
    MonitorWithThreads monitor(threads);
    const SegmentSource found = JumpsOf(source, monitor);
    EXPECT_EQ(found.Points, expected.Points);
    EXPECT_EQ(found.Values, expected.Values);
    EXPECT_EQ(found.Segments, expected.Segments);
  }
}

/// As where a part of a dataset was appended to it.
TEST(OutsideJumps, AreNoneWhereTrianglesOfTheSameValuesLieOnEachOther)
{
  TriangulatedSource source =
    MakeTriangulation(6, [](const Point2& x) { return 0.05 + 0.1 * x.X + 0.05 * x.Y; });
  const std::vector<Id> whole = source.Triangles;
  for (std::size_t first = 0; first < whole.size(); first += 3)
  {
    const Point2& corner = source.Points[static_cast<std::size_t>(whole[first])];
    if (corner.X > 0.1 && corner.X < 0.3)
    {
      source.Triangles.insert(
        source.Triangles.end(), whole.begin() + first, whole.begin() + first + 3);
    }
  }
  source.MayOverlap = true;
  const Spacing f = MakeGoodSpacing(WithTriangles(source));
  Sampler sampler(5);
  for (int k = 0; k < 1000; ++k)
  {
    const Point2 x{ sampler.Next(), k % 2 == 0 ? 0.0 : sampler.Next() };
    EXPECT_NEAR(f(x), 0.05 + 0.1 * x.X + 0.05 * x.Y, 1e-12);
  }
}

/// There the triangles themselves are searched, not only their border.
TEST(OutsideJumps, AreTheSameWhereTrianglesMayOverlapButDoNot)
{
  TriangulatedSource source = Corners(0.02, 1.0);
  source.MayOverlap = true;
  const SpacingOptions sheets = WithTriangles(source);
  source.MayOverlap = false;
  const Spacing f = MakeGoodSpacing(WithTriangles(source));
  const Spacing ofSheets = MakeGoodSpacing(sheets);
  Sampler sampler(5);
  for (int k = 0; k < 1000; ++k)
  {
    const Point2 x = sampler.NextIn(UnitBox());
    EXPECT_NEAR(ofSheets(x), f(x), 0.01 * f(x));
  }
}
