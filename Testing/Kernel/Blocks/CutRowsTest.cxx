// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "../Support/MeshShapes.h"

#include "Blocks/CutRows.h"

#include <gtest/gtest.h>

#include <cmath>  // for round, sqrt
#include <limits> // for the plane

namespace biting
{

namespace
{

constexpr double Far = std::numeric_limits<double>::infinity();
const Box2 Plane{ { -Far, -Far }, { Far, Far } };
const Box2 Bounds{ { -1.0, 2.0 }, { 4.0, 5.0 } };

Spacing SpacingOf(const SpacingOptions& options)
{
  ProblemList problems;
  return MakeSpacing(options, Bounds, problems, NoMonitor());
}

} // namespace

TEST(CutRows, FittingPlacesAreWholePairsOfRowsOrWholeSidesFromBothSidesOfTheBox)
{
  const Spacing f = SpacingOf(UniformSpacing(0.01));
  CutRows rows(f, Bounds, 1.0);
  rows.AddCut(true);
  const double pairs = std::round(5.0 / (CutRows::Pair * 0.01));
  const double sides = std::round(3.0 / 0.01);
  for (const double share : { 0.1, 0.31, 0.5, 0.77 })
  {
    const double x = rows.FittingPlace(-1.0 + share * 5.0, Plane, true);
    EXPECT_NEAR(x, -1.0 + share * 5.0, 0.01);
    EXPECT_NEAR((x + 1.0) / 5.0 * pairs, std::round((x + 1.0) / 5.0 * pairs), 1e-9);
    const double y = rows.FittingPlace(2.0 + share * 3.0, Plane, false);
    EXPECT_NEAR(y, 2.0 + share * 3.0, 0.006);
    EXPECT_NEAR((y - 2.0) / 3.0 * sides, std::round((y - 2.0) / 3.0 * sides), 1e-9);
  }
}

/// The level sides of a hexagon are half as long as it is wide; they begin within sides of its box.
TEST(CutRows, SidesAreCountedAlongTheLongestSideOfTheBoundary)
{
  const Spacing f = SpacingOf(UniformSpacing(0.01));
  const Box2 longest{ { 0.2473, 2.0 }, { 2.7473, 5.0 } };
  CutRows rows(f, Bounds, longest, 1.0, {});
  rows.AddCut(false);
  for (const double share : { 0.1, 0.31, 0.77 })
  {
    const double sides = (rows.FittingPlace(-1.0 + share * 5.0, Plane, true) - 0.2473) / 0.01;
    EXPECT_NEAR(sides, std::round(sides), 1e-9);
    EXPECT_NEAR(sides, (share * 5.0 - 1.2473) / 0.01, 0.5 + 1e-9);
    const double pairs = std::round(3.0 / (CutRows::Pair * 0.01));
    const double y = rows.FittingPlace(2.0 + share * 3.0, Plane, false);
    EXPECT_NEAR((y - 2.0) / 3.0 * pairs, std::round((y - 2.0) / 3.0 * pairs), 1e-9);
  }
}

TEST(CutRows, WhereTheFirstCutIsLevelRowsAreLevel)
{
  const Spacing f = SpacingOf(UniformSpacing(0.01));
  CutRows rows(f, Bounds, 1.0);
  EXPECT_TRUE(rows.IsStraight(true) && rows.IsStraight(false));
  rows.AddCut(false);
  rows.AddCut(true);
  EXPECT_TRUE(rows.IsStraight(false));
  EXPECT_FALSE(rows.IsStraight(true));
}

/// A triangle with a side along the cut, and two that are longer, is as high as a row.
TEST(CutRows, StretchedTrianglesFillThePart)
{
  const Spacing f = SpacingOf(UniformSpacing(0.01));
  CutRows rows(f, Bounds, 0.8);
  rows.AddCut(true);
  Box2 part = Plane;
  part.Low.X = rows.FittingPlace(0.3, Plane, true);
  part.High.X = rows.FittingPlace(1.4, part, true);
  const double side = 0.8 * 0.01;
  const double height = side * std::sqrt(std::pow(rows.StretchOf(part), 2) - 0.25);
  const double number = (part.High.X - part.Low.X) / height;
  EXPECT_NEAR(number, 2.0 * std::round(0.5 * number), 1e-6);
  EXPECT_NEAR(rows.StretchOf(part), 1.0, 0.005);
  EXPECT_NE(rows.StretchOf(part), 1.0);
}

TEST(CutRows, WhereTheSpacingIsNotLevelNothingIsStretched)
{
  const Spacing f = SpacingOf(RadialSpacing({ 1.0, 3.0 }, 0.01, 0.1));
  CutRows rows(f, Bounds, 1.0);
  rows.AddCut(true);
  EXPECT_EQ(rows.StretchOf({ { 0.0, -Far }, { 1.0, Far } }), 1.0);
}

TEST(CutRows, WithoutACutNothingIsStretched)
{
  const Spacing f = SpacingOf(UniformSpacing(0.01));
  EXPECT_EQ(CutRows(f, Bounds, 1.0).StretchOf(Plane), 1.0);
}

} // namespace biting
