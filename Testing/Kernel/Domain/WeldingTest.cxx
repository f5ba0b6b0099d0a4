// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Support/PolylineShapes.h"

#include <gtest/gtest.h>

#include <algorithm> // for sort, reverse, min, any_of
#include <cmath>     // for nextafter, cos, sin, ldexp

namespace biting
{

namespace
{

constexpr double Pi = 3.14159265358979323846;
constexpr double FloatUlp = 0x1p-23; ///< of numbers from 1 to 2

MadeDomain MakeWelded(const Polylines& input, double mergeTolerance)
{
  MadeDomain made;
  SilentMonitor monitor;
  DomainOptions options;
  options.MergeTolerance = mergeTolerance;
  made.Domain = MakeDomain(input, options, made.Problems, monitor);
  made.Violation = CheckDomain(made.Domain);
  return made;
}

/// As drawn with floats whose largest coordinate is `largest`.
Polylines InFloats(const PolylineBuilder& builder, double largest)
{
  Polylines lines = builder.Lines();
  const double rounding = NoiseInUlp * FloatUlp * largest;
  lines.Rounding = { rounding, rounding };
  return lines;
}

std::vector<Point2> Circle(int count, double radius)
{
  std::vector<Point2> places;
  for (int i = 0; i < count; ++i)
  {
    const double angle = 2.0 * Pi * i / count;
    places.push_back({ radius * std::cos(angle), radius * std::sin(angle) });
  }
  return places;
}

double LeastDistance(const std::vector<Point2>& places)
{
  double least = 1e300;
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      least = std::min(least, Distance(places[i], places[j]));
    }
  }
  return least;
}

std::vector<Point2> Sorted(std::vector<Point2> places)
{
  std::sort(places.begin(), places.end());
  return places;
}

TEST(Welding, PointsWithinTheRoundingOfFloatsAreOne)
{
  const PolylineBuilder builder = PolylineBuilder().Loop(
    { { 0, 0 }, { 1, 0 }, { 1, 1e-7 }, { 1, 1 }, { 3e-17, 1 }, { 0, 1 - 1e-7 } });
  const MadeDomain made = Make(InFloats(builder, 1.0));
  EXPECT_EQ(made.Violation, "");
  EXPECT_EQ(made.Domain.NumberOfVertices(), 4);
  EXPECT_EQ(made.Problems.Groups().size(), 1u);
  EXPECT_EQ(made.Problems.Count(ProblemCode::NearPoints), 2);
  EXPECT_NEAR(made.Domain.Area, 1.0, 1e-6);
}

TEST(Welding, ShortSegmentsAboveTheRoundingOfFloatsStay)
{
  const PolylineBuilder builder =
    PolylineBuilder().Loop({ { 0, 0 }, { 1, 0 }, { 1, 10 * FloatUlp }, { 1, 1 }, { 0, 1 } });
  const MadeDomain made = Make(InFloats(builder, 1.0));
  EXPECT_TRUE(made.Problems.Groups().empty());
  EXPECT_EQ(made.Domain.NumberOfVertices(), 5);
}

/// Each of two points may be 3.5 units off.
TEST(Welding, PointsSevenUnitsApartAreOneInFloats)
{
  const PolylineBuilder builder =
    PolylineBuilder().Loop({ { 0, 0 }, { 1, 0 }, { 1, 7 * FloatUlp }, { 1, 1 }, { 0, 1 } });
  EXPECT_EQ(Make(InFloats(builder, 1.0)).Domain.NumberOfVertices(), 4);
}

constexpr double Seam = SeamInUlp * 0x1p-52; ///< of a drawing of size 1

Polylines WithSeams(const PolylineBuilder& builder)
{
  Polylines lines = builder.Lines();
  lines.SeamNoise = Seam;
  return lines;
}

/// Two halves of a disk, each with points of its own on the seam.
TEST(Welding, PointsOnBothSidesOfASeamAreOne)
{
  const PolylineBuilder halves =
    PolylineBuilder()
      .Chain({ { 0, 0 }, { 1, 0 }, { 1, 1 } })
      .Chain({ { 1 - 0.6 * Seam, 1 + 0.6 * Seam }, { 0, 1 }, { 0, 0 } });
  const MadeDomain made = Make(WithSeams(halves));
  EXPECT_EQ(made.Violation, "");
  EXPECT_EQ(made.Domain.NumberOfVertices(), 4);
  EXPECT_EQ(made.Problems.Count(ProblemCode::NearPoints), 1);
  EXPECT_NEAR(made.Domain.Area, 1.0, Seam);
}

TEST(Welding, PointsFurtherApartThanASeamStay)
{
  const MadeDomain made = Make(WithSeams(
    PolylineBuilder().Loop({ { 0, 0 }, { 1, 0 }, { 1, 1.5 * Seam }, { 1, 1 }, { 0, 1 } })));
  EXPECT_TRUE(made.Problems.Groups().empty());
  EXPECT_EQ(made.Domain.NumberOfVertices(), 5);
}

/// The bend of a side, and the tip of a notch before another one, as thin as seams are wide.
TEST(Welding, BendsAndWallsThinnerThanASeamStay)
{
  const double thin = 0.25 * Seam; // 8 units in the last place of 1
  const MadeDomain made = Make(WithSeams(PolylineBuilder().Loop({ { 0, 0 }, { 0.5, -thin },
    { 1, 0 }, { 1, 1 }, { 0.6, 1 }, { 0.5, thin }, { 0.4, 1 }, { 0, 1 } })));
  EXPECT_EQ(made.Violation, "");
  EXPECT_EQ(made.Domain.NumberOfVertices(), 7); // bend and tip are one
  EXPECT_EQ(made.Problems.Count(ProblemCode::NearPoints), 1);
  const MadeDomain beside = Make(WithSeams(PolylineBuilder().Loop({ { 0, 0 }, { 0.3, -thin },
    { 1, 0 }, { 1, 1 }, { 0.7, 1 }, { 0.6, thin }, { 0.5, 1 }, { 0, 1 } })));
  EXPECT_EQ(beside.Violation, "");
  EXPECT_EQ(beside.Domain.NumberOfVertices(), 8);
  EXPECT_TRUE(beside.Problems.Groups().empty());
}

TEST(Welding, TheSameDrawingInDoublesKeepsAllOfItsPoints)
{
  const MadeDomain made =
    Make(PolylineBuilder().Loop({ { 0, 0 }, { 1, 0 }, { 1, 1e-7 }, { 1, 1 }, { 0, 1 } }));
  EXPECT_TRUE(made.Problems.Groups().empty());
  EXPECT_EQ(made.Domain.NumberOfVertices(), 5);
}

TEST(Welding, AChainWithEndsAtOnePlaceIsClosed)
{
  const double beyond = std::nextafter(1.0, 2.0);
  const MadeDomain made =
    Make(PolylineBuilder().Chain({ { 1, 1 }, { 2, 1 }, { 2, 2 }, { 1, 2 }, { 1, beyond } }));
  EXPECT_EQ(made.Violation, "");
  EXPECT_DOUBLE_EQ(made.Domain.Area, 1.0);
  EXPECT_EQ(made.Problems.Count(ProblemCode::NearPoints), 1);
}

TEST(Welding, MergeToleranceClosesAGap)
{
  const PolylineBuilder gap = PolylineBuilder().Box(0, 0, 1, 1).Box(1.001, 0, 2, 1);
  const MadeDomain apart = MakeWelded(gap.Lines(), 0.0);
  EXPECT_DOUBLE_EQ(apart.Domain.Area, 1.999);
  const MadeDomain merged = MakeWelded(gap.Lines(), 0.001);
  EXPECT_EQ(merged.Violation, "");
  EXPECT_DOUBLE_EQ(merged.Domain.Area, 2.0);
  EXPECT_EQ(merged.Problems.Count(ProblemCode::NearPoints), 2);
}

TEST(Welding, MergeToleranceMovesAVertexOntoASegment)
{
  const MadeDomain made = MakeWelded(
    PolylineBuilder().Box(0, 0, 3, 1).Loop({ { 1, 1.001 }, { 2, 2 }, { 1, 2 } }).Lines(), 0.001);
  EXPECT_EQ(made.Violation, "");
  EXPECT_EQ(made.Domain.NumberOfVertices(), 7);
  EXPECT_EQ(made.Problems.Count(ProblemCode::NearPoints), 1);
}

TEST(Welding, NoVertexMovesFurtherThanTheTolerance)
{
  const std::vector<Point2> circle = Circle(1000, 1.0);
  const double tolerance = 0.01; // of the diagonal, 2.83: a chain of such steps leads around it all
  const MadeDomain made = MakeWelded(PolylineBuilder().Loop(circle).Lines(), tolerance);
  const double reach = tolerance * made.Domain.Bounds.Diagonal() / (1.0 - 2.0 * tolerance);
  EXPECT_EQ(made.Violation, "");
  EXPECT_GT(LeastDistance(made.Domain.Vertices), tolerance * made.Domain.Bounds.Diagonal());
  for (const Point2& p : circle)
  {
    EXPECT_TRUE(std::any_of(made.Domain.Vertices.begin(), made.Domain.Vertices.end(),
      [&p, reach](const Point2& vertex) { return Distance(vertex, p) <= reach; }));
  }
  EXPECT_NEAR(made.Domain.Area, Pi, 0.01);
}

TEST(Welding, TheOrderOfChainsAndPointsDoesNotMatter)
{
  std::vector<Point2> loop = Circle(500, 1.0);
  const std::vector<Point2> inner = Circle(77, 0.985);
  const MadeDomain made = MakeWelded(PolylineBuilder().Loop(loop).Loop(inner).Lines(), 0.007);
  std::rotate(loop.begin(), loop.begin() + 123, loop.end());
  std::reverse(loop.begin(), loop.end());
  const MadeDomain other = MakeWelded(PolylineBuilder().Loop(inner).Loop(loop).Lines(), 0.007);
  EXPECT_EQ(made.Violation, "");
  EXPECT_EQ(Sorted(made.Domain.Vertices), Sorted(other.Domain.Vertices));
  EXPECT_EQ(
    made.Problems.Count(ProblemCode::NearPoints), other.Problems.Count(ProblemCode::NearPoints));
}

TEST(Welding, TheUnitOfLengthDoesNotMatter)
{
  const std::vector<Point2> loop = Circle(300, 1.0);
  std::vector<Point2> large;
  for (const Point2& p : loop)
  {
    large.push_back({ std::ldexp(p.X, 40), std::ldexp(p.Y, 40) });
  }
  const MadeDomain made = MakeWelded(PolylineBuilder().Loop(loop).Lines(), 0.02);
  const MadeDomain other = MakeWelded(PolylineBuilder().Loop(large).Lines(), 0.02);
  EXPECT_EQ(made.Domain.VertexPoints, other.Domain.VertexPoints);
}

TEST(Welding, BoundariesKeepTheirPlacesBesideEmbeddedPoints)
{
  const double before = std::nextafter(1.0, 0.0);
  const MadeDomain made = Make(PolylineBuilder()
                                 .Chain({ { before, before } }, ChainKind::EmbeddedPoint)
                                 .Chain({ { before, 1 }, { 0.5, 0.5 } }, ChainKind::Interface)
                                 .Box(0, 0, 1, 1));
  EXPECT_EQ(made.Violation, "");
  EXPECT_EQ(made.Domain.Area, 1.0);
  EXPECT_EQ(made.Domain.NumberOfVertices(), 5);
  EXPECT_EQ(Sorted(made.Domain.Vertices).back(), (Point2{ 1, 1 }));
  EXPECT_EQ(made.Problems.Count(ProblemCode::NearPoints), 2);
}

TEST(Welding, AnInterfaceMayEndOnABoundaryButForRounding)
{
  const double before = std::nextafter(1.0, 0.0);
  const MadeDomain made =
    Make(PolylineBuilder().Box(0, 0, 1, 1).Chain({ { 0.5, 0.5 }, { before, 0.5 } }));
  EXPECT_EQ(made.Violation, "");
  EXPECT_TRUE(made.Problems.Groups().empty());
  EXPECT_EQ(made.Domain.NumberOfVertices(), 6);
}

TEST(Welding, ABoundaryThatAToleranceMovesToAnEmbeddedPointIsToldOf)
{
  const PolylineBuilder builder =
    PolylineBuilder().Box(0, 0, 1, 1).Chain({ { 0.5, 0.001 } }, ChainKind::EmbeddedPoint);
  EXPECT_TRUE(MakeWelded(builder.Lines(), 0.0).Problems.Groups().empty());
  const MadeDomain made = MakeWelded(builder.Lines(), 0.001);
  EXPECT_EQ(made.Violation, "");
  EXPECT_EQ(made.Domain.NumberOfSegments(), 5);
  EXPECT_EQ(made.Problems.Count(ProblemCode::NearPoints), 1);
}

TEST(Welding, AnInterfaceAlongASideButForRoundingIsOnIt)
{
  for (int turn = 1; turn < 20; ++turn)
  {
    const Point2 side{ 1.0, 0.11 * turn };
    const Point2 out{ -side.Y, side.X };
    std::vector<Point2> along;
    for (int k = 0; k <= 6; ++k)
    {
      along.push_back((k / 6.0) * side);
    }
    const MadeDomain made =
      Make(PolylineBuilder().Loop({ { 0, 0 }, side, side + out, out }).Chain(along));
    EXPECT_EQ(made.Violation, "");
    EXPECT_EQ(made.Domain.NumberOfSegments(), 9);
    EXPECT_NEAR(made.Domain.Area, Cross(side, out), 1e-15);
  }
}

TEST(Welding, AFrameThinnerThanRoundingIsToldOf)
{
  const MadeDomain made =
    Make(PolylineBuilder().Box(0, 0, 1000, 1).Box(5e-13, 0.25, 1000 - 5e-13, 0.75));
  EXPECT_EQ(made.Violation, "");
  EXPECT_EQ(made.Problems.Count(ProblemCode::NearPoints), 4);
}

TEST(Welding, SoItIsWhereEachSegmentIsAChainOfItsOwn)
{
  const MadeDomain made = Make(
    Unmerge(PolylineBuilder().Box(0, 0, 1000, 1).Box(5e-13, 0.25, 1000 - 5e-13, 0.75).Lines()));
  EXPECT_EQ(made.Violation, "");
  EXPECT_EQ(made.Problems.Count(ProblemCode::NearPoints), 4);
}

} // namespace

} // namespace biting
