// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Biting/BiteOutline.h"
#include "../Support/MeshShapes.h"

#include <gtest/gtest.h>

#include <algorithm> // for any_of

namespace biting
{

namespace
{

Bites MakeBites(
  const std::vector<Point2>& centers, const std::vector<Point2>& axes, double halfWidth)
{
  Bites bites;
  bites.Centers = centers;
  bites.Axes = axes;
  bites.HalfWidths.assign(centers.size(), halfWidth);
  return bites;
}

Bites AlignedBites(const std::vector<Point2>& centers, double halfWidth)
{
  return MakeBites(centers, std::vector<Point2>(centers.size(), { 1.0, 0.0 }), halfWidth);
}

BiteOutline OutlineOf(const Bites& bites, Id bite)
{
  BiteOutline outline;
  outline.Begin(bites, bite);
  for (Id other = 0; other < bites.Size(); ++other)
  {
    if (other != bite)
    {
      outline.Cover(bites, other);
    }
  }
  outline.Finish();
  return outline;
}

/// A place that is not near another bite's side lies in a gap, or in another bite.
void CheckAgainstSamples(const Bites& bites)
{
  constexpr int Samples = 200;
  constexpr double Near = 1e-9;
  const BiteOutline outline = OutlineOf(bites, 0);
  for (int side = 0; side < 4; ++side)
  {
    for (int k = 0; k <= Samples; ++k)
    {
      const double place = bites.HalfWidths[0] * (2.0 * k / Samples - 1.0);
      const Point2 p = outline.At(side, place);
      double depth = -1e300;
      for (Id other = 1; other < bites.Size(); ++other)
      {
        depth = std::max(depth, Depth(bites, other, p));
      }
      const std::vector<BiteOutline::Interval>& gaps = outline.Gaps(side);
      const bool isInGap = std::any_of(gaps.begin(), gaps.end(),
        [place](const BiteOutline::Interval& gap)
        { return place >= gap.Low && place <= gap.High; });
      ASSERT_TRUE(std::abs(depth) < Near || isInGap == (depth < 0.0));
    }
  }
}

Bites RandomSurroundings(bool areTurned, TestNumbers& numbers)
{
  Bites bites;
  const int count = 2 + numbers.Below(8);
  for (int k = 0; k < count; ++k)
  {
    bites.Centers.push_back({ 1.5 * numbers.Unit(), 1.5 * numbers.Unit() });
    bites.Axes.push_back(areTurned ? UnitVector(DegreesPerTurn * numbers.Unit())
                                   : UnitVector(90.0 * numbers.Below(2)));
    bites.HalfWidths.push_back(0.2 + 0.5 * numbers.Unit());
  }
  return bites;
}

/// Bit k of `circles` says whether every second bite, from bite k, is a circle.
Bites RandomMixture(int circles, TestNumbers& numbers)
{
  Bites bites = RandomSurroundings(true, numbers);
  for (Id bite = 0; bite < bites.Size(); ++bite)
  {
    bites.Axes[bite] = (circles >> (bite % 2) & 1) != 0 ? Point2{} : bites.Axes[bite];
  }
  return bites;
}

TEST(BiteOutline, LoneBiteIsAllGap)
{
  const Bites bites = MakeBites({ { 1.0, 2.0 } }, { UnitVector(30.0) }, 0.5);
  const BiteOutline outline = OutlineOf(bites, 0);
  int ends = 0;
  outline.VisitEnds(
    [&](const Point2& p)
    {
      ++ends;
      EXPECT_NEAR(Distance(p, { 1.0, 2.0 }), std::sqrt(0.5), 1e-15);
    });
  EXPECT_EQ(ends, 4);
  for (int side = 0; side < 4; ++side)
  {
    ASSERT_EQ(outline.Gaps(side).size(), 1u);
    EXPECT_EQ(outline.Gaps(side)[0].Low, -0.5);
    EXPECT_EQ(outline.Gaps(side)[0].High, 0.5);
    EXPECT_NEAR(Depth(bites, 0, outline.At(side, 0.25)), 0.0, 1e-15);
  }
}

TEST(BiteOutline, GapsAreWhatSamplesFindForAlignedSquares)
{
  TestNumbers numbers(1);
  for (int run = 0; run < 100; ++run)
  {
    CheckAgainstSamples(RandomSurroundings(false, numbers));
  }
}

TEST(BiteOutline, GapsAreWhatSamplesFindForTurnedSquares)
{
  TestNumbers numbers(2);
  for (int run = 0; run < 100; ++run)
  {
    CheckAgainstSamples(RandomSurroundings(true, numbers));
  }
}

TEST(BiteOutline, GapsAreWhatSamplesFindForCirclesAndSquares)
{
  TestNumbers numbers(7);
  for (int run = 0; run < 900; ++run)
  {
    CheckAgainstSamples(RandomMixture(1 + run % 3, numbers));
  }
}

TEST(BiteOutline, PlacesOfACircleLieOnIt)
{
  const Bites bites = MakeBites({ { 1.0, 2.0 } }, { Point2{} }, 0.5);
  const BiteOutline outline = OutlineOf(bites, 0);
  outline.VisitEnds([](const Point2&) { FAIL() << "a circle has no corners"; });
  for (int side = 0; side < 4; ++side)
  {
    ASSERT_EQ(outline.Gaps(side).size(), 1u);
    for (const double place : { -0.5, -0.2, 0.0, 0.5 })
    {
      EXPECT_NEAR(Distance(outline.At(side, place), { 1.0, 2.0 }), 0.5, 1e-15);
    }
  }
}

TEST(BiteOutline, EndsOfACircleAreWhereItMeetsOthers)
{
  const Bites bites =
    MakeBites({ { 0.0, 0.0 }, { 1.0, 0.0 }, { -1.5, 0.0 } }, { {}, {}, { 1.0, 0.0 } }, 1.0);
  const BiteOutline outline = OutlineOf(bites, 0);
  int ends = 0;
  outline.VisitEnds(
    [&](const Point2& p)
    {
      ++ends;
      EXPECT_NEAR(Length(p), 1.0, 1e-15);
      EXPECT_NEAR(std::abs(p.X), 0.5, 1e-15);
    });
  EXPECT_EQ(ends, 4);
}

TEST(BiteOutline, SidesThatCoincideCoverNeither)
{
  const Bites bites = AlignedBites({ { 0.0, 0.0 }, { 2.0, 0.0 }, { 1.0, 0.0 } }, 1.0);
  const BiteOutline beside = OutlineOf(AlignedBites({ { 0.0, 0.0 }, { 2.0, 0.0 } }, 1.0), 0);
  ASSERT_EQ(beside.Gaps(0).size(), 1u);
  EXPECT_EQ(beside.Gaps(0)[0].High - beside.Gaps(0)[0].Low, 2.0);
  const BiteOutline first = OutlineOf(bites, 0);
  EXPECT_TRUE(first.Gaps(0).empty());
  EXPECT_EQ(first.Gaps(1).size(), 1u);
  EXPECT_EQ(first.Gaps(1)[0].High - first.Gaps(1)[0].Low, 2.0);
}

TEST(BiteOutline, QuarterTurnsOfAnAxisAreTheSameSquare)
{
  TestNumbers numbers(3);
  for (int run = 0; run < 50; ++run)
  {
    Bites bites = RandomSurroundings(false, numbers);
    const Point2 axis = UnitVector(37.0);
    bites.Axes.assign(bites.Centers.size(), axis);
    const BiteOutline straight = OutlineOf(bites, 0);
    for (std::size_t other = 1; other < bites.Axes.size(); ++other)
    {
      bites.Axes[other] = Perpendicular(bites.Axes[other - 1]);
    }
    const BiteOutline turned = OutlineOf(bites, 0);
    for (int side = 0; side < 4; ++side)
    {
      ASSERT_EQ(straight.Gaps(side).size(), turned.Gaps(side).size());
      for (std::size_t gap = 0; gap < straight.Gaps(side).size(); ++gap)
      {
        EXPECT_EQ(straight.Gaps(side)[gap].Low, turned.Gaps(side)[gap].Low);
        EXPECT_EQ(straight.Gaps(side)[gap].High, turned.Gaps(side)[gap].High);
      }
    }
  }
}

TEST(BiteOutline, CoveredBiteHasNoEnds)
{
  Bites bites = AlignedBites({ { 0.0, 0.0 }, { 0.1, 0.1 } }, 1.0);
  bites.HalfWidths[0] = 0.5;
  OutlineOf(bites, 0).VisitEnds([](const Point2& p) { ADD_FAILURE() << p.X << " " << p.Y; });
}

DirectionMask MaskAtOrigin(const Bites& bites)
{
  DirectionMask mask;
  for (Id bite = 0; bite < bites.Size(); ++bite)
  {
    mask.Add(bites, bite, { 0.0, 0.0 }, 1e-12);
  }
  return mask;
}

TEST(DirectionMask, FourSquaresThatMeetInACornerSurroundIt)
{
  for (double degrees : { 0.0, 30.0, 45.0, 71.0 })
  {
    std::vector<Point2> centers = RegularPolygon({ 0.0, 0.0 }, std::sqrt(2.0), 4, degrees + 45.0);
    std::vector<Point2> axes(4, UnitVector(degrees));
    EXPECT_TRUE(MaskAtOrigin(MakeBites(centers, axes, 1.0)).IsFull()) << degrees;
    centers.pop_back();
    axes.pop_back();
    EXPECT_FALSE(MaskAtOrigin(MakeBites(centers, axes, 1.0)).IsFull()) << degrees;
  }
}

TEST(DirectionMask, TwoSquaresSideBySideSurroundAPointBetween)
{
  EXPECT_TRUE(MaskAtOrigin(AlignedBites({ { 1.0, 0.2 }, { -1.0, -0.3 } }, 1.0)).IsFull());
  EXPECT_FALSE(MaskAtOrigin(AlignedBites({ { 1.0, 0.2 }, { -1.0, 1.0 } }, 1.0)).IsFull());
}

TEST(DirectionMask, SquareAroundAPointSurroundsIt)
{
  EXPECT_TRUE(MaskAtOrigin(AlignedBites({ { 0.5, 0.2 } }, 1.0)).IsFull());
}

TEST(DirectionMask, SquareBeyondThePointCoversNothing)
{
  const Bites bites =
    AlignedBites({ { 1.1, 0.0 }, { -1.1, 0.0 }, { 0.0, 1.1 }, { 0.0, -1.1 } }, 1.0);
  EXPECT_FALSE(MaskAtOrigin(bites).IsFull());
}

TEST(DirectionMask, CirclesSurroundAPointFromAllSides)
{
  const Bites bites = MakeBites({ UnitVector(10.0), UnitVector(130.0), UnitVector(250.0) },
    std::vector<Point2>(3, Point2{}), 1.0);
  DirectionMask mask;
  for (Id bite = 0; bite < 3; ++bite)
  {
    EXPECT_FALSE(mask.IsFull());
    mask.Add(bites, bite, { 0.0, 0.0 }, 1e-12);
  }
  EXPECT_TRUE(mask.IsFull());
}

} // namespace

} // namespace biting
