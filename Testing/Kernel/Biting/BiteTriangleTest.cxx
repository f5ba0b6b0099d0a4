// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Biting/BiteTriangle.h"
#include "../Support/BitingSettings.h"
#include "../Support/MeshShapes.h"

#include <gtest/gtest.h>

#include <cmath>      // for sqrt
#include <functional> // for fields

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

using Field = std::function<double(const Point2&)>;

Field Linear(double slope, double angle)
{
  return [slope, angle](const Point2& p) { return 1.0 + slope * Dot(p, UnitVector(angle)); };
}

BiteTriangle TriangleIn(const Field& f, const Point2& left, const Point2& right, const Point2& top)
{
  return { left, right, top, f(left), f(right), f(top) };
}

double Factor(const BitingSetting& setting, const BiteTriangle& triangle)
{
  return ReachFactor(setting.Shape, setting.Order, triangle);
}

TEST(ReachFactor, IsOneWhereTheSpacingIsLevel)
{
  for (const BitingSetting& setting : BitingSettings())
  {
    const BiteTriangle level =
      TriangleIn(Linear(0.0, 0.0), { 0.0, 0.0 }, { 0.9, 0.1 }, { 0.5, 0.8 });
    EXPECT_EQ(Factor(setting, level), 1.0) << setting;
  }
}

TEST(ReachFactor, StaysWithinItsBounds)
{
  TestNumbers numbers(3);
  for (const BitingSetting& setting : BitingSettings())
  {
    for (int run = 0; run < 1000; ++run)
    {
      const double slope = 0.7 * numbers.Unit();
      const Field f = Linear(slope, DegreesPerTurn * numbers.Unit());
      const double factor =
        Factor(setting, TriangleIn(f, { -0.3, 0.0 }, { 0.3, 0.0 }, { 0.0, numbers.Unit() }));
      EXPECT_GE(factor, LeastReachFactor(slope) - 1e-12);
      EXPECT_LE(factor, GreatestReachFactor(slope) + 1e-12);
    }
  }
}

TEST(ReachFactor, IsTheSameInAllUnitsPlacesAndDirections)
{
  TestNumbers numbers(5);
  for (const BitingSetting& setting : BitingSettings())
  {
    const double angle = DegreesPerTurn * numbers.Unit();
    BiteTriangle triangle = TriangleIn(Linear(0.3, 50.0), { 0.0, 0.0 }, { 1.0, 0.0 }, { 0.5, 0.9 });
    const double factor = Factor(setting, triangle);
    for (Point2* p : { &triangle.Left, &triangle.Right, &triangle.Top })
    {
      const Point2 turned = p->X * UnitVector(angle) + p->Y * Perpendicular(UnitVector(angle));
      *p = 0x1p-20 * (turned + Point2{ 3.0, -7.0 });
    }
    for (double* f : { &triangle.LeftSpacing, &triangle.RightSpacing, &triangle.TopSpacing })
    {
      *f *= 0x1p-20;
    }
    EXPECT_NEAR(Factor(setting, triangle), factor, 1e-12) << setting;
  }
}

TEST(ReachFactor, OfCirclesIsLargerForThoseThatGoOnAsTheSpacingGrows)
{
  for (const BitingSetting& setting : BitingSettings())
  {
    const Point2 left{ 0.0, 0.0 };
    const Point2 right{ 1.0, 0.0 };
    const Point2 top{ 0.5, 0.9 };
    const double least = setting.Shape == BiteShape::Circle ? 0.1 : -1e-12;
    EXPECT_GE(Factor(setting, TriangleIn(Linear(0.2, 90.0), left, right, top)),
      Factor(setting, TriangleIn(Linear(0.2, -90.0), left, right, top)) + least);
  }
}

} // namespace

} // namespace biting
