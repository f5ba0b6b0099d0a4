// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Biting/BiteFrame.h"
#include "../Support/MeshShapes.h"
#include "Biting/BiteOutline.h" // for Depth

#include <gtest/gtest.h>

#include <cmath> // for abs

namespace biting
{

namespace
{

Box2 Bounds()
{
  Box2 box;
  box.Add({ -3.0, 2.0 });
  box.Add({ 7.0, 4.0 });
  return box;
}

Bites RandomBites(std::uint64_t seed)
{
  TestNumbers numbers(seed);
  Bites bites;
  for (int k = 0; k < 200; ++k)
  {
    const Point2 tilted = UnitVector(90.0 * numbers.Unit());
    bites.Centers.push_back({ -3.0 + 10.0 * numbers.Unit(), 2.0 + 2.0 * numbers.Unit() });
    bites.Axes.push_back(k % 3 == 0 ? Point2{} : tilted);
    bites.HalfWidths.push_back(0.01 + 0.5 * numbers.Unit());
    bites.Orders.push_back(k);
    bites.Phases.push_back(BitePhase::Interior);
  }
  return bites;
}

} // namespace

TEST(BiteFrame, HasSquareCellsThatCoverTheBounds)
{
  const Bites bites;
  BiteFrame frame(bites, Bounds(), 0.0, 0.0);
  EXPECT_EQ(frame.Area(), 20.0);
  frame.SetCellsPerLength(2.5);
  EXPECT_EQ(frame.CellsPerLength(), 2.5);
  EXPECT_EQ(frame.Columns(), 26);
  EXPECT_EQ(frame.Rows(), 6);
  EXPECT_EQ(frame.Size(), 156u);
  EXPECT_EQ(frame.ToGrid({ -3.0, 2.0 }), (Point2{ 0.0, 0.0 }));
  EXPECT_EQ(frame.ToGrid({ 1.0, 4.0 }), (Point2{ 10.0, 5.0 }));
}

// The law of the extent: where a point lies in a bite, it lies in the extent, too.
TEST(BiteFrame, FilesABiteAsFarAsItReaches)
{
  const Bites bites = RandomBites(3);
  BiteFrame frame(bites, Bounds(), 0.0, 0.0);
  frame.SetCellsPerLength(3.0);
  TestNumbers numbers(5);
  int inside = 0;
  for (int k = 0; k < 20000; ++k)
  {
    const Id bite = numbers.Below(bites.Size());
    const Point2 offset{ 2.0 * numbers.Unit() - 1.0, 2.0 * numbers.Unit() - 1.0 };
    const Point2 p = bites.Centers[bite] + offset;
    if (Depth(bites, bite, p) > 0.0)
    {
      const CellBox extent = frame.ExtentOf(bite);
      const Point2 place = frame.ToGrid(p);
      ++inside;
      EXPECT_TRUE(extent.LowX <= place.X && place.X <= extent.HighX);
      EXPECT_TRUE(extent.LowY <= place.Y && place.Y <= extent.HighY);
    }
  }
  EXPECT_GT(inside, 1000);
}

TEST(BiteFrame, FilesABiteAsFarAsItsNearReachAndSlack)
{
  const Bites bites = RandomBites(7);
  BiteFrame frame(bites, Bounds(), 3.0, 0.25);
  frame.SetCellsPerLength(4.0);
  for (Id bite = 0; bite < bites.Size(); ++bite)
  {
    const FramedBite framed = frame.Framed(bite);
    EXPECT_GE(0.5 * (framed.Extent.HighX - framed.Extent.LowX),
      4.0 * (3.0 * bites.HalfWidths[bite] + 0.25));
    EXPECT_DOUBLE_EQ(framed.Reach, 4.0 * (bites.HalfWidths[bite] + 0.25));
  }
}

// An entry may say that a point is nearer than it is, never that it is further.
TEST(BiteFrame, RoundsTheReachOfAnEntryUp)
{
  const Bites bites = RandomBites(11);
  BiteFrame frame(bites, Bounds(), 0.0, 0.0);
  frame.SetCellsPerLength(3.0);
  for (Id bite = 0; bite < bites.Size(); ++bite)
  {
    const FramedBite framed = frame.Framed(bite);
    const CellPlace leaf{ std::floor(framed.X), std::floor(framed.Y) };
    const BiteEntry entry = BiteFrame::EntryOf(framed, frame.InCells(framed, 0.25), leaf);
    const double reach = 4.0 * framed.Reach;
    EXPECT_EQ(entry.Bite, bite);
    EXPECT_NEAR(entry.X, 4.0 * (framed.X - leaf.X), 1e-6);
    EXPECT_GT(static_cast<double>(entry.Square), reach * reach);
    EXPECT_LT(static_cast<double>(entry.Square), reach * reach * 1.00002 + 2e-5 * (reach + 1.0));
  }
}

TEST(BiteFrame, VisitsTheCellsOfABoxWithTheirNumbers)
{
  const Bites bites;
  BiteFrame frame(bites, Bounds(), 0.0, 0.0);
  frame.SetCellsPerLength(1.0);
  int count = 0;
  frame.VisitCells(frame.ToGrid({ 0.5, 2.5 }, 1.0),
    [&frame, &count](Id column, Id row, Id cell)
    {
      EXPECT_EQ(cell, row * frame.Columns() + column);
      ++count;
    });
  EXPECT_EQ(count, 6);
}

} // namespace biting
