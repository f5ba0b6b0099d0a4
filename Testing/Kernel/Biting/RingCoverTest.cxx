// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Biting/RingCover.h"
#include "../Support/MeshShapes.h"
#include "Biting/BiteOutline.h"

#include <gtest/gtest.h>

namespace biting
{

namespace
{

bool IsFull(const Bites& bites)
{
  RingCover cover(bites, 0);
  for (Id other = 1; other < bites.Size(); ++other)
  {
    cover.Cover(other);
  }
  return cover.IsFull();
}

bool HasGap(const Bites& bites)
{
  BiteOutline outline;
  outline.Begin(bites, 0);
  for (Id other = 1; other < bites.Size(); ++other)
  {
    outline.Cover(bites, other);
  }
  outline.Finish();
  for (int side = 0; side < 4; ++side)
  {
    if (!outline.Gaps(side).empty())
    {
      return true;
    }
  }
  return false;
}

enum class Mix
{
  Squares,
  Circles,
  Both
};

/// A bite among others that often surround it.
Bites RandomSurroundings(Mix mix, TestNumbers& numbers)
{
  Bites bites;
  const int count = 5 + numbers.Below(10);
  for (int k = 0; k < count; ++k)
  {
    const double angle = DegreesPerTurn * (k + numbers.Unit()) / (count - 1);
    const bool isCircle = mix == Mix::Circles || (mix == Mix::Both && numbers.Below(2) == 0);
    bites.Centers.push_back(k == 0 ? Point2{} : (0.6 + 0.6 * numbers.Unit()) * UnitVector(angle));
    bites.Axes.push_back(isCircle ? Point2{} : UnitVector(DegreesPerTurn * numbers.Unit()));
    bites.HalfWidths.push_back(0.7 + 0.4 * numbers.Unit());
  }
  return bites;
}

TEST(RingCover, OutlinesInAFullRingHaveNoGap)
{
  TestNumbers numbers(1);
  for (const Mix mix : { Mix::Squares, Mix::Circles, Mix::Both })
  {
    int full = 0;
    for (int run = 0; run < 3000; ++run)
    {
      const Bites bites = RandomSurroundings(mix, numbers);
      const bool isFull = IsFull(bites);
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
    EXPECT_TRUE(IsFull(Lattice(1.1547, false, numbers)));
    EXPECT_TRUE(IsFull(Lattice(1.0 / 0.824, false, numbers)));
    EXPECT_TRUE(IsFull(Lattice(1.3, true, numbers)));
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
    EXPECT_FALSE(IsFull(bites));
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
    EXPECT_FALSE(IsFull(bites)) << size;
  }
}

} // namespace

} // namespace biting
