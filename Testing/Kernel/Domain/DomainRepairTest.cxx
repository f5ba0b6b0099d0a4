// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "DomainLaws.h"

#include <cmath>  // for cos, sin
#include <limits> // for infinity

namespace biting
{

namespace
{

TEST(Domain, DropsRepeatedPointsWithAWord)
{
  Polylines input = PolylineBuilder().Box(0, 0, 1, 1).Lines();
  input.Connectivity.insert(input.Connectivity.begin(), 0);
  input.Offsets.back() += 1;
  const MadeDomain sameId = Make(input);
  ExpectDomain(sameId, 1.0, 1);
  EXPECT_EQ(FirstIds(sameId, ProblemCode::ZeroLengthSegments), (Ids{ 0, 0 }));
  const MadeDomain samePlace =
    Make(PolylineBuilder().Loop({ { 0, 0 }, { 1, 0 }, { 1, 0 }, { 1, 1 } }));
  ExpectDomain(samePlace, 0.5, 1);
  EXPECT_EQ(FirstIds(samePlace, ProblemCode::DuplicatePoints), (Ids{ 1, 2 }));
}

TEST(Domain, SplitsACrossing)
{
  const MadeDomain made = Make(PolylineBuilder().Loop({ { 0, 0 }, { 1, 1 }, { 1, 0 }, { 0, 1 } }));
  ExpectDomain(made, 0.5, 1);
  EXPECT_EQ(made.Problems.Count(ProblemCode::Crossings), 1);
  EXPECT_EQ(FirstIds(made, ProblemCode::Crossings), (Ids{ 0, 0 }));
  const auto& points = made.Domain.VertexPoints;
  const auto crossing = std::find(points.begin(), points.end(), NoId) - points.begin();
  EXPECT_EQ(std::count(points.begin(), points.end(), NoId), 1);
  EXPECT_EQ(made.Domain.Vertices[static_cast<std::size_t>(crossing)], (Point2{ 0.5, 0.5 }));
  EXPECT_EQ(made.Domain.NumberOfSegments(), 6);
}

TEST(Domain, ResolvesOverlapsByParity)
{
  const MadeDomain beside = Make(PolylineBuilder().Box(0, 0, 2, 2).Box(2, 1, 4, 3));
  ExpectDomain(beside, 8.0, 2);
  EXPECT_EQ(FirstIds(beside, ProblemCode::DuplicateSegments), (Ids{ 0, 1 }));
  EXPECT_EQ(beside.Problems.Count(ProblemCode::Touches), 2);
  EXPECT_EQ(InterfaceCount(beside.Domain), 1);
  const MadeDomain hole = Make(PolylineBuilder().Box(0, 0, 4, 4).Box(1, 0, 2, 1));
  ExpectDomain(hole, 15.0, 2);
  EXPECT_EQ(InterfaceCount(hole.Domain), 0);
}

TEST(Domain, TellsATouchOnce)
{
  const MadeDomain made =
    Make(PolylineBuilder().Box(0, 0, 4, 4).Loop({ { 2, 4 }, { 3, 6 }, { 1, 6 } }));
  ExpectDomain(made, 18.0, 1);
  EXPECT_EQ(made.Problems.Count(ProblemCode::Touches), 1);
  EXPECT_EQ(FirstIds(made, ProblemCode::Touches), (Ids{ 0, 4 }));
}

TEST(Domain, RefusesDefectsWithoutRepair)
{
  const MadeDomain crossing = Make(PolylineBuilder().Box(0, 0, 2, 2).Box(1, 1, 3, 3), false);
  ExpectRefused(crossing, ProblemCode::NotResolved);
  EXPECT_EQ(FirstIds(crossing, ProblemCode::NotResolved), (Ids{ 0, 1 }));
  EXPECT_EQ(crossing.Problems.Count(ProblemCode::Crossings), 2);
  ExpectRefused(
    Make(PolylineBuilder().Box(0, 0, 1, 1).Box(1, 0, 2, 1), false), ProblemCode::NotResolved);
  ExpectDomain(Make(PolylineBuilder().Box(0, 0, 1, 1), false), 1.0);
}

TEST(Domain, LetsInterfacesEndOnBoundariesSilently)
{
  const PolylineBuilder builder =
    PolylineBuilder().Box(0, 0, 4, 4).Chain({ { 1, 0 }, { 1, 4 } }).Chain({ { 2, 2 }, { 3, 3 } });
  const MadeDomain made = Make(builder, false);
  ExpectDomain(made, 16.0);
  EXPECT_EQ(InterfaceCount(made.Domain), 2);
  EXPECT_EQ(made.Domain.NumberOfSegments(), 8);
}

TEST(Domain, DropsInterfacesOutside)
{
  const MadeDomain made =
    Make(PolylineBuilder().Box(0, 0, 1, 1).Chain({ { 5, 5 }, { 6, 6 }, { 7, 5 } }));
  ExpectDomain(made, 1.0, 1);
  EXPECT_EQ(FirstIds(made, ProblemCode::OutsideInterfaces), Ids{ 1 });
  EXPECT_EQ(made.Problems.Count(ProblemCode::OutsideInterfaces), 1);
  EXPECT_EQ(made.Domain.NumberOfVertices(), 4);
}

TEST(Domain, LetsASpikeVanishOutsideAndCutInside)
{
  const std::vector<Point2> outward{ { 0, 0 }, { 2, 0 }, { 2, 1 }, { 1, 1 }, { 1, 3 }, { 1, 1 },
    { 0, 1 } };
  const MadeDomain outside = Make(PolylineBuilder().Loop(outward));
  ExpectDomain(outside, 2.0, 1);
  EXPECT_EQ(InterfaceCount(outside.Domain), 0);
  const std::vector<Point2> inward{ { 0, 0 }, { 2, 0 }, { 2, 1 }, { 1, 1 }, { 1, 0.5 }, { 1, 1 },
    { 0, 1 } };
  const MadeDomain inside = Make(PolylineBuilder().Loop(inward));
  ExpectDomain(inside, 2.0, 1);
  EXPECT_EQ(InterfaceCount(inside.Domain), 1);
}

TEST(Domain, KeepsTheTipOfASpikeThinnerThanResolution)
{
  const double ulp = std::nextafter(1.0, 2.0) - 1.0;
  const MadeDomain made = Make(PolylineBuilder().Loop(
    { { 0, 0 }, { 2, 0 }, { 2, 1.5 }, { 1 + ulp, 1.5 }, { 1, 3 }, { 1, 1 }, { 0, 1 } }));
  ExpectDomain(made, 2.5 + 0.75 * ulp);
  EXPECT_EQ(made.Domain.NumberOfVertices(), 7);
  EXPECT_LT(ulp, made.Domain.Resolution);
}

TEST(Domain, ASpikeWithTheTwoEndsOfItsBaseAtOnePlaceVanishesWithAWord)
{
  const double ulp = std::nextafter(1.0, 2.0) - 1.0;
  const MadeDomain made = Make(PolylineBuilder().Loop(
    { { 0, 0 }, { 2, 0 }, { 2, 1 }, { 1 + ulp, 1 }, { 1, 3 }, { 1, 1 }, { 0, 1 } }));
  ExpectDomain(made, 2.0, 2);
  EXPECT_EQ(FirstIds(made, ProblemCode::NearPoints), (Ids{ 3, 5 }));
  EXPECT_EQ(made.Problems.Count(ProblemCode::DuplicateSegments), 1);
}

TEST(Domain, SortsEmbeddedPoints)
{
  const MadeDomain made =
    Make(PolylineBuilder()
           .Box(0, 0, 2, 2)
           .Box(0.5, 0.5, 1, 1)
           .Chain({ { 1, 0 }, { 0, 0 }, { 1.5, 1.5 }, { 7, 7 }, { 0.75, 0.75 }, { 1.5, 1.5 } },
             ChainKind::EmbeddedPoint));
  ExpectDomain(made, 3.75, 2);
  EXPECT_EQ(made.Domain.VertexPoints.back(), 10);
  std::vector<Id> points = made.Domain.VertexPoints;
  std::sort(points.begin(), points.end());
  EXPECT_EQ(points, (std::vector<Id>{ 0, 1, 2, 3, 4, 5, 6, 7, 8, 10 }));
  EXPECT_EQ(std::count(made.Domain.IsEmbedded.begin(), made.Domain.IsEmbedded.end(), 1), 1);
  EXPECT_EQ(made.Domain.IsEmbedded.back(), 1);
  EXPECT_EQ(made.Problems.Count(ProblemCode::OutsidePoints), 2);
  EXPECT_EQ(FirstIds(made, ProblemCode::OutsidePoints), Ids{ 12 }); // the first by place
  EXPECT_EQ(FirstIds(made, ProblemCode::DuplicatePoints), (Ids{ 10, 13 }));
}

TEST(Domain, BendsASegmentToAVertexThatRoundingCannotTell)
{
  const double height = std::nextafter(1.0, 2.0);
  const MadeDomain made =
    Make(PolylineBuilder().Box(0, 0, 3, 1).Loop({ { 1, height }, { 2, 2 }, { 1, 2 } }));
  EXPECT_EQ(made.Violation, "");
  EXPECT_EQ(made.Domain.NumberOfVertices(), 7);
  EXPECT_EQ(made.Domain.NumberOfSegments(), 8);
  EXPECT_EQ(FirstIds(made, ProblemCode::NearPoints), (Ids{ 4, NoId }));
  EXPECT_EQ(made.Problems.Groups().size(), 1u);
  EXPECT_NEAR(made.Domain.Area, 3.5, 1e-15);
}

TEST(Domain, KeepsAGapThatIsWiderThanRounding)
{
  ExpectDomain(Make(PolylineBuilder().Box(0, 0, 1, 1).Box(1 + 1e-12, 0, 2, 1)), 2.0 - 1e-12);
}

TEST(Domain, ResolvesLinesThroughOnePoint)
{
  PolylineBuilder builder;
  builder.Box(-2, -2, 2, 2);
  for (int i = 0; i < 20; ++i)
  {
    const double angle = Pi * (i + 0.3) / 20;
    const Point2 end{ 1.9 * std::cos(angle), 1.9 * std::sin(angle) };
    builder.Chain({ end, { -end.X, -end.Y } });
  }
  const MadeDomain made = Make(builder);
  ExpectDomain(made, 16.0, 1);
  EXPECT_EQ(made.Problems.Count(ProblemCode::Crossings), 190);
  EXPECT_EQ(made.Domain.NumberOfVertices(), 4 + 40 + 1);
}

TEST(Domain, ResolvesCollinearSegmentsOfOneVertex)
{
  PolylineBuilder builder;
  builder.Box(-1, -1, 400, 1);
  for (int i = 1; i < 400; ++i)
  {
    builder.Chain({ { 0, 0 }, { static_cast<double>(i), 0 } });
  }
  const MadeDomain made = Make(builder);
  ExpectDomain(made, 802.0, 1);
  EXPECT_EQ(made.Domain.NumberOfSegments(), 4 + 399);
}

TEST(Domain, ResolvesAFanOfTenThousandSpokes)
{
  PolylineBuilder builder;
  const std::vector<Point2> rim = WigglyCircle(10000);
  builder.Loop(rim);
  for (const Point2& place : rim)
  {
    builder.Chain({ { 0, 0 }, place });
  }
  const MadeDomain made = Make(builder);
  EXPECT_EQ(made.Violation, "");
  EXPECT_TRUE(made.Problems.Groups().empty());
  EXPECT_EQ(made.Domain.NumberOfSegments(), 20000);
}

/// Each overlaps all others.
TEST(Domain, ResolvesACrowdOfNestedSegments)
{
  constexpr int Count = 500;
  PolylineBuilder builder;
  builder.Box(-1, -1, 2 * Count, 1);
  for (int i = 0; i < Count; ++i)
  {
    builder.Chain({ { static_cast<double>(i), 0 }, { 2.0 * Count - 1 - i, 0 } },
      i % 2 == 0 ? ChainKind::Interface : ChainKind::Automatic);
  }
  const MadeDomain made = Make(builder);
  ExpectDomain(made, 2.0 * (2 * Count + 1), 1);
  EXPECT_EQ(made.Domain.NumberOfSegments(), 4 + 2 * Count - 1);
  EXPECT_EQ(made.Problems.Count(ProblemCode::DuplicateSegments), Count * (Count - 1) / 2);
  ExpectRefused(Make(builder, false), ProblemCode::NotResolved);
}

TEST(Domain, RefusesWhereFarTooManySegmentsLieAlongOneLine)
{
  constexpr int Count = 3000;
  PolylineBuilder builder;
  builder.Box(-1, -1, 2 * Count, 1);
  for (int i = 0; i < Count; ++i)
  {
    builder.Chain({ { static_cast<double>(i), 0 }, { 2.0 * Count - 1 - i, 0 } });
  }
  ExpectRefused(Make(builder), ProblemCode::NotResolved);
}

TEST(Domain, CountsTheParityOfACrowdOfSegmentsOnOneSlantedLine)
{
  constexpr int Count = 600;
  PolylineBuilder builder;
  double area = 0.0;
  for (int i = 1; i <= Count; ++i)
  {
    builder.Loop({ { 0, 0 }, { 2.0 * i, 1.0 * i }, { 2.0 * i, 1.0 * i + 1 }, { 0, 1 } });
    area += i % 2 == 0 ? 2.0 : 0.0;
  }
  const MadeDomain made = Make(builder);
  EXPECT_EQ(made.Violation, "");
  EXPECT_DOUBLE_EQ(made.Domain.Area, area);
}

TEST(Domain, RefusesMoreCrossingsThanAllowed)
{
  const Polylines input = Medley(10);
  DomainOptions options;
  options.MaximumNumberOfCrossings = 20;
  ProblemList problems;
  SilentMonitor monitor;
  EXPECT_EQ(MakeDomain(input, options, problems, monitor).NumberOfSegments(), 0);
  ASSERT_EQ(problems.Count(ProblemCode::NotResolved), 1);
  EXPECT_EQ(problems.Groups().back().First.front().Ids.size(), 2u);
}

} // namespace

} // namespace biting
