// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Spacing/TriangleLimit.h"

#include "SpacingSources.h"

#include <gtest/gtest.h>

namespace
{

using namespace biting;

constexpr double Gradation = 0.3;

constexpr ValueRange AnyRange{ 1.0, 0.0, 1e9 };

TriangleLimit LimitOf(const TriangulatedSource& source)
{
  return TriangleLimit(Share(source), Gradation, AnyRange, NoMonitor());
}

/// Of a point, relative.
double LargestChange(const TriangulatedSource& source)
{
  const TriangleLimit limit = LimitOf(source);
  const TriangleInterpolator triangles(source);
  double largest = 0.0;
  for (std::size_t point = 0; limit.IsNeeded() && point < source.Values.size(); ++point)
  {
    largest =
      std::max(largest, 1.0 - limit(source.Points[point], triangles) / source.Values[point]);
  }
  return largest;
}

/// The distance from the middle, as a field that is limited to `slope` already.
Field AroundTheMiddle(double slope)
{
  return [slope](const Point2& x) {
    return 0.003 + slope * std::max(Length(x - Point2{ 0.5, 0.5 }) - 0.05, 0.0);
  };
}

} // namespace

TEST(TriangleLimit, KeepsAFieldThatIsAsSteepAsTheGradation)
{
  for (int nodes : { 51, 101, 201 })
  {
    EXPECT_LE(LargestChange(MakeTriangulation(nodes, AroundTheMiddle(Gradation))), 0.02) << nodes;
  }
}

TEST(TriangleLimit, KeepsAPlaneOfThatSlopeInAnyDirection)
{
  for (double angle = 0.0; angle < 6.3; angle += 0.1)
  {
    const Point2 slope{ Gradation * std::cos(angle), Gradation * std::sin(angle) };
    const auto plane = [&slope](const Point2& x) { return 0.5 + Dot(slope, x); };
    EXPECT_FALSE(LimitOf(MakeTriangulation(31, plane)).IsNeeded()) << angle;
  }
}

TEST(TriangleLimit, LowersASteeperPlaneInAnyDirection)
{
  for (double angle = 0.0; angle < 6.3; angle += 0.1)
  {
    const Point2 along{ std::cos(angle), std::sin(angle) };
    const double slope = 1.5 * Gradation;
    const double change = LargestChange(MakeTriangulation(65,
      [&along, slope](const Point2& x) {
        return 1.0 + slope * Dot(along, x - Point2{ 0.5, 0.5 });
      }));
    EXPECT_GT(change, 0.11) << angle;
    EXPECT_LT(change, 0.17) << angle;
  }
}

TEST(TriangleLimit, GrowsFromTheEdgeOfACoarseTriangle)
{
  const TriangulatedSource source{ { { 0.0, 0.0 }, { 0.0, 1.0 }, { 1.0, 0.5 } }, { 0.1, 0.1, 0.9 },
    { 0, 1, 2 } };
  const TriangleLimit limit = LimitOf(source);
  const TriangleInterpolator triangles(source);
  for (double x : { 0.0, 0.2, 0.5, 0.9 })
  {
    EXPECT_NEAR(limit({ x, 0.5 }, triangles), 0.1 + Gradation * x, 1e-12);
  }
}

/// What is low within the triangles, but not on their border.
TEST(TriangleLimit, LimitsTheNearestBorderValueOutside)
{
  const auto low = [](const Point2& x) { return 0.1 + 2.0 * Length(x - Point2{ 0.5, 0.5 }); };
  const TriangulatedSource source = MakeTriangulation(21, low);
  const TriangleLimit limit = LimitOf(source);
  const TriangleInterpolator triangles(source);
  for (const Point2& x : { Point2{ 1.5, 0.5 }, Point2{ 2.0, 2.0 }, Point2{ -0.2, 0.9 } })
  {
    const double expected = 0.1 + Gradation * Length(x - Point2{ 0.5, 0.5 });
    EXPECT_NEAR(limit(x, triangles), expected, 0.01 * expected);
  }
}

TEST(TriangleLimit, IgnoresPointsWithoutAValue)
{
  const TriangulatedSource source = MakeTriangulation(
    21, [](const Point2& x) { return x.X < 0.3 ? NotANumber
                                : x.X < 0.6    ? 0.02
                                               : 1.0; });
  const TriangleLimit limit = LimitOf(source);
  const TriangleInterpolator triangles(source);
  EXPECT_NEAR(limit({ 0.95, 0.5 }, triangles), 0.02 + 0.4 * Gradation, 0.005);
  EXPECT_NEAR(limit({ 0.1, 0.5 }, triangles), 0.02, 1e-6);
}
