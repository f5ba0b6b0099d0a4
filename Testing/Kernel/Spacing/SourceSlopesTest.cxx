// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Spacing/SourceSlopes.h"

#include "SpacingSources.h"
#include "Support/TestThreads.h"

#include <gtest/gtest.h>

#include <cmath>   // for hypot
#include <limits>  // for holes
#include <utility> // for swap

namespace biting
{

namespace
{

constexpr double Hole = std::numeric_limits<double>::quiet_NaN();
constexpr double Rounding = 1e-14;

/// With this gradient.
double Linear(const Point2& x, const Point2& gradient)
{
  return 7.0 + Dot(gradient, x);
}

/// Of columns and rows of several widths.
GridSource LinearGrid(const Point2& gradient)
{
  GridSource grid{ { -1.0, 0.0, 0.25, 4.0 }, { 2.0, 2.5, 8.0 }, {} };
  for (const double y : grid.YNodes)
  {
    for (const double x : grid.XNodes)
    {
      grid.Values.push_back(Linear({ x, y }, gradient));
    }
  }
  return grid;
}

TriangulatedSource LinearTriangles(const Point2& gradient)
{
  TriangulatedSource source;
  source.Points = { { 0.0, 0.0 }, { 3.0, 0.5 }, { 1.0, 2.0 }, { -1.0, 1.5 } };
  source.Triangles = { 0, 1, 2, 0, 3, 2 };
  for (const Point2& point : source.Points)
  {
    source.Values.push_back(Linear(point, gradient));
  }
  return source;
}

} // namespace

TEST(SourceSlopes, OfWhatIsLinearAreTheLengthOfItsGradient)
{
  for (const Point2& gradient : { Point2{ 0.3, 0.4 }, Point2{ -2.0, 0.0 }, Point2{ 0.0, 0.0 } })
  {
    const double slope = std::hypot(gradient.X, gradient.Y);
    EXPECT_NEAR(LargestSlope(LinearGrid(gradient)), slope, Rounding);
    EXPECT_NEAR(LargestSlope(LinearTriangles(gradient)), slope, Rounding);
  }
}

TEST(SourceSlopes, OfTrianglesDoNotDependOnTheirOrientation)
{
  TriangulatedSource source = LinearTriangles({ 0.3, 0.4 });
  const Point2 gradient = GradientOfTriangle(source, source.Triangles.data());
  std::swap(source.Triangles[0], source.Triangles[1]);
  EXPECT_NEAR(
    Distance(GradientOfTriangle(source, source.Triangles.data()), gradient), 0.0, Rounding);
}

TEST(SourceSlopes, AreThoseOfTheSteepestCell)
{
  GridSource grid = LinearGrid({ 0.0, 0.0 });
  grid.Values[5] += 1.0; // at the corner of a cell of .25 by .5
  EXPECT_NEAR(LargestSlope(grid), std::hypot(1.0 / 0.25, 1.0 / 0.5), Rounding);
  TriangulatedSource source = LinearTriangles({ 0.0, 0.0 });
  source.Values[1] += 1.0; // at the height of its triangle above the side opposite
  EXPECT_NEAR(LargestSlope(source), std::sqrt(5.0) / 5.5, Rounding);
}

TEST(SourceSlopes, OfHolesAndOfWhatHasNoExtentCountNothing)
{
  GridSource grid = LinearGrid({ 0.3, 0.4 });
  grid.Values[5] = Hole;
  EXPECT_NEAR(LargestSlope(grid), 0.5, Rounding);
  EXPECT_EQ(LargestSlope(GridSource{ { 1.0 }, { 2.0 }, { 5.0 } }), 0.0);
  EXPECT_EQ(LargestSlope(GridSource{ { 1.0, 1.0 }, { 2.0 }, { 5.0, 9.0 } }), 0.0);
  TriangulatedSource source = LinearTriangles({ 0.3, 0.4 });
  source.Values[1] = Hole;
  EXPECT_NEAR(LargestSlope(source), 0.5, Rounding);
  source.Triangles = { 0, 0, 2 };
  EXPECT_EQ(LargestSlope(source), 0.0);
}

TEST(SourceSlopes, OfSegmentsAreThoseAlongThem)
{
  SegmentSource source;
  source.Points = { { 0.0, 0.0 }, { 3.0, 4.0 }, { 1.0, 1.0 } };
  source.Values = { 1.0, 2.0, 50.0 };
  source.Segments = { 0, 1, 2, 2 };
  EXPECT_NEAR(LargestSlope(source), 0.2, Rounding);
}

TEST(SourceSlopes, AreTheSameOnAnyNumberOfThreads)
{
  Sampler sampler(24);
  GridSource grid = MakeGrid(500, 301, [&sampler](const Point2&) { return sampler.Next(); });
  for (const std::size_t steepest : { 7u, 75000u, 150400u })
  {
    grid.Values[steepest] = 9.0 + sampler.Next();
    const double expected = LargestSlope(grid);
    for (const int threads : { 2, 3 })
    {
      MonitorWithThreads monitor(threads);
      EXPECT_EQ(LargestSlope(grid, monitor), expected);
    }
  }
}

} // namespace biting
