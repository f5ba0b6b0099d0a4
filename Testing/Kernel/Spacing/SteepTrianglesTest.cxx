// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Spacing/SteepTriangles.h"

#include "SpacingSources.h"

#include <gtest/gtest.h>

#include <algorithm> // for count

namespace
{

using namespace biting;

constexpr double Gradation = 0.3;

std::vector<bool> SteepOnes(
  const TriangulatedSource& source, const ValueRange& range = { 1.0, 0.0, 1e9 })
{
  Pulse pulse(NoMonitor());
  return FindSteepTriangles(source, Gradation, range, pulse);
}

} // namespace

TEST(SteepTriangles, AreNoneWhereTheSlopeIsTheGradationInAnyDirection)
{
  for (double angle = 0.0; angle < 6.3; angle += 0.1)
  {
    const Point2 slope{ Gradation * std::cos(angle), Gradation * std::sin(angle) };
    EXPECT_TRUE(
      SteepOnes(MakeTriangulation(9, [&slope](const Point2& x) { return 1.0 + Dot(slope, x); }))
        .empty());
  }
}

TEST(SteepTriangles, AreAllOfASteeperPlaneInAnyDirection)
{
  for (double angle = 0.0; angle < 6.3; angle += 0.1)
  {
    const Point2 slope{ 1.02 * Gradation * std::cos(angle), 1.02 * Gradation * std::sin(angle) };
    const std::vector<bool> steep =
      SteepOnes(MakeTriangulation(9, [&slope](const Point2& x) { return 1.0 + Dot(slope, x); }));
    EXPECT_EQ(std::count(steep.begin(), steep.end(), true), 128) << angle;
  }
}

TEST(SteepTriangles, AreThoseWhereTheFieldIsSteep)
{
  const std::vector<bool> steep =
    SteepOnes(MakeTriangulation(9, [](const Point2& x) { return 1.0 + std::max(x.Y - 0.5, 0.0); }));
  ASSERT_EQ(steep.size(), 128);
  EXPECT_EQ(std::count(steep.begin(), steep.begin() + 48, true), 0);
  EXPECT_EQ(std::count(steep.begin() + 64, steep.end(), true), 64);
}

TEST(SteepTriangles, AreJudgedByTheSpacingAndNotByTheValues)
{
  const TriangulatedSource source = MakeTriangulation(9, [](const Point2& x) { return 1.0 + x.X; });
  EXPECT_FALSE(SteepOnes(source).empty());
  EXPECT_TRUE(SteepOnes(source, { 0.1, 0.0, 1e9 }).empty()); // scaled
  EXPECT_TRUE(SteepOnes(source, { 1.0, 3.0, 1e9 }).empty()); // all below the least
}
