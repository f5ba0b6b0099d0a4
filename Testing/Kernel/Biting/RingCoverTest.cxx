// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Biting/RingCover.h"

#include "Surroundings.h"

#include <gtest/gtest.h>

namespace biting
{

namespace
{

TEST(RingCover, OutlinesInAFullRingHaveNoGap)
{
  TestNumbers numbers(1);
  for (const Mix mix : { Mix::Squares, Mix::Circles, Mix::Both })
  {
    int full = 0;
    for (int run = 0; run < 3000; ++run)
    {
      const Bites bites = RandomSurroundings(mix, numbers);
      const bool isFull = IsFull<RingCover>(bites);
      full += isFull ? 1 : 0;
      EXPECT_FALSE(isFull && HasGap(bites));
    }
    EXPECT_GT(full, 50);
  }
}

/// A bite and the six about it in a triangular lattice.
Bites Lattice(double bond, bool areCircles, TestNumbers& numbers)
{
  Bites bites;
  const double turn = DegreesPerTurn * numbers.Unit();
  for (int k = 0; k < 7; ++k)
  {
    const Point2 axis = UnitVector(DegreesPerTurn * numbers.Unit());
    bites.Centers.push_back(k == 0 ? Point2{} : bond * UnitVector(turn + 60.0 * k));
    bites.Axes.push_back(areCircles ? Point2{} : axis);
    bites.HalfWidths.push_back(1.0);
  }
  return bites;
}

TEST(RingCover, IsFullInATriangularLattice)
{
  TestNumbers numbers(2);
  for (int run = 0; run < 100; ++run)
  {
    EXPECT_TRUE(IsFull<RingCover>(Lattice(1.1547, false, numbers)));
    EXPECT_TRUE(IsFull<RingCover>(Lattice(1.0 / 0.824, false, numbers)));
    EXPECT_TRUE(IsFull<RingCover>(Lattice(1.3, true, numbers)));
  }
}

TEST(RingCover, BitesThatOnlyTouchCoverNothing)
{
  Bites bites;
  bites.Centers = { { 0.0, 0.0 }, { 2.0, 0.0 }, { 0.0, 2.0 }, { -2.0, 0.0 }, { 0.0, -2.0 } };
  for (const Point2& axis : { Point2{ 1.0, 0.0 }, Point2{} })
  {
    bites.Axes.assign(5, axis);
    bites.HalfWidths.assign(5, 1.0);
    EXPECT_FALSE(IsFull<RingCover>(bites));
  }
}

TEST(RingCover, IsNotFullAmongFarLargerBitesThatLeaveAGap)
{
  for (const double size : { 1e3, 1e6, 1e9 })
  {
    Bites bites;
    bites.Centers = { {}, { size, 0.0 }, { -size - 0.5, 0.0 } };
    bites.Axes.assign(3, {});
    bites.HalfWidths = { 1.0, size - 0.25, size };
    EXPECT_FALSE(IsFull<RingCover>(bites)) << size;
  }
}

} // namespace

} // namespace biting
