// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Biting/CornerCover.h"

#include "../Support/RandomBites.h"

#include <gtest/gtest.h>

#include <algorithm> // for min

namespace biting
{

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
