// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SimplifiedDrawing.h"

#include <gtest/gtest.h>

#include <cmath> // for atan2

namespace biting
{

namespace
{

constexpr double SharpAngle = 36.0; // degrees: no new ones below it

/// A box with a finger on the right, 60 long, 10 wide where it begins and as wide as asked where it
/// ends; the box around is the domain, or all but the box and its finger.
Polylines BoxWithFinger(double width, bool isOutside)
{
  PolylineBuilder builder;
  if (isOutside)
  {
    builder.Box(-100.0, -100.0, 200.0, 200.0);
  }
  return builder
    .Loop({ { 0.0, 0.0 }, { 50.0, 0.0 }, { 50.0, 20.0 }, { 110.0, 25.0 - 0.5 * width },
      { 110.0, 25.0 + 0.5 * width }, { 50.0, 30.0 }, { 50.0, 50.0 }, { 0.0, 50.0 } })
    .Lines();
}

/// Vertices at the end of the finger, with a tolerance of 6.
Id VerticesAtItsEnd(double width, bool isOutside = false)
{
  SimplificationOptions options;
  options.Tolerance = 0.2;
  options.CornerAngle = 180.0;
  const Simplified made =
    SimplifyLines(BoxWithFinger(width, isOutside), options, [](const Point2&) { return 30.0; });
  const std::vector<Point2>& vertices = made.After.Drawing.Vertices;
  return static_cast<Id>(
    std::count_if(vertices.begin(), vertices.end(), [](const Point2& p) { return p.X == 110.0; }));
}

/// Where it is the angle of an inside: between two segments that are neighbours around a vertex.
double SmallestInsideAngle(const Domain& domain)
{
  struct Arm
  {
    double Direction; ///< degrees
    bool IsInside;    ///< left of it
  };
  std::vector<std::vector<Arm>> arms(domain.Vertices.size());
  for (Id segment = 0; segment < domain.NumberOfSegments(); ++segment)
  {
    const Id start = domain.Starts[segment];
    const Id end = domain.Ends[segment];
    const Point2 along = domain.Vertices[end] - domain.Vertices[start];
    const double direction = 57.29577951308232 * std::atan2(along.Y, along.X);
    const double opposite = direction > 0.0 ? direction - 180.0 : direction + 180.0;
    arms[start].push_back({ direction, domain.LeftInside[segment] != 0 });
    arms[end].push_back({ opposite, domain.RightInside[segment] != 0 });
  }
  double smallest = 360.0;
  for (std::vector<Arm>& around : arms)
  {
    std::sort(around.begin(), around.end(),
      [](const Arm& a, const Arm& b) { return a.Direction < b.Direction; });
    for (std::size_t k = 0; around.size() > 1 && k < around.size(); ++k)
    {
      const double next =
        k + 1 < around.size() ? around[k + 1].Direction : around[0].Direction + 360.0;
      smallest = around[k].IsInside ? std::min(smallest, next - around[k].Direction) : smallest;
    }
  }
  return smallest;
}

/// An ellipse with so many vertices, turned.
std::vector<Point2> Ellipse(int count, double length, double width, double degrees)
{
  std::vector<Point2> places;
  for (int k = 0; k < count; ++k)
  {
    const Point2 p = UnitVector(360.0 * k / count);
    const Point2 axis = UnitVector(degrees);
    places.push_back(length * p.X * axis + width * p.Y * Perpendicular(axis));
  }
  return places;
}

} // namespace

TEST(CornerGuard, ABluntEndStaysBlunt)
{
  EXPECT_EQ(VerticesAtItsEnd(2.0), 2);
}

TEST(CornerGuard, AnEndFarNarrowerThanTheToleranceStaysBlunt)
{
  for (const double width : { 0.1, 0.01, 1e-6 })
  {
    EXPECT_EQ(VerticesAtItsEnd(width), 2);
  }
}

TEST(CornerGuard, AnEndMayBeAPointWhereTheInsideIsAroundIt)
{
  EXPECT_EQ(VerticesAtItsEnd(2.0, true), 1);
}

TEST(CornerGuard, EllipsesGetNoSharpCorners)
{
  for (const double tolerance : { 0.5, 1.0, 2.0 })
  {
    for (const double degrees : { 0.0, 20.0, 77.0 })
    {
      const Simplified made = SimplifyLines(
        PolylineBuilder().Loop(Ellipse(40, 20.0, 3.0, degrees)).Lines(), 0.1, 10.0 * tolerance);
      EXPECT_GE(SmallestInsideAngle(made.After.Drawing), SharpAngle);
      EXPECT_LT(made.After.Drawing.NumberOfVertices(), 30);
    }
  }
}

TEST(CornerGuard, SmallLoopsGetNoSharpCornersWhateverTheTolerance)
{
  for (const int count : { 4, 5, 6 })
  {
    const Polylines lines = PolylineBuilder().Loop(Ellipse(count, 3.0, 1.0, 10.0 * count)).Lines();
    const Simplified made = SimplifyLines(lines, 0.2, 1000.0);
    EXPECT_GE(SmallestInsideAngle(made.After.Drawing),
      std::min(SharpAngle, SmallestInsideAngle(made.Before)) - 1e-6);
  }
}

/// The sides of a slit do not come to meet at its tip: but for rounding they would be one.
TEST(CornerGuard, NoNeedleIsMadeOutsideOfTheDomain)
{
  const double width = 1e-9;
  const Simplified made =
    SimplifyLines(PolylineBuilder()
                    .Loop({ { 0.0, 0.0 }, { 1.0, 0.0 }, { 1.0, 1.0 }, { 0.5 + width, 1.0 },
                      { 0.5 + width, 0.3 }, { 0.5, 0.3 }, { 0.5, 1.0 }, { 0.0, 1.0 } })
                    .Lines(),
      0.2, 1.0);
  EXPECT_EQ(made.After.RemovedVertices, 0);
}

TEST(CornerGuard, AnglesBetweenChainsStay)
{
  // The interface leaves the boundary at 60 degrees, and would at 27.
  const Simplified made = SimplifyLines(PolylineBuilder()
                                          .Box(0.0, 0.0, 100.0, 100.0)
                                          .Chain({ { 0.0, 0.0 }, { 2.0, 3.5 }, { 12.0, 6.0 } })
                                          .Lines(),
    0.4, 10.0);
  EXPECT_EQ(made.After.RemovedVertices, 0);
  EXPECT_GT(SmallestInsideAngle(made.After.Drawing), SmallestInsideAngle(made.Before) - 1e-9);
}

} // namespace biting
