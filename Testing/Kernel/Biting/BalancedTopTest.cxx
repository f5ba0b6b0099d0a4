// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Biting/BalancedTop.h"
#include "../Support/MeshShapes.h"

#include <gtest/gtest.h>

#include <cmath> // for sqrt

namespace biting
{

namespace
{

const BiteTriangle Steep{ { 0.0, 0.0 }, { 1.0, 0.1 }, { 0.4, 0.9 }, 0.8, 1.2, 1.1 };

void ExpectNear(const Point2& a, const Point2& b)
{
  EXPECT_NEAR(a.X, b.X, 1e-12);
  EXPECT_NEAR(a.Y, b.Y, 1e-12);
}

TEST(BalancedTop, MakesBothEdgesAsLongAsTheMeanOfTheSpacingAtTheirEnds)
{
  for (const double length : { 0.8, 1.0, 1.3 })
  {
    const Point2 top = BalancedTop(Steep, length);
    EXPECT_NEAR(
      Distance(Steep.Left, top), 0.5 * length * (Steep.LeftSpacing + Steep.TopSpacing), 1e-12);
    EXPECT_NEAR(
      Distance(Steep.Right, top), 0.5 * length * (Steep.RightSpacing + Steep.TopSpacing), 1e-12);
  }
}

TEST(BalancedTop, IsOnTheSideOfTheTop)
{
  BiteTriangle below = Steep;
  below.Top = { 0.4, -0.9 };
  const Point2 bond = Steep.Right - Steep.Left;
  EXPECT_GT(Cross(bond, BalancedTop(Steep, 1.0)), 0.0);
  EXPECT_LT(Cross(bond, BalancedTop(below, 1.0)), 0.0);
}

TEST(BalancedTop, DoesNotDependOnTheOrderOfTheTwo)
{
  const BiteTriangle exchanged{ Steep.Right, Steep.Left, Steep.Top, Steep.RightSpacing,
    Steep.LeftSpacing, Steep.TopSpacing };
  ExpectNear(BalancedTop(Steep, 1.0), BalancedTop(exchanged, 1.0));
}

TEST(BalancedTop, IsOnTheBisectorWhereTheSpacingIsLevel)
{
  const BiteTriangle level{ { 0.0, 0.0 }, { 1.0, 0.0 }, { 0.5, 0.7 }, 1.0, 1.0, 1.0 };
  ExpectNear(BalancedTop(level, 1.0), { 0.5, std::sqrt(0.75) });
}

TEST(BalancedTop, IsTheTopItselfWhereTheEdgesDoNotMeet)
{
  EXPECT_EQ(BalancedTop(Steep, 0.2), Steep.Top);
  BiteTriangle jump = Steep;
  jump.RightSpacing = 50.0;
  EXPECT_EQ(BalancedTop(jump, 1.0), jump.Top);
}

TEST(BalancedTop, ScalesEveryBitWithThePowersOfTwo)
{
  BiteTriangle scaled = Steep;
  for (Point2* p : { &scaled.Left, &scaled.Right, &scaled.Top })
  {
    *p = 0x1p-30 * *p;
  }
  for (double* f : { &scaled.LeftSpacing, &scaled.RightSpacing, &scaled.TopSpacing })
  {
    *f *= 0x1p-30;
  }
  EXPECT_EQ(BalancedTop(scaled, 1.0), 0x1p-30 * BalancedTop(Steep, 1.0));
}

} // namespace

} // namespace biting
