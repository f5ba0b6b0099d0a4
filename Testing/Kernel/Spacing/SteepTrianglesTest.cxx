// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Spacing/SteepTriangles.h"

#include "SpacingSources.h"

#include <gtest/gtest.h>

namespace
{

using namespace biting;

constexpr double Gradation = 0.3;

std::size_t NumberOfCones(const TriangulatedSource& source)
{
  ConeCollector cones({ 1.0, 0.0, 1e9 });
  EXPECT_TRUE(AddSteepTriangles(source, Gradation, cones, NoMonitor()));
  return cones.Segments().Segments.size() / 2;
}

/// The distance from the middle, as a field that is limited to `slope` already.
Field AroundTheMiddle(double slope)
{
  return [slope](const Point2& x) {
    return 0.003 + slope * std::max(Length(x - Point2{ 0.5, 0.5 }) - 0.05, 0.0);
  };
}

} // namespace

TEST(SteepTriangles, AreFewWhereAFieldIsAsSteepAsTheGradation)
{
  for (int nodes : { 51, 101, 201 })
  {
    EXPECT_LE(NumberOfCones(MakeTriangulation(nodes, AroundTheMiddle(Gradation))),
      static_cast<std::size_t>(10 * nodes))
      << nodes;
  }
}

TEST(SteepTriangles, AreNoneInAPlaneOfThatSlope)
{
  for (double angle = 0.0; angle < 6.3; angle += 0.1)
  {
    const Point2 slope{ Gradation * std::cos(angle), Gradation * std::sin(angle) };
    const auto plane = [&slope](const Point2& x) { return 0.5 + Dot(slope, x); };
    EXPECT_EQ(NumberOfCones(MakeTriangulation(31, plane)), 0u) << angle;
  }
}

TEST(SteepTriangles, AreFoundInAPlaneThatIsALittleSteeperInAnyDirection)
{
  for (double angle = 0.0; angle < 6.3; angle += 0.1)
  {
    const Point2 slope{ 1.02 * Gradation * std::cos(angle), 1.02 * Gradation * std::sin(angle) };
    const auto plane = [&slope](const Point2& x) { return 0.5 + Dot(slope, x); };
    EXPECT_GT(NumberOfCones(MakeTriangulation(31, plane)), 0u) << angle;
  }
}
