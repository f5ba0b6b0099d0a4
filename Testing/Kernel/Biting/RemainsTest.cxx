// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Biting/Remains.h"

#include "../Support/RandomBites.h"

#include <gtest/gtest.h>

#include <algorithm> // for min

namespace biting
{

namespace
{

constexpr double SagittaOfCircle = 2e-3; // of its radius, where it has 64 sides

} // namespace

TEST(Remains, AreEmptyOnlyWhereBitesCoverAllOfTheTriangle)
{
  TestNumbers numbers(3);
  int numberOfEmpty = 0;
  for (int run = 0; run < 2000; ++run)
  {
    const bool areCircles = run % 2 == 0;
    const Triangle triangle = RandomTriangle(numbers);
    Bites bites;
    Remains remains;
    remains.Begin(triangle);
    for (int count = 0; count < 12; ++count)
    {
      AddBite(PointNear(numbers), areCircles, numbers, bites);
      remains.TakeAway(bites, count, Slack);
    }
    if (remains.IsEmpty())
    {
      ++numberOfEmpty;
      EXPECT_GE(LeastDepth(bites, triangle, numbers), -2.0 * Slack);
    }
    for (; !remains.IsEmpty(); remains.DropLast())
    {
      EXPECT_LE(DepthIn(bites, remains.MiddleOfLast()), areCircles ? SagittaOfCircle : 2.0 * Slack);
    }
  }
  EXPECT_GT(numberOfEmpty, 300);
  EXPECT_LT(numberOfEmpty, 1800);
}

TEST(Remains, AreEmptyBetweenBitesThatTouch)
{
  Bites bites;
  bites.Centers = { { -1.0, 0.0 }, { 1.0, 0.0 } };
  bites.Axes = { { 1.0, 0.0 }, { 1.0, 0.0 } };
  bites.HalfWidths = { 1.0, 1.0 };
  Remains remains;
  remains.Begin({ Point2{ -1.0, -0.5 }, Point2{ 1.0, -0.5 }, Point2{ 0.0, 0.9 } });
  remains.TakeAway(bites, 0, Slack);
  EXPECT_FALSE(remains.IsEmpty());
  remains.TakeAway(bites, 1, Slack);
  EXPECT_TRUE(remains.IsEmpty());
}

TEST(Remains, KeepATriangleThatABiteDoesNotMeet)
{
  Bites bites;
  bites.Centers = { { 3.0, 3.0 } };
  bites.Axes = { UnitVector(30.0) };
  bites.HalfWidths = { 1.0 };
  Remains remains;
  remains.Begin({ Point2{ 0.0, 0.0 }, Point2{ 1.5, 0.0 }, Point2{ 0.0, 1.5 } });
  remains.TakeAway(bites, 0, Slack);
  EXPECT_EQ(remains.MiddleOfLast(), (Point2{ 0.5, 0.5 }));
  remains.DropLast();
  EXPECT_TRUE(remains.IsEmpty());
}

TEST(CornerCover, EachPlaceIsAsNearToACornerAsTheCircumradius)
{
  TestNumbers numbers(5);
  int numberWithin = 0;
  for (int run = 0; run < 2000; ++run)
  {
    const Triangle triangle = RandomTriangle(numbers);
    const double distance = 2.0 * numbers.Unit();
    const bool isWithin = IsWithinOfCorners(triangle, distance);
    numberWithin += isWithin ? 1 : 0;
    for (int sample = 0; isWithin && sample < 50; ++sample)
    {
      const Point2 p = PointOf(triangle, numbers);
      EXPECT_LE(
        std::min({ Distance(p, triangle[0]), Distance(p, triangle[1]), Distance(p, triangle[2]) }),
        distance * (1.0 + 1e-12));
    }
  }
  EXPECT_GT(numberWithin, 500);
}

TEST(CornerCover, BitesThatCoverATriangleCoverEachPlaceOfIt)
{
  TestNumbers numbers(7);
  int numberOfCovered = 0;
  for (int run = 0; run < 4000; ++run)
  {
    const Triangle triangle = RandomTriangle(numbers);
    Bites bites;
    for (const Point2& corner : triangle)
    {
      AddBite(corner, run % 3 == 0, numbers, bites);
    }
    if (CoverTriangle(bites, { 0, 1, 2 }))
    {
      ++numberOfCovered;
      EXPECT_GE(LeastDepth(bites, triangle, numbers), -Slack);
    }
  }
  EXPECT_GT(numberOfCovered, 500);
}

} // namespace biting
