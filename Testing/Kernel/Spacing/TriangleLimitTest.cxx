// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Spacing/TriangleLimit.h"

#include "SpacingSources.h"

#include <gtest/gtest.h>

namespace
{

using namespace biting;

constexpr double Gradation = 0.3;

struct Limited
{
  std::size_t Cones;
  double LargestChange; ///< of a value, relative
};

Limited LimitOf(const TriangulatedSource& source)
{
  ConeCollector cones({ 1.0, 0.0, 1e9 });
  const std::vector<double> limits = LimitTriangles(source, Gradation, cones, NoMonitor());
  Limited result{ cones.Segments().Segments.size() / 2, 0.0 };
  for (std::size_t point = 0; point < limits.size(); ++point)
  {
    result.LargestChange =
      std::max(result.LargestChange, 1.0 - limits[point] / source.Values[point]);
  }
  return result;
}

/// The distance from the middle, as a field that is limited to `slope` already.
Field AroundTheMiddle(double slope)
{
  return [slope](const Point2& x) {
    return 0.003 + slope * std::max(Length(x - Point2{ 0.5, 0.5 }) - 0.05, 0.0);
  };
}

} // namespace

TEST(TriangleLimit, HasFewConesWhereAFieldIsAsSteepAsTheGradation)
{
  for (double times : { 1.0, 1.01, 2.0 })
  {
    for (int nodes : { 51, 101, 201 })
    {
      EXPECT_LE(LimitOf(MakeTriangulation(nodes, AroundTheMiddle(times * Gradation))).Cones,
        static_cast<std::size_t>(60 * nodes))
        << nodes << ' ' << times;
    }
  }
}

TEST(TriangleLimit, KeepsAPlaneOfThatSlopeInAnyDirection)
{
  for (double angle = 0.0; angle < 6.3; angle += 0.1)
  {
    const Point2 slope{ Gradation * std::cos(angle), Gradation * std::sin(angle) };
    const auto plane = [&slope](const Point2& x) { return 0.5 + Dot(slope, x); };
    const Limited limited = LimitOf(MakeTriangulation(31, plane));
    EXPECT_EQ(limited.Cones, 0u) << angle;
    EXPECT_EQ(limited.LargestChange, 0.0) << angle;
  }
}

TEST(TriangleLimit, LowersASteeperPlaneInAnyDirection)
{
  for (double angle = 0.0; angle < 6.3; angle += 0.1)
  {
    const Point2 along{ std::cos(angle), std::sin(angle) };
    const double slope = 1.5 * Gradation;
    const Limited limited = LimitOf(MakeTriangulation(65,
      [&along, slope](const Point2& x) {
        return 1.0 + slope * Dot(along, x - Point2{ 0.5, 0.5 });
      }));
    EXPECT_GT(limited.LargestChange, 0.11) << angle;
    EXPECT_LT(limited.LargestChange, 0.17) << angle;
  }
}
