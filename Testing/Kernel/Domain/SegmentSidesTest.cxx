// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Domain/SegmentSides.h"
#include "Support/PolylineShapes.h"

#include <gtest/gtest.h>

namespace biting
{

namespace
{

/// A square with a smaller one turned in it, which is a hole.
Domain Frame()
{
  ProblemList problems;
  const Polylines lines = PolylineBuilder()
                            .Box(0.0, 0.0, 8.0, 8.0)
                            .Loop({ { 4.0, 2.0 }, { 6.0, 4.0 }, { 4.0, 6.0 }, { 2.0, 4.0 } })
                            .Lines();
  return MakeDomain(lines, {}, problems, NoMonitor());
}

bool AreApart(const Domain& domain, const Point2& p, const Point2& q)
{
  bool isOdd = false;
  for (Id segment = 0; segment < domain.NumberOfSegments(); ++segment)
  {
    isOdd ^= Separates(domain, segment, p, q);
  }
  return isOdd;
}

bool IsInFrame(const Point2& p)
{
  const bool isInBox = p.X > 0.0 && p.X < 8.0 && p.Y > 0.0 && p.Y < 8.0;
  return isInBox && std::abs(p.X - 4.0) + std::abs(p.Y - 4.0) > 2.0;
}

} // namespace

TEST(Separates, TellsInsideFromOutsideThroughVerticesToo)
{
  const Domain domain = Frame();
  ASSERT_EQ(domain.NumberOfSegments(), 8);
  // Half of these places are level with vertices.
  for (const Point2 p : { Point2{ -1.0, 4.0 }, Point2{ 4.0, 4.0 }, Point2{ 1.0, 4.0 } })
  {
    for (int k = 0; k < 400; ++k)
    {
      const Point2 q{ -1.25 + 0.5 * (k % 20), -1.0 + 0.5 * (k / 20) };
      const bool isOnBoundary = q.Y == 0.0 || q.Y == 8.0;
      const bool isOnHole = std::abs(q.X - 4.0) + std::abs(q.Y - 4.0) == 2.0;
      if (!isOnBoundary && !isOnHole)
      {
        EXPECT_EQ(AreApart(domain, p, q), IsInFrame(p) != IsInFrame(q)) << q.X << ", " << q.Y;
      }
    }
  }
}

TEST(Separates, IsTheSameBothWays)
{
  const Domain domain = Frame();
  TestNumbers numbers(29);
  for (int k = 0; k < 1000; ++k)
  {
    const Point2 p{ 10.0 * numbers.Unit() - 1.0, 10.0 * numbers.Unit() - 1.0 };
    const Point2 q{ 10.0 * numbers.Unit() - 1.0, 10.0 * numbers.Unit() - 1.0 };
    EXPECT_EQ(AreApart(domain, p, q), AreApart(domain, q, p));
  }
}

TEST(PassesBox, IsTrueForBoxesWithAPointOfTheSegmentAndFalseFurtherOff)
{
  const Domain domain = Frame();
  TestNumbers numbers(31);
  for (int k = 0; k < 2000; ++k)
  {
    const Id segment = numbers.Below(domain.NumberOfSegments());
    const Point2& start = domain.Vertices[domain.Starts[segment]];
    const Point2& end = domain.Vertices[domain.Ends[segment]];
    const Point2 direction = end - start;
    const Point2 on = start + numbers.Unit() * direction;
    const double size = 0.01 + numbers.Unit();
    Box2 box;
    box.Low = { on.X - size * numbers.Unit(), on.Y - size * numbers.Unit() };
    box.High = { box.Low.X + size, box.Low.Y + size };
    EXPECT_TRUE(PassesBox(domain, segment, box));
    const Point2 aside = (3.0 * size / Length(direction)) * Perpendicular(direction);
    Box2 off;
    off.Add(box.Low + aside);
    off.Add(box.High + aside);
    EXPECT_FALSE(PassesBox(domain, segment, off));
  }
}

} // namespace biting
