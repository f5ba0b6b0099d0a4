// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Domain/PointWelding.h"

#include "../Support/MeshShapes.h"
#include "../Support/PolylineShapes.h"

#include <gtest/gtest.h>

#include <algorithm> // for is_sorted
#include <cstddef>   // for sizes

namespace biting
{

namespace
{

constexpr double Tolerance = 0.01;

WeldedPoints Weld(const Polylines& input, double tolerance, ProblemList& problems)
{
  Pulse pulse(NoMonitor());
  return WeldPoints(input, tolerance, problems, pulse);
}

/// A closed chain through places of which many are near each other.
Polylines Scattered(int count)
{
  TestNumbers numbers(3);
  std::vector<Point2> places;
  for (int k = 0; k < count; ++k)
  {
    places.push_back({ numbers.Unit(), 0.02 * numbers.Unit() });
  }
  return PolylineBuilder().Loop(places).Lines();
}

TEST(WeldPoints, LeavesVerticesThatAreApartAndSorted)
{
  ProblemList problems;
  const WeldedPoints welded = Weld(Scattered(500), Tolerance, problems);
  EXPECT_TRUE(std::is_sorted(welded.Vertices.begin(), welded.Vertices.end()));
  for (std::size_t a = 0; a < welded.Vertices.size(); ++a)
  {
    for (std::size_t b = 0; b < a; ++b)
    {
      ASSERT_GT(Distance(welded.Vertices[a], welded.Vertices[b]), welded.Resolution);
    }
  }
}

TEST(WeldPoints, GivesEachPointAVertexWithinTheResolution)
{
  const Polylines input = Scattered(500);
  ProblemList problems;
  const WeldedPoints welded = Weld(input, Tolerance, problems);
  for (std::size_t point = 0; point < input.Points.size(); ++point)
  {
    const Point2& vertex = welded.Vertices[static_cast<std::size_t>(welded.VertexOf[point])];
    ASSERT_LE(Distance(input.Points[point], vertex), welded.Resolution);
  }
  EXPECT_EQ(problems.Count(ProblemCode::NearPoints) + static_cast<int>(welded.Vertices.size()),
    static_cast<int>(input.Points.size()));
}

TEST(WeldPoints, KeepsPlacesOfBoundariesBeforeThoseOfInterfaces)
{
  const Point2 corner{ 0.0, 0.0 };
  const Polylines input = PolylineBuilder()
                            .Chain({ { -1e-4, 0.0 }, { 0.5, 0.5 } }, ChainKind::Interface)
                            .Loop({ corner, { 1.0, 0.0 }, { 1.0, 1.0 } })
                            .Lines();
  ProblemList problems;
  const WeldedPoints welded = Weld(input, Tolerance, problems);
  EXPECT_EQ(welded.Vertices.front(), corner);
  EXPECT_EQ(welded.Vertices.size(), 4u);
}

TEST(WeldPoints, NumbersNoVertexThatNoChainUses)
{
  Polylines input = Scattered(20);
  input.Points.push_back({ 7.0, 7.0 });
  ProblemList problems;
  const WeldedPoints welded = Weld(input, 0.0, problems);
  EXPECT_EQ(welded.VertexOf.back(), NoId);
  EXPECT_EQ(welded.Vertices.size(), 20u);
}

} // namespace

} // namespace biting
