// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "../Support/MeshShapes.h"
#include "../Support/Monitors.h"
#include "../Support/PolylineShapes.h"

#include "Blocks/CutFrame.h"

#include <gtest/gtest.h>

#include <cmath> // for cos, sin, abs

namespace biting
{

namespace
{

Point2 Direction(double angle)
{
  return { std::cos(angle), std::sin(angle) };
}

CutFrame FrameOfLoop(const std::vector<Point2>& loop)
{
  Pulse pulse(NoMonitor());
  return FrameOf(Make(PolylineBuilder().Loop(loop).Lines()).Domain, pulse);
}

std::vector<Point2> Rectangle(double width, double height, double angle)
{
  const Point2 side = width * Direction(angle);
  const Point2 other = height * Perpendicular(Direction(angle));
  return { { 0.0, 0.0 }, side, side + other, other };
}

} // namespace

TEST(CutFrame, PlacesInTheFrameOfTheCoordinatesAreTheSameNumbers)
{
  const CutFrame frame;
  for (const Point2& p : { Point2{ 0.1, -0.7 }, Point2{ 1e8 / 3.0, 1e-9 / 3.0 } })
  {
    EXPECT_TRUE(frame.To(p) == p);
    EXPECT_TRUE(frame.From(p) == p);
  }
}

TEST(CutFrame, PlacesComeBackFromEveryFrame)
{
  for (const double angle : { 0.3, -0.7, 0.05 })
  {
    CutFrame frame;
    frame.Axis = Direction(angle);
    const Point2 p{ 0.3, -1.7 };
    EXPECT_LT(Distance(frame.From(frame.To(p)), p), 1e-15);
    EXPECT_NEAR(frame.To(Direction(angle)).X, 1.0, 1e-15);
  }
}

TEST(CutFrame, AxesAreAlongTheSidesOfATurnedSquare)
{
  for (const double angle : { 0.0, 0.1, 0.3, 0.78, 1.2, 2.5 })
  {
    const CutFrame frame = FrameOfLoop(Rectangle(1.0, 1.0, angle));
    EXPECT_NEAR(std::sin(2.0 * angle) * (2.0 * frame.Axis.X * frame.Axis.X - 1.0) -
        std::cos(2.0 * angle) * 2.0 * frame.Axis.X * frame.Axis.Y,
      0.0, 1e-12);
    EXPECT_GE(frame.Axis.X, std::abs(frame.Axis.Y) - 1e-12);
    EXPECT_FALSE(frame.IsMostlyVertical.has_value());
  }
}

TEST(CutFrame, TellsAlongWhichAxisMostOfTheBoundaryRuns)
{
  for (const double angle : { 0.0, 0.3, -0.5 })
  {
    EXPECT_EQ(FrameOfLoop(Rectangle(5.0, 1.0, angle)).IsMostlyVertical, false);
    EXPECT_EQ(FrameOfLoop(Rectangle(1.0, 5.0, angle)).IsMostlyVertical, true);
    EXPECT_FALSE(FrameOfLoop(Rectangle(2.0, 1.0, angle)).IsMostlyVertical.has_value());
  }
}

TEST(CutFrame, WhereTheBoundaryHasNoDirectionAxesAreThoseOfTheCoordinates)
{
  Pulse pulse(NoMonitor());
  for (const CutFrame& frame : { FrameOfLoop(RegularPolygon({ 0.0, 0.0 }, 1.0, 90)),
         FrameOfLoop(RegularPolygon({ 0.0, 0.0 }, 1.0, 5)), FrameOf(Domain(), pulse) })
  {
    EXPECT_TRUE(frame.Axis == (Point2{ 1.0, 0.0 }));
    EXPECT_FALSE(frame.IsMostlyVertical.has_value());
  }
}

TEST(CutFrame, LongestSidesAreThoseOfTheBoundaryThatAreParallelToTheAxes)
{
  Pulse pulse(NoMonitor());
  for (const double angle : { 0.0, 0.2 })
  {
    CutFrame frame;
    frame.Axis = Direction(angle);
    std::vector<Point2> hexagon = RegularPolygon({ 0.0, 0.0 }, 1.0, 6);
    for (Point2& corner : hexagon)
    {
      corner = frame.From(corner);
    }
    const Domain domain = Make(PolylineBuilder().Loop(hexagon).Lines()).Domain;
    const Box2 sides = LongestSidesIn(frame, domain, pulse);
    const Box2 bounds = BoundsIn(frame, domain);
    EXPECT_NEAR(sides.Low.X, -0.5, 1e-15);
    EXPECT_NEAR(sides.High.X, 0.5, 1e-15);
    EXPECT_EQ(sides.Low.Y, bounds.Low.Y);
    EXPECT_EQ(sides.High.Y, bounds.High.Y);
  }
}

/// Drawings may have millions of segments.
TEST(CutFrame, AsksTheMonitorAllTheWayAlongTheBoundary)
{
  const Domain domain =
    Make(PolylineBuilder().Loop(RegularPolygon({ 0.0, 0.0 }, 1.0, 40000)).Lines()).Domain;
  StoppingMonitor monitor(1 << 20);
  Pulse pulse(monitor);
  FrameOf(domain, pulse);
  EXPECT_GT(monitor.Calls, 16);
  StoppingMonitor stopping(2);
  Pulse stopped(stopping);
  FrameOf(domain, stopped);
  EXPECT_TRUE(stopped.HasStopped());
  EXPECT_LT(stopping.Calls, 5);
}

} // namespace biting
