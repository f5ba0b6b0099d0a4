// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SimplifiedDrawing.h"

#include <gtest/gtest.h>

#include <cmath> // for round

namespace biting
{

namespace
{

constexpr double Rounding = 1e-9;

/// A side of a polygon in steps of one.
void AddSide(const Point2& end, std::vector<Point2>& places)
{
  const Point2 start = places.back();
  const int count = static_cast<int>(std::round(Distance(start, end)));
  for (int k = 1; k <= count; ++k)
  {
    places.push_back(start + (static_cast<double>(k) / count) * (end - start));
  }
}

std::vector<Point2> InSteps(const std::vector<Point2>& corners)
{
  std::vector<Point2> places{ corners.front() };
  for (std::size_t k = 1; k <= corners.size(); ++k)
  {
    AddSide(corners[k % corners.size()], places);
  }
  places.pop_back();
  return places;
}

bool HasPlace(const Domain& domain, const Point2& place)
{
  return std::find(domain.Vertices.begin(), domain.Vertices.end(), place) != domain.Vertices.end();
}

double LeastLength(const Domain& domain)
{
  double least = std::numeric_limits<double>::infinity();
  for (Id segment = 0; segment < domain.NumberOfSegments(); ++segment)
  {
    least = std::min(least,
      Distance(domain.Vertices[domain.Starts[segment]], domain.Vertices[domain.Ends[segment]]));
  }
  return least;
}

/// A rough loop with a rough hole, an interface, a small hole and embedded points.
Polylines RoughDrawing()
{
  std::vector<Point2> hole = RoughLoop(8, 30.0, 5);
  std::vector<Point2> interface;
  TestNumbers numbers(9);
  for (int k = 0; k <= 200; ++k)
  {
    interface.push_back({ 35.0 + 0.1 * k, -0.01 * numbers.Below(100) });
  }
  return PolylineBuilder()
    .Loop(RoughLoop(10, 100.0, 3), ChainKind::Boundary)
    .Loop(hole, ChainKind::Boundary)
    .Chain(interface, ChainKind::Interface)
    .Loop(InSteps({ { -60.0, 3.0 }, { -50.0, 3.0 }, { -50.0, 9.0 }, { -60.0, 9.0 } }),
      ChainKind::Boundary)
    .Chain({ { 3.0, 61.0 }, { -3.0, -62.0 }, { 1.0, 50.0 } }, ChainKind::EmbeddedPoint)
    .Lines();
}

void ExpectSamePlaces(const Domain& expected, const Domain& given, double tolerance)
{
  const std::vector<Point2> first = PlacesOf(expected);
  const std::vector<Point2> second = PlacesOf(given);
  ASSERT_EQ(first.size(), second.size());
  for (std::size_t k = 0; k < first.size(); ++k)
  {
    EXPECT_LE(Distance(first[k], second[k]), tolerance);
  }
}

} // namespace

TEST(Simplification, WithoutToleranceNothingGoes)
{
  const Simplified made = SimplifyLines(RoughDrawing(), 0.0, 10.0);
  EXPECT_EQ(made.Before.Vertices, made.After.Drawing.Vertices);
  EXPECT_EQ(made.Before.Starts, made.After.Drawing.Starts);
  EXPECT_EQ(made.Before.Ends, made.After.Drawing.Ends);
  EXPECT_EQ(made.After.RemovedVertices, 0);
}

TEST(Simplification, BothDrawingsStayWithinTheToleranceOfEachOther)
{
  const auto spacing = [](const Point2& p) { return 2.0 + 0.1 * std::abs(p.X + 50.0); };
  for (const double tolerance : { 0.05, 0.2, 0.5, 1.0 })
  {
    SimplificationOptions options;
    options.Tolerance = tolerance;
    const Simplified made = SimplifyLines(RoughDrawing(), options, spacing);
    EXPECT_EQ(made.Violation, "");
    // f differs by its slope between a place and the nearest one.
    const double most = tolerance / (1.0 - 0.1 * tolerance);
    EXPECT_LE(LargestDistance(made.Before, made.After.Drawing, spacing), most);
    EXPECT_LE(LargestDistance(made.After.Drawing, made.Before, spacing, 40), most);
    EXPECT_LT(2 * made.After.Drawing.NumberOfVertices(), made.Before.NumberOfVertices());
  }
}

TEST(Simplification, PiecesFacesAndLonePointsStay)
{
  for (const double tolerance : { 0.1, 1.0, 10.0 })
  {
    const Simplified made = SimplifyLines(RoughDrawing(), tolerance, 10.0);
    EXPECT_EQ(made.Violation, "");
    EXPECT_TRUE(ConnectionsOf(made.Before) == ConnectionsOf(made.After.Drawing));
  }
}

TEST(Simplification, LoopsFarSmallerThanTheToleranceKeepThreeVertices)
{
  const Simplified made = SimplifyLines(RoughDrawing(), 1.0, 1000.0);
  EXPECT_EQ(made.Violation, "");
  EXPECT_TRUE(ConnectionsOf(made.Before) == ConnectionsOf(made.After.Drawing));
  EXPECT_LE(made.After.Drawing.NumberOfSegments(), 3 + 12 + 8);
}

TEST(Simplification, SegmentsOfAPixelDiscBecomeAsLongAsTheSpacing)
{
  const Simplified made =
    SimplifyLines(PolylineBuilder().Loop(PixelDisc({ 0.0, 0.0 }, 60.0)).Lines(), 0.2, 10.0);
  EXPECT_EQ(made.Violation, "");
  EXPECT_GT(LeastLength(made.After.Drawing), 7.0);
  EXPECT_NEAR(made.After.Drawing.Area, made.Before.Area, 0.03 * made.Before.Area);
  EXPECT_EQ(made.After.DrawnEnds.size(), 2 * made.Before.Starts.size());
}

TEST(Simplification, ACornerStays)
{
  const std::vector<Point2> corners{ { 0.0, 0.0 }, { 90.0, 0.0 }, { 90.0, 40.0 }, { 50.0, 40.0 },
    { 50.0, 70.0 }, { 0.0, 70.0 } };
  for (const double tolerance : { 0.05, 0.2, 0.4 })
  {
    const Simplified made =
      SimplifyLines(PolylineBuilder().Loop(InSteps(corners)).Lines(), tolerance, 10.0);
    ExpectSamePlaces(Make(PolylineBuilder().Loop(corners)).Domain, made.After.Drawing, 0.0);
  }
}

TEST(Simplification, ACornerStaysFromTheAngleOn)
{
  // Sides of five tolerances that turn by 20 degrees: each corner is .9 tolerances high.
  const std::vector<Point2> corners = RegularPolygon({ 0.0, 0.0 }, 60.0, 18, 3.0);
  const Polylines lines = PolylineBuilder().Loop(InSteps(corners)).Lines();
  for (const double angle : { 15.0, 45.0 })
  {
    SimplificationOptions options;
    options.Tolerance = 0.2;
    options.CornerAngle = angle;
    const Simplified made = SimplifyLines(lines, options, [](const Point2&) { return 20.0; });
    EXPECT_EQ(made.After.Drawing.NumberOfVertices() == 18, angle < 20.0);
  }
}

TEST(Simplification, ACornerWithinTheToleranceOfAnEndIsNone)
{
  const Simplified made = SimplifyLines(PolylineBuilder()
                                          .Box(0.0, 0.0, 100.0, 100.0)
                                          .Chain({ { 10.0, 50.0 }, { 60.0, 50.0 }, { 60.0, 51.0 } })
                                          .Lines(),
    0.2, 10.0);
  EXPECT_FALSE(HasPlace(made.After.Drawing, { 60.0, 50.0 }));
}

TEST(Simplification, AZigzagOfPixelsIsNoRowOfCorners)
{
  std::vector<Point2> places;
  for (int k = 0; k < 50; ++k)
  {
    places.push_back({ 2.0 * k, static_cast<double>(k) });
    places.push_back({ 2.0 * k + 2.0, static_cast<double>(k) });
  }
  places.push_back({ 0.0, 60.0 });
  const Simplified made = SimplifyLines(PolylineBuilder().Loop(places).Lines(), 0.25, 5.0);
  EXPECT_LE(made.After.Drawing.NumberOfVertices(), 5);
}

TEST(Simplification, EndsJunctionsAndEmbeddedPointsStay)
{
  std::vector<Point2> wave;
  for (int k = 0; k <= 80; ++k)
  {
    wave.push_back({ 10.0 + k, 50.0 + (k % 2 == 0 ? 0.0 : 0.5) });
  }
  const Simplified made = SimplifyLines(PolylineBuilder()
                                          .Box(0.0, 0.0, 100.0, 100.0)
                                          .Chain(wave)
                                          .Chain({ wave[30], { 40.0, 60.0 } })
                                          .Chain({ { 70.0, 50.2 } }, ChainKind::EmbeddedPoint)
                                          .Lines(),
    0.2, 10.0);
  for (const Point2& place : { wave.front(), wave.back(), wave[30], Point2{ 70.0, 50.2 } })
  {
    EXPECT_TRUE(HasPlace(made.After.Drawing, place));
  }
  EXPECT_EQ(made.Violation, "");
}

TEST(Simplification, EmbeddedPointsOnChainsStay)
{
  for (const ChainKind kind : { ChainKind::Boundary, ChainKind::Interface })
  {
    SimplificationOptions options;
    options.Tolerance = 0.5;
    options.MinimumLoopSize = 1.0;
    const Simplified made =
      SimplifyLines(PolylineBuilder()
                      .Box(-100.0, -100.0, 100.0, 100.0)
                      .Loop(InSteps({ { 0, 0 }, { 9, 0 }, { 9, 9 }, { 0, 9 } }), kind)
                      .Chain({ { 4, 0 }, { 9, 2.5 }, { -50, 100 } }, ChainKind::EmbeddedPoint)
                      .Lines(),
        options, [](const Point2&) { return 10.0; });
    EXPECT_EQ(made.Violation, "");
    EXPECT_EQ(made.After.LeftOutLoops, 0);
    EXPECT_GT(made.After.RemovedVertices, 30);
    for (const Point2& place : { Point2{ 4, 0 }, Point2{ 9, 2.5 }, Point2{ -50, 100 } })
    {
      EXPECT_TRUE(HasPlace(made.After.Drawing, place));
    }
  }
}

TEST(Simplification, AnEmbeddedPointStaysOnItsSide)
{
  std::vector<Point2> places =
    InSteps({ { 0.0, 0.0 }, { 40.0, 0.0 }, { 40.0, 40.0 }, { 0.0, 40.0 } });
  for (Point2& place : places)
  {
    place = place.Y == 0.0 && place.X == 20.0 ? Point2{ 20.0, -1.0 } : place;
  }
  const Polylines lines =
    PolylineBuilder().Loop(places).Chain({ { 20.0, -0.5 } }, ChainKind::EmbeddedPoint).Lines();
  const Simplified made = SimplifyLines(lines, 0.5, 10.0);
  EXPECT_TRUE(HasPlace(made.After.Drawing, { 20.0, -1.0 }));
  EXPECT_EQ(made.Violation, "");
}

TEST(Simplification, AVertexBetweenTagsStays)
{
  const std::vector<Point2> places =
    InSteps({ { 0.0, 0.0 }, { 40.0, 0.0 }, { 40.0, 40.0 }, { 0.0, 40.0 } });
  SimplificationOptions options;
  options.Tolerance = 0.2;
  options.AreAlike = [](Id first, Id second) { return first / 7 == second / 7; };
  const Simplified made = SimplifyLines(
    Unmerge(PolylineBuilder().Loop(places).Lines()), options, [](const Point2&) { return 10.0; });
  for (std::size_t k = 0; k < places.size(); k += 7)
  {
    EXPECT_TRUE(HasPlace(made.After.Drawing, places[k]));
  }
  EXPECT_FALSE(HasPlace(made.After.Drawing, places[1]));
}

TEST(Simplification, ASegmentHasTheCellOfTheFirstItStandsFor)
{
  const Simplified made = SimplifyLines(
    Unmerge(PolylineBuilder()
              .Loop(InSteps({ { 0.0, 0.0 }, { 40.0, 0.0 }, { 40.0, 40.0 }, { 0.0, 40.0 } }))
              .Lines()),
    0.2, 10.0);
  EXPECT_EQ(made.After.Drawing.Cells, std::vector<Id>({ 0, 40, 80, 120 }));
  EXPECT_EQ(made.After.Drawing.VertexPoints.size(), 4u);
}

TEST(Simplification, AChannelStaysOpen)
{
  // Two walls of zigzag, nearer to each other than the tolerance.
  std::vector<Point2> places{ { 0.0, 0.0 } };
  for (int k = 0; k <= 400; ++k)
  {
    places.push_back({ 10.0 + 0.2 * k, 20.0 + 0.1 * (k % 2) });
  }
  for (int k = 400; k >= 0; --k)
  {
    places.push_back({ 10.0 + 0.2 * k, 20.3 + 0.1 * (k % 2) });
  }
  places.push_back({ 0.0, 40.0 });
  for (const double spacing : { 1.0, 5.0, 50.0 })
  {
    const Simplified made = SimplifyLines(PolylineBuilder().Loop(places).Lines(), 0.5, spacing);
    EXPECT_EQ(made.Violation, "");
    EXPECT_TRUE(ConnectionsOf(made.Before) == ConnectionsOf(made.After.Drawing));
    EXPECT_LT(made.After.Drawing.NumberOfVertices(), 40);
  }
}

TEST(Simplification, ASpiralStaysASpiral)
{
  std::vector<Point2> outwards;
  std::vector<Point2> inwards;
  for (int k = 0; k <= 2000; ++k)
  {
    const double turns = k / 200.0;
    outwards.push_back((1.0 + turns) * UnitVector(360.0 * turns));
    inwards.push_back((1.4 + turns) * UnitVector(360.0 * turns));
  }
  outwards.insert(outwards.end(), inwards.rbegin(), inwards.rend());
  for (const double tolerance : { 0.05, 0.5, 2.0 })
  {
    const Simplified made = SimplifyLines(PolylineBuilder().Loop(outwards).Lines(), tolerance, 4.0);
    EXPECT_EQ(made.Violation, "");
    EXPECT_EQ(ConnectionsOf(made.After.Drawing).Cycles, 1);
    EXPECT_LT(made.After.Drawing.NumberOfVertices(), 1000);
  }
}

TEST(Simplification, DirectionAndCellsOfTheInputPlayNoPart)
{
  const Polylines lines = RoughDrawing();
  const Simplified made = SimplifyLines(lines, 0.2, 10.0);
  for (const Polylines& same : { Reverse(lines), Unmerge(lines), Reverse(Unmerge(lines)) })
  {
    ExpectSamePlaces(made.After.Drawing, SimplifyLines(same, 0.2, 10.0).After.Drawing, 0.0);
  }
}

TEST(Simplification, MovedScaledAndTurnedItIsTheSame)
{
  const Polylines lines = RoughDrawing();
  const Simplified made = SimplifyLines(lines, 0.2, 10.0);
  const Point2 axis = UnitVector(27.0);
  struct Motion
  {
    double Scale;
    std::function<Point2(const Point2&)> Forth;
    std::function<Point2(const Point2&)> Back;
  };
  const Motion motions[] = {
    { 1.0,
      [](const Point2& p) {
        return p + Point2{ 1000.0, -300.0 };
      },
      [](const Point2& p) {
        return p - Point2{ 1000.0, -300.0 };
      } },
    { 3.7, [](const Point2& p) { return 3.7 * p; }, [](const Point2& p) { return (1 / 3.7) * p; } },
    { 1.0, [&axis](const Point2& p) { return p.X * axis + p.Y * Perpendicular(axis); },
      [&axis](const Point2& p) {
        return Point2{ Dot(p, axis), Cross(axis, p) };
      } },
    { 1.0,
      [](const Point2& p) {
        return Point2{ -p.X, p.Y };
      },
      [](const Point2& p) {
        return Point2{ -p.X, p.Y };
      } },
  };
  for (const Motion& motion : motions)
  {
    Simplified moved = SimplifyLines(Move(lines, motion.Forth), 0.2, 10.0 * motion.Scale);
    for (Point2& place : moved.After.Drawing.Vertices)
    {
      place = motion.Back(place);
    }
    ExpectSamePlaces(made.After.Drawing, moved.After.Drawing, Rounding);
  }
}

TEST(Simplification, SmallLoopsAreLeftOut)
{
  SimplificationOptions options;
  options.MinimumLoopSize = 2.0;
  const Simplified made = SimplifyLines(PolylineBuilder()
                                          .Box(0.0, 0.0, 100.0, 100.0)
                                          .Box(10.0, 10.0, 29.0, 12.0)
                                          .Box(40.0, 10.0, 61.0, 12.0)
                                          .Box(80.0, 80.0, 81.0, 81.0, ChainKind::Interface)
                                          .Lines(),
    options, [](const Point2&) { return 10.0; });
  EXPECT_EQ(made.After.LeftOutLoops, 2);
  EXPECT_EQ(made.After.LeftOutArea, 39.0);
  EXPECT_EQ(made.After.Drawing.NumberOfSegments(), 8);
  EXPECT_EQ(made.After.Drawing.Area, 10000.0 - 42.0);
  EXPECT_EQ(made.Problems.Count(ProblemCode::SmallLoops), 2);
  EXPECT_EQ(made.Violation, "");
}

TEST(Simplification, AnIslandGoesWithItsLake)
{
  SimplificationOptions options;
  options.MinimumLoopSize = 2.0;
  const Simplified made = SimplifyLines(PolylineBuilder()
                                          .Box(0.0, 0.0, 100.0, 100.0)
                                          .Box(10.0, 10.0, 28.0, 28.0)
                                          .Box(12.0, 12.0, 26.0, 26.0)
                                          .Lines(),
    options, [](const Point2&) { return 10.0; });
  EXPECT_EQ(made.After.LeftOutLoops, 2);
  EXPECT_EQ(made.After.Drawing.Area, 10000.0);
}

TEST(Simplification, ALoopWithSomethingInItStays)
{
  SimplificationOptions options;
  options.MinimumLoopSize = 2.0;
  const auto spacing = [](const Point2&) { return 10.0; };
  // The lake has an island of its own; that goes, the lake stays, and so the island around it.
  const Simplified lake = SimplifyLines(PolylineBuilder()
                                          .Box(0.0, 0.0, 100.0, 100.0)
                                          .Box(10.0, 10.0, 28.0, 28.0)
                                          .Box(12.0, 12.0, 26.0, 26.0)
                                          .Box(14.0, 14.0, 15.0, 15.0)
                                          .Lines(),
    options, spacing);
  EXPECT_EQ(lake.After.LeftOutLoops, 1);
  EXPECT_EQ(lake.Violation, "");
  const Simplified point = SimplifyLines(PolylineBuilder()
                                           .Box(0.0, 0.0, 100.0, 100.0)
                                           .Box(10.0, 10.0, 28.0, 28.0, ChainKind::Interface)
                                           .Chain({ { 20.0, 20.0 } }, ChainKind::EmbeddedPoint)
                                           .Lines(),
    options, spacing);
  EXPECT_EQ(point.After.LeftOutLoops, 0);
}

TEST(Simplification, TheLargestLoopStays)
{
  SimplificationOptions options;
  options.MinimumLoopSize = 2.0;
  const Simplified made =
    SimplifyLines(PolylineBuilder().Box(0.0, 0.0, 1.0, 1.0).Box(5.0, 5.0, 7.0, 6.0).Lines(),
      options, [](const Point2&) { return 10.0; });
  EXPECT_EQ(made.After.LeftOutLoops, 1);
  EXPECT_EQ(made.After.Drawing.Area, 2.0);
}

} // namespace biting
