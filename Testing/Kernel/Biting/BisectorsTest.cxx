// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Biting/Bisectors.h"
#include "../Support/MeshShapes.h"
#include "Biting/BiteOutline.h"

#include <gtest/gtest.h>

#include <algorithm> // for remove_if
#include <cmath>     // for sqrt

namespace biting
{

namespace
{

const double Height = std::sqrt(0.75); // of an equilateral triangle with sides 1

void AddBite(
  const Point2& center, const Point2& axis, double halfWidth, BitePhase phase, Bites& bites)
{
  bites.Centers.push_back(center);
  bites.Axes.push_back(axis);
  bites.HalfWidths.push_back(halfWidth);
  bites.Orders.push_back(bites.Size() - 1);
  bites.Phases.push_back(phase);
}

std::vector<BisectorPoint> PointsOf(
  const Bites& bites, Id bite, double lengthPerHalfWidth, double tolerance)
{
  Box2 box;
  for (const Point2& center : bites.Centers)
  {
    box.Add(center);
  }
  box.Grow(1.0);
  BiteGrid grid(bites, box, 10.0, Bisectors::GreatestBond * lengthPerHalfWidth);
  for (Id other = 0; other < bites.Size(); ++other)
  {
    grid.File(other);
  }
  Bisectors bisectors(bites, grid, lengthPerHalfWidth, tolerance, 0.0);
  std::vector<BisectorPoint> points;
  bisectors.VisitPoints(bite, [&](const BisectorPoint& point) { points.push_back(point); });
  points.erase(std::remove_if(points.begin(), points.end(),
                 [&](const BisectorPoint& point) { return bisectors.IsCovered(point.Place); }),
    points.end());
  return points;
}

Bites TwoSquares(double halfWidth)
{
  Bites bites;
  AddBite({ 0.0, 0.0 }, { 1.0, 0.0 }, halfWidth, BitePhase::Interior, bites);
  AddBite({ 1.0, 0.0 }, { 1.0, 0.0 }, halfWidth, BitePhase::Interior, bites);
  return bites;
}

void ExpectEquilateral(const std::vector<BisectorPoint>& points)
{
  ASSERT_EQ(points.size(), 2u);
  for (const BisectorPoint& point : points)
  {
    EXPECT_NEAR(point.Place.X, 0.5, 1e-12);
    EXPECT_NEAR(std::abs(point.Place.Y), Height, 1e-12);
    EXPECT_EQ(point.Neighbor, 0);
    EXPECT_NEAR(point.Misfit, 0.0, 1e-12);
  }
  EXPECT_LT(points[0].Place.Y * points[1].Place.Y, 0.0);
}

TEST(Bisectors, SquaresOfTheRightSizeMakeEquilateralTriangles)
{
  ExpectEquilateral(PointsOf(TwoSquares(Height), 1, 1.0 / Height, 0.9));
}

TEST(Bisectors, CirclesOfTheRightSizeMakeEquilateralTriangles)
{
  Bites bites;
  AddBite({ 0.0, 0.0 }, {}, 1.0, BitePhase::Interior, bites);
  AddBite({ 1.0, 0.0 }, {}, 1.0, BitePhase::Interior, bites);
  ExpectEquilateral(PointsOf(bites, 1, 1.0, 0.8));
}

TEST(Bisectors, BitesTooFarApartHaveNone)
{
  Bites bites = TwoSquares(Height);
  bites.Centers[1].X = 1.001 * Bisectors::GreatestBond;
  EXPECT_TRUE(PointsOf(bites, 1, 1.0 / Height, 0.9).empty());
  bites.Centers[1].X = 0.999 * Bisectors::GreatestBond;
  EXPECT_FALSE(PointsOf(bites, 1, 1.0 / Height, 0.9).empty());
}

TEST(Bisectors, OnlyTheCoreOfInnerBitesCovers)
{
  for (const BitePhase phase :
    { BitePhase::VertexProtection, BitePhase::EdgeProtection, BitePhase::Interior })
  {
    Bites bites = TwoSquares(Height);
    AddBite({ 0.5, 1.95 * Height }, { 1.0, 0.0 }, Height, phase, bites);
    EXPECT_EQ(PointsOf(bites, 1, 1.0 / Height, 1.0).size(), 1u);
    const bool isInner = phase == BitePhase::Interior;
    EXPECT_EQ(PointsOf(bites, 1, 1.0 / Height, 0.9).size(), isInner ? 2u : 1u);
  }
}

Bites RandomBites(bool areCircles, TestNumbers& numbers)
{
  Bites bites;
  for (int k = 0; k < 12; ++k)
  {
    AddBite({ 2.0 * numbers.Unit(), 2.0 * numbers.Unit() },
      areCircles ? Point2{} : UnitVector(DegreesPerTurn * numbers.Unit()),
      0.4 + 0.2 * numbers.Unit(), BitePhase::Interior, bites);
  }
  return bites;
}

TEST(Bisectors, PointsAreOnTheFrontAndAtEqualDistances)
{
  TestNumbers numbers(1);
  int count = 0;
  for (int run = 0; run < 400; ++run)
  {
    const Bites bites = RandomBites(run % 2 == 0, numbers);
    const Id bite = bites.Size() - 1;
    for (const BisectorPoint& point : PointsOf(bites, bite, 2.0, 1.0))
    {
      ++count;
      const double distance = Distance(point.Place, bites.Centers[bite]);
      EXPECT_NEAR(distance, Distance(point.Place, bites.Centers[point.Neighbor]), 1e-9);
      double depth = -1e300;
      for (Id other = 0; other < bites.Size(); ++other)
      {
        depth = std::max(depth, Depth(bites, other, point.Place));
      }
      EXPECT_NEAR(depth, 0.0, 1e-9);
      EXPECT_NEAR(
        std::max(Depth(bites, bite, point.Place), Depth(bites, point.Neighbor, point.Place)), 0.0,
        1e-9);
    }
  }
  EXPECT_GT(count, 100);
}

TEST(Bisectors, MisfitIsThatOfTheTriangle)
{
  const Bites bites = TwoSquares(0.8);
  for (const BisectorPoint& point : PointsOf(bites, 1, 1.0 / 0.8, 0.9))
  {
    EXPECT_NEAR(point.Misfit, 2.0 / 3.0 * (1.0 - std::sqrt(0.25 + 0.64)), 1e-12);
  }
}

// Asked about one place before the next bite comes there, or elsewhere.
TEST(Bisectors, FindsTheSamePointsWhateverWasAskedForBefore)
{
  const double lengthPerHalfWidth = 1.0 / 0.8;
  const Point2 place{ 0.5, Height };
  for (const Point2& asked : { place, Point2{ -0.9, 0.0 } })
  {
    Bites bites = TwoSquares(0.8);
    Box2 box;
    box.Add({ -1.0, -1.0 });
    box.Add({ 2.0, 2.0 });
    BiteGrid grid(bites, box, 10.0, Bisectors::GreatestBond * lengthPerHalfWidth);
    grid.File(0);
    grid.File(1);
    Bisectors bisectors(bites, grid, lengthPerHalfWidth, 0.9, 0.0);
    EXPECT_FALSE(bisectors.IsCovered(asked));
    AddBite(place, { 1.0, 0.0 }, 0.8, BitePhase::Interior, bites);
    grid.File(2);
    std::vector<Id> neighbors;
    bisectors.VisitPoints(
      2, [&neighbors](const BisectorPoint& point) { neighbors.push_back(point.Neighbor); });
    EXPECT_EQ(neighbors, (std::vector<Id>{ 1, 0 }));
  }
}

TEST(Bisectors, WhatIsDeepInALaterBiteStaysCoveredWhenMoved)
{
  const Bites bites = TwoSquares(0.8);
  Box2 box;
  box.Add({ -1.0, -1.0 });
  box.Add({ 2.0, 1.0 });
  BiteGrid grid(bites, box, 10.0, Bisectors::GreatestBond / 0.8);
  grid.File(0);
  grid.File(1);
  const Bisectors bisectors(bites, grid, 1.0 / 0.8, 0.9, 0.0);
  int numberOfDeep = 0;
  for (double x = -0.9; x < 2.0; x += 0.1)
  {
    const Point2 p{ x, 0.1 };
    EXPECT_FALSE(bisectors.IsDeep(p, 1));
    if (bisectors.IsDeep(p, 0))
    {
      ++numberOfDeep;
      EXPECT_TRUE(bisectors.IsCoveredBy(1, p + Point2{ 0.4, 0.0 }));
      EXPECT_TRUE(bisectors.IsCoveredBy(1, p - Point2{ 0.4, 0.0 }));
    }
  }
  EXPECT_GT(numberOfDeep, 3);
}

} // namespace

} // namespace biting
