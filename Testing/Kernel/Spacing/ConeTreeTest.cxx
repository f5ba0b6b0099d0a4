// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Spacing/ConeTree.h"

#include "../Support/Monitors.h"
#include "../Support/TestThreads.h"
#include "Base/Numbers.h"
#include "SpacingSources.h"

#include <gtest/gtest.h>

namespace
{

using namespace biting;

std::vector<SegmentCone> ConesOf(const SegmentSource& source, double slope)
{
  Pulse pulse(NoMonitor());
  return MakeCones(source, 1.0, slope, pulse);
}

ConeTree<2> TreeOf(const SegmentSource& source, double slope, const Box2& box = UnitBox())
{
  return ConeTree<2>(ConesOf(source, slope), slope, box);
}

/// Of all cones, one by one.
struct Minimum
{
  std::vector<SegmentCone> Cones;
  double Slope;

  double operator()(const Point2& x) const
  {
    double least = std::numeric_limits<double>::infinity();
    for (const SegmentCone& cone : this->Cones)
    {
      least = std::min(least, cone(x, this->Slope));
    }
    return least;
  }
};

/// A closed curve of ever smaller bays, with the lengths of its segments as values.
SegmentSource Koch(int depth)
{
  std::vector<Point2> points{ { 0.2, 0.3 }, { 0.5, 0.82 }, { 0.8, 0.3 } };
  for (int level = 0; level < depth; ++level)
  {
    std::vector<Point2> finer;
    for (std::size_t k = 0; k < points.size(); ++k)
    {
      const Point2 step = (1.0 / 3.0) * (points[(k + 1) % points.size()] - points[k]);
      const Point2 tip = points[k] + 1.5 * step + 0.8660254 * Perpendicular(step);
      finer.insert(finer.end(), { points[k], points[k] + step, tip, points[k] + 2.0 * step });
    }
    points = finer;
  }
  SegmentSource source;
  source.Points = points;
  source.Values.assign(points.size(), 1.4 * Distance(points[0], points[1]));
  for (std::size_t k = 0; k < points.size(); ++k)
  {
    source.Segments.push_back(static_cast<Id>(k));
    source.Segments.push_back(static_cast<Id>((k + 1) % points.size()));
  }
  return source;
}

} // namespace

TEST(ConeTree, IsNowhereBelowTheMinimumAndAboveByItsToleranceAtMost)
{
  std::vector<SegmentSource> sources = SegmentCorpus();
  sources.push_back(Koch(4));
  for (const SegmentSource& source : sources)
  {
    for (double slope : { 0.02, 0.3, 1.0, 10.0 })
    {
      const Minimum exact{ ConesOf(source, slope), slope };
      const ConeTree<2> tree = TreeOf(source, slope);
      Sampler sampler(11);
      for (int probe = 0; probe < 10000; ++probe)
      {
        const Point2 x = sampler.NextIn(UnitBox());
        const double value = tree(x);
        const double least = exact(x);
        ASSERT_GE(value, least);
        ASSERT_LE(value, (1.0 + ConeTree<2>::Tolerance) * least) << slope;
      }
    }
  }
}

TEST(ConeTree, KeepsNoConeThatIsNowhereTheLowest)
{
  SegmentSource source = MakeLoop(50, [](double) { return 0.01; });
  for (std::size_t point = 0; point < 50; ++point)
  {
    source.Points.push_back(source.Points[point] + Point2{ 0.01, 0.0 });
    source.Values.push_back(0.5);
    source.Segments.insert(source.Segments.end(), 2, static_cast<Id>(50 + point));
  }
  EXPECT_LE(TreeOf(source, 0.3).NumberOfCones(), 50u);
}

TEST(ConeTree, HasListsInProportionToItsCones)
{
  const auto entriesPerCone = [](int depth)
  {
    const SegmentSource source = Koch(depth);
    return static_cast<double>(TreeOf(source, 0.3).NumberOfEntries()) /
      static_cast<double>(source.Points.size());
  };
  EXPECT_LE(entriesPerCone(6), 1.5 * entriesPerCone(4));
  EXPECT_LE(entriesPerCone(6), 120.0);
}

TEST(ConeTree, IsTheNearestValueBeyondItsBox)
{
  const ConeTree<2> tree = TreeOf(MakeScatter(20, 0.2, 17), 0.3);
  EXPECT_EQ(tree({ 7.0, 0.25 }), tree({ 1.0, 0.25 }));
  EXPECT_EQ(tree({ -7.0, 9.0 }), tree({ 0.0, 1.0 }));
}

TEST(ConeTree, IsInfiniteOnlyWhereAllIsAboveWhatMatters)
{
  const SegmentSource source = MakeLoop(400, [](double) { return 0.004; });
  const Minimum exact{ ConesOf(source, 0.3), 0.3 };
  constexpr double Most = 0.03;
  const ConeTree<2> tree(ConesOf(source, 0.3), 0.3, UnitBox(), Most);
  Sampler sampler(22);
  for (int probe = 0; probe < 2000; ++probe)
  {
    const Point2 x = sampler.NextIn(UnitBox());
    ASSERT_TRUE(exact(x) >= Most || tree(x) <= (1.0 + ConeTree<2>::Tolerance) * exact(x));
  }
  EXPECT_LT(tree.NumberOfEntries(), TreeOf(source, 0.3).NumberOfEntries());
}

TEST(ConeTree, TakesBoxesOfAnyProportion)
{
  const SegmentSource source = MakeScatter(20, 0.2, 18);
  const Minimum exact{ ConesOf(source, 0.3), 0.3 };
  const Box2 thin{ { 0.0, 0.4 }, { 1.0, 0.4 + 1e-7 } };
  const ConeTree<2> tree = TreeOf(source, 0.3, thin);
  Sampler sampler(19);
  for (int probe = 0; probe < 2000; ++probe)
  {
    const Point2 x = sampler.NextIn(thin);
    ASSERT_NEAR(tree(x) / exact(x), 1.0, ConeTree<2>::Tolerance);
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
  const Minimum exact{ ConesOf(source, 0.3), 0.3 };
  const ConeTree<2> tree = TreeOf(source, 0.3, box);
  double largest = 0.0;
  for (int part = 0; part <= 16; ++part)
  {
    const double x = std::min(box.Low.X + part / 16.0 * box.Width(), box.High.X);
    const double y = std::min(box.Low.Y + part / 16.0 * box.Height(), box.High.Y);
    for (const Point2& place : { Point2{ x, box.High.Y }, Point2{ box.High.X, y } })
    {
      largest = std::max(largest, std::abs(tree(place) / exact(place) - 1.0));
    }
  }
  return largest;
}

TEST(ConeTree, IsWithinItsToleranceOnABorderThatRoundingMovesIntoTheNextSquare)
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

TEST(ConeTree, IsTheMinimumWhereTheSlopeIsLostInRounding)
{
  for (const double gradation : { 1e-200, 1e-20, 1e-16 })
  {
    const SegmentSource source = MakeScatter(40, 0.5, 3);
    const Minimum exact{ ConesOf(source, gradation), gradation };
    const ConeTree<2> tree = TreeOf(source, gradation);
    Sampler sampler(5);
    for (int probe = 0; probe < 100; ++probe)
    {
      const Point2 x = sampler.NextIn(UnitBox());
      ASSERT_NEAR(tree(x), exact(x), ConeTree<2>::Tolerance * exact(x)) << gradation;
    }
  }
}

/// Centers of squares lie on the segments, where rounding turns the way from a segment.
TEST(ConeTree, IsWithinItsToleranceWhereSegmentsGoThroughCentersOfSquares)
{
  for (const double turn : { 0.0, 0.1, 1.0 / 3.0, 0.5 })
  {
    SegmentSource source;
    for (int line = 0; line < 12; ++line)
    {
      const double angle = 3.141592653589793 * (turn + line) / 12.0;
      const Point2 arm{ 0.5 * std::cos(angle), 0.5 * std::sin(angle) };
      source.Points.insert(
        source.Points.end(), { Point2{ 0.5, 0.5 } - arm, Point2{ 0.5, 0.5 } + arm });
      source.Values.insert(source.Values.end(), { 0.001 * (1 + line % 3), 0.002 * (1 + line % 5) });
      source.Segments.insert(source.Segments.end(), { 2 * line, 2 * line + 1 });
    }
    const Minimum exact{ ConesOf(source, 0.3), 0.3 };
    const ConeTree<2> tree = TreeOf(source, 0.3);
    Sampler sampler(13);
    for (int probe = 0; probe < 20000; ++probe)
    {
      const Point2 x = sampler.NextIn(UnitBox());
      ASSERT_LE(tree(x), (1.0 + ConeTree<2>::Tolerance) * exact(x));
    }
  }
}

TEST(ConeTree, StopsWhenAsked)
{
  StoppingMonitor monitor(2);
  ConeTree<2>(ConesOf(Koch(5), 0.3), 0.3, UnitBox(), Infinity, monitor);
  EXPECT_TRUE(monitor.HasStopped());
  EXPECT_EQ(monitor.Calls, 3);
}

/// Found by fuzzing: without gradation the slope along a segment as short as rounding was that of
/// all cones, and the tree was refined down to rounding along every bundle of segments.
TEST(ConeTree, HasFewLeavesWhereValuesJumpWithoutGradation)
{
  SegmentSource source;
  for (int k = 0; k < 40; ++k)
  {
    source.Points.push_back({ 0.1 + 0.8 * (k % 2), 0.5 + 1e-13 * k });
    source.Values.push_back(0.1 + 0.01 * (k % 7));
    source.Segments.insert(source.Segments.end(), { std::max(k - 1, 0), k });
  }
  source.Points.push_back(source.Points.back() + Point2{ 0.0, 1e-13 });
  source.Values.push_back(0.5);
  source.Segments.insert(source.Segments.end(), { 39, 40 });
  EXPECT_LE(TreeOf(source, SlopeOfCones(source, 0.0)).NumberOfEntries(), 100000u);
}

/// Of a tree, in 4096 comparisons of cones.
int WorkOf(const SegmentSource& source, double slope)
{
  StoppingMonitor monitor(std::numeric_limits<int>::max());
  ConeTree<2>(ConesOf(source, slope), slope, UnitBox(), Infinity, monitor);
  return monitor.Calls;
}

/// A ring whose radius is noise of half a segment: cones that nearly tie in all squares.
SegmentSource NoisyRing(int count)
{
  SegmentSource ring = MakeLoop(count, [count](double) { return 0.3 / count; });
  Sampler sampler(31);
  for (Point2& point : ring.Points)
  {
    const double part = 1.0 + 6.0 / count * (sampler.Next() - 0.5);
    point = Point2{ 0.5, 0.5 } + part * (point - Point2{ 0.5, 0.5 });
  }
  return ring;
}

TEST(ConeTree, TakesTimeNearlyLinearInTheSegmentsOfANoisyRing)
{
  const auto comparisonsOf = [](int count)
  { return 4096.0 * WorkOf(NoisyRing(count), 0.3) / count; };
  const double ofMany = comparisonsOf(12000);
  EXPECT_LE(ofMany, 1.6 * comparisonsOf(3000));
  EXPECT_LE(ofMany, 750.0);
}

/// Lines as long as the box, beside each other at distances that nobody sees.
SegmentSource Stripes(int count, int parts, double value)
{
  SegmentSource source;
  for (int stripe = 0; stripe < count; ++stripe)
  {
    for (int part = 0; part <= parts; ++part)
    {
      const auto point = static_cast<Id>(source.Points.size());
      source.Points.push_back({ static_cast<double>(part) / parts, 0.5 + 1e-6 * stripe });
      source.Values.push_back(value);
      source.Segments.insert(source.Segments.end(), { std::max(point - (part > 0), 0), point });
    }
  }
  return source;
}

TEST(ConeTree, TakesNoLongerForASegmentWhereMoreAreCloseTogether)
{
  for (const int stripes : { 20, 80 })
  {
    EXPECT_LE(
      WorkOf(Stripes(stripes, 100, 0.002), 0.3), WorkOf(MakeScatter(100 * stripes, 0.002, 5), 0.3));
  }
}

/// Found in a drawing of 200 interfaces, with Gradation 10: boxes of a thousandth of f.
TEST(ConeTree, DoesNotFollowSlopesThatNobodySees)
{
  SegmentSource stripes = Stripes(100, 1, 0.02);
  Sampler sampler(3);
  for (Point2& point : stripes.Points)
  {
    point.X = point.X < 0.5 ? 0.5 * sampler.Next() : 0.5 + 0.5 * sampler.Next();
  }
  EXPECT_LE(TreeOf(stripes, 10.0).NumberOfEntries(), 150000u);
}

TEST(ConeTree, TakesNoLongerForPointsInDisorder)
{
  SegmentSource ordered;
  SegmentSource disordered;
  for (Id k = 0; k < 3000; ++k)
  {
    ordered.Points.push_back({ k / 3000.0, 0.5 });
    disordered.Points.push_back({ k * 1471 % 3000 / 3000.0, 0.5 });
    ordered.Segments.insert(ordered.Segments.end(), { k, k });
  }
  ordered.Values.assign(3000, 3e-5);
  disordered.Values = ordered.Values;
  disordered.Segments = ordered.Segments;
  EXPECT_LE(WorkOf(disordered, 0.3), 1.1 * WorkOf(ordered, 0.3));
}

/// Squares that are cut by several tasks, whatever the number of threads.
TEST(ConeTree, IsTheSameOnAnyNumberOfThreads)
{
  const std::vector<SegmentCone> cones = ConesOf(MakeScatter(20000, 0.001, 27), 0.3);
  const ConeTree<2> expected(cones, 0.3, UnitBox());
  for (const int threads : { 2, 3, 8 })
  {
    MonitorWithThreads monitor(threads);
    const ConeTree<2> tree(cones, 0.3, UnitBox(), std::numeric_limits<double>::infinity(), monitor);
    EXPECT_EQ(tree.NumberOfEntries(), expected.NumberOfEntries());
    EXPECT_EQ(tree.NumberOfCones(), expected.NumberOfCones());
    Sampler sampler(28);
    for (int probe = 0; probe < 5000; ++probe)
    {
      const Point2 x = sampler.NextIn(UnitBox());
      ASSERT_EQ(tree(x), expected(x));
    }
  }
}

TEST(ConeTree, IsTheMinimumOfManyConesToo)
{
  const SegmentSource source = MakeScatter(20000, 0.001, 29);
  const Minimum exact{ ConesOf(source, 0.3), 0.3 };
  const ConeTree<2> tree = TreeOf(source, 0.3);
  Sampler sampler(30);
  for (int probe = 0; probe < 500; ++probe)
  {
    const Point2 x = sampler.NextIn(UnitBox());
    const double least = exact(x);
    ASSERT_GE(tree(x), least);
    ASSERT_LE(tree(x), (1.0 + ConeTree<2>::Tolerance) * least);
  }
}
