// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Base/PointOnSegment.h"

#include <gtest/gtest.h>

#include <cmath> // for abs, cos

namespace biting
{

namespace
{

constexpr double Room = 0.01;

/// How far points that divide some segments are off these, together, in units of the offset's ulp.
double OffTogether(double offset, double room)
{
  const double ulp = std::nextafter(offset, 2.0 * offset) - offset;
  double sum = 0.0;
  for (int angle = 1; angle < 100; ++angle)
  {
    const Point2 a{ offset, offset };
    const Point2 b{ offset + std::cos(0.06 * angle), offset + std::sin(0.06 * angle) };
    for (double t = 0.01; t < 1.0; t += 0.037)
    {
      sum += std::abs(Cross(b - a, PointOnSegment(a, b, t, room) - a)) / ulp;
    }
  }
  return sum;
}

TEST(PointOnSegment, IsHardlyOffTheSegmentFarFromTheOrigin)
{
  EXPECT_LT(OffTogether(1e8, Room), 0.2 * OffTogether(1e8, 0.0));
}

TEST(PointOnSegment, IsTheRoundedPointNearTheOriginAndWhereThereIsNoRoom)
{
  const Point2 a{ 0.1, 0.7 };
  const Point2 b{ 1.3, 0.2 };
  const Point2 shift{ 1e9, 1e9 };
  for (double t = 0.0; t <= 0.5; t += 0.0625)
  {
    EXPECT_EQ(PointOnSegment(a, b, t, Room), t < 0.5 ? a + t * (b - a) : b - t * (b - a));
    const Point2 c = a + shift;
    const Point2 d = b + shift;
    EXPECT_EQ(PointOnSegment(c, d, t, 1e-5), t < 0.5 ? c + t * (d - c) : d - t * (d - c));
  }
}

TEST(PointOnSegment, StaysNearThePlaceAndAscends)
{
  const Point2 a{ 1e8, -1e8 };
  const Point2 b{ 1e8 + 0.7, -1e8 + 1.1 };
  Point2 last = a;
  for (double t = 0.001; t < 1.0; t += 0.001)
  {
    const Point2 p = PointOnSegment(a, b, t, 0.001);
    EXPECT_LT(Distance(p, a + t * (b - a)), 2e-7);
    EXPECT_LT(last.X, p.X);
    EXPECT_LT(last.Y, p.Y);
    last = p;
  }
}

TEST(PointOnSegment, IsMirroredWithTheSegment)
{
  for (double t = 0.05; t < 1.0; t += 0.1)
  {
    const Point2 p = PointOnSegment({ 1e8, 2e8 }, { 1e8 + 0.3, 2e8 + 0.7 }, t, Room);
    const Point2 q = PointOnSegment({ 2e8, 1e8 }, { 2e8 + 0.7, 1e8 + 0.3 }, t, Room);
    EXPECT_EQ(p.X, q.Y);
    EXPECT_EQ(p.Y, q.X);
  }
}

} // namespace

} // namespace biting
