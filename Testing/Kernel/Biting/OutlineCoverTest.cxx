// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Biting/OutlineCover.h"

#include "Surroundings.h"

#include <gtest/gtest.h>

namespace biting
{

namespace
{

TEST(OutlineCover, FullOutlinesHaveNoGap)
{
  TestNumbers numbers(1);
  for (const Mix mix : { Mix::Squares, Mix::Circles, Mix::Both })
  {
    int full = 0;
    int missed = 0;
    for (int run = 0; run < 3000; ++run)
    {
      const Bites bites = RandomSurroundings(mix, numbers);
      const bool isFull = IsFull<OutlineCover>(bites);
      full += isFull ? 1 : 0;
      EXPECT_FALSE(isFull && HasGap(bites));
      missed += mix != Mix::Both && !isFull && !HasGap(bites) ? 1 : 0;
    }
    EXPECT_GT(full, 100);
    EXPECT_LT(missed, 0.1 * full); // covered in pieces smaller than those that it knows
  }
}

TEST(OutlineCover, BitesThatOnlyTouchCoverNothing)
{
  Bites bites;
  bites.Centers = { { 0.0, 0.0 }, { 2.0, 0.0 }, { 0.0, 2.0 }, { -2.0, 0.0 }, { 0.0, -2.0 } };
  for (const Point2& axis : { Point2{ 1.0, 0.0 }, Point2{} })
  {
    bites.Axes.assign(5, axis);
    bites.HalfWidths.assign(5, 1.0);
    EXPECT_FALSE(IsFull<OutlineCover>(bites));
  }
}

TEST(OutlineCover, SaysTheSameOfABiteAmongFarLargerOnes)
{
  for (const double size : { 1e3, 1e6, 1e9 })
  {
    Bites bites;
    bites.Centers = { {}, { 0.5 * size, 0.0 }, { -size - 0.5, 0.0 } };
    bites.Axes.assign(3, { 1.0, 0.0 });
    bites.HalfWidths = { 1.0, 0.5 * size - 0.25, size };
    EXPECT_FALSE(IsFull<OutlineCover>(bites)) << size;
    bites.HalfWidths[2] = size + 1.0 + 1e-3 * size;
    EXPECT_TRUE(IsFull<OutlineCover>(bites)) << size;
  }
}

TEST(OutlineCover, SquareWithinALargerOneIsCovered)
{
  Bites bites;
  bites.Centers = { { 0.1, 0.0 }, { 0.0, 0.0 } };
  bites.Axes = { UnitVector(20.0), { 1.0, 0.0 } };
  bites.HalfWidths = { 1.0, 2.0 };
  EXPECT_TRUE(IsFull<OutlineCover>(bites));
}

} // namespace

} // namespace biting
