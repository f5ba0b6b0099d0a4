// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "DomainLaws.h"

#include <cmath>   // for ldexp
#include <limits>  // for NaN, infinity
#include <utility> // for swap

namespace biting
{

namespace
{

TEST(Domain, OfNothingIsEmptyWithoutAWord)
{
  const MadeDomain made = Make(Polylines());
  EXPECT_TRUE(made.Problems.Groups().empty());
  EXPECT_EQ(made.Domain.NumberOfVertices(), 0);
  EXPECT_EQ(made.Violation, "");
}

TEST(Domain, KeepsTheSquareAsItComes)
{
  const MadeDomain made = Make(PolylineBuilder().Box(0, 0, 2, 3));
  ExpectDomain(made, 6.0);
  EXPECT_EQ(made.Domain.VertexPoints, (std::vector<Id>{ 0, 1, 2, 3 }));
  EXPECT_EQ(made.Domain.Starts, (std::vector<Id>{ 0, 1, 2, 3 }));
  EXPECT_EQ(made.Domain.Ends, (std::vector<Id>{ 1, 2, 3, 0 }));
  EXPECT_EQ(made.Domain.LeftInside, (std::vector<std::uint8_t>{ 1, 1, 1, 1 }));
  EXPECT_EQ(made.Domain.RightInside, (std::vector<std::uint8_t>{ 0, 0, 0, 0 }));
}

TEST(Domain, IgnoresPointsThatNoChainUses)
{
  Polylines input = PolylineBuilder().Box(0, 0, 1, 1).Lines();
  input.Points.push_back({ std::numeric_limits<double>::quiet_NaN(), 0.0 });
  ExpectDomain(Make(input), 1.0);
}

TEST(Domain, CountsInsideByEvenOddToAnyDepth)
{
  PolylineBuilder builder;
  double area = 0.0;
  for (int depth = 0; depth < 6; ++depth)
  {
    const double low = depth;
    const double high = 20.0 - depth;
    const bool isForward = depth % 3 == 0;
    builder.Loop({ { low, low }, isForward ? Point2{ high, low } : Point2{ low, high },
      { high, high }, isForward ? Point2{ low, high } : Point2{ high, low } });
    area += (depth % 2 == 0 ? 1.0 : -1.0) * (high - low) * (high - low);
  }
  ExpectDomain(Make(builder), area);
}

TEST(Domain, MergesLoopsThatTouchAtAVertexSilently)
{
  ExpectDomain(Make(PolylineBuilder().Box(0, 0, 1, 1).Box(1, 1, 2, 2)), 2.0);
}

TEST(Domain, ReportsPointsThatAreNotFinite)
{
  const double bad = std::numeric_limits<double>::quiet_NaN();
  const double far = std::numeric_limits<double>::infinity();
  const MadeDomain made =
    Make(PolylineBuilder().Loop({ { 0, 0 }, { 1, bad }, { 1, 1 }, { -far, 1 } }));
  ExpectRefused(made, ProblemCode::NotFinite);
  EXPECT_EQ(made.Problems.Count(ProblemCode::NotFinite), 2);
  EXPECT_EQ(FirstIds(made, ProblemCode::NotFinite), Ids{ 1 });
}

TEST(Domain, RefusesCoordinatesOutOfRange)
{
  const MadeDomain large = Make(PolylineBuilder().Box(0, 0, 1e300, 1));
  ExpectRefused(large, ProblemCode::OutOfRange);
  EXPECT_EQ(FirstIds(large, ProblemCode::OutOfRange), Ids{ 1 });
  ExpectRefused(Make(PolylineBuilder().Box(0, 0, 1e-80, 1e-80)), ProblemCode::OutOfRange);
}

TEST(Domain, TakesTheExtremesOfTheRange)
{
  ExpectDomain(Make(PolylineBuilder().Box(-1e70, -1e70, 1e70, 1e70)), 4e140);
  ExpectDomain(Make(PolylineBuilder().Box(0, 0, 1e-69, 1e-69)), 1e-69 * 1e-69);
}

TEST(Domain, CountsTinyCoordinatesAsZero)
{
  const MadeDomain made =
    Make(PolylineBuilder().Loop({ { 1e-200, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 }, { 0, -1e-300 } }));
  ExpectDomain(made, 1.0, 1);
  EXPECT_EQ(made.Domain.NumberOfVertices(), 4);
}

TEST(Domain, RefusesWhatHasNoClosedLoop)
{
  ExpectRefused(Make(PolylineBuilder().Chain({ { 0, 0 }, { 1, 0 } })), ProblemCode::NoClosedLoop);
  ExpectRefused(Make(PolylineBuilder().Loop({ { 0, 0 }, { 1, 0 } })), ProblemCode::NoClosedLoop);
  ExpectRefused(Make(PolylineBuilder().Chain({ { 0, 0 } }, ChainKind::EmbeddedPoint)),
    ProblemCode::NoClosedLoop);
  ExpectRefused(
    Make(PolylineBuilder().Box(0, 0, 1, 1, ChainKind::Interface)), ProblemCode::NoClosedLoop);
  const MadeDomain twice = Make(PolylineBuilder().Box(0, 0, 1, 1).Box(0, 0, 1, 1));
  ExpectRefused(twice, ProblemCode::NoClosedLoop);
  EXPECT_EQ(twice.Problems.Count(ProblemCode::DuplicateSegments), 4);
}

TEST(Domain, SaysThatLoopsDrawnTwiceBoundNothing)
{
  const MadeDomain twice = Make(PolylineBuilder().Box(2, 3, 4, 5).Box(2, 3, 4, 5));
  const Problem& refusal = twice.Problems.Groups().back().First.front();
  ASSERT_EQ(refusal.Code, ProblemCode::NoClosedLoop);
  EXPECT_TRUE(refusal.Ids.empty());
  EXPECT_EQ(refusal.Place, (Point3{ 2, 3, 0 }));
  EXPECT_EQ(refusal.Detail.substr(0, 20), "4 boundary segments ");
}

TEST(Domain, SaysThatALoopWithoutAreaIsDrawnThereAndBack)
{
  const MadeDomain flat = Make(PolylineBuilder().Loop({ { 0, 1 }, { 1, 1 }, { 2, 1 } }));
  const Problem& refusal = flat.Problems.Groups().back().First.front();
  ASSERT_EQ(refusal.Code, ProblemCode::NoClosedLoop);
  EXPECT_TRUE(refusal.Ids.empty());
  EXPECT_EQ(refusal.Detail.substr(0, 20), "2 boundary segments ");
}

TEST(Domain, SaysThatAllSegmentsHaveLengthZero)
{
  const MadeDomain point = Make(PolylineBuilder().Loop({ { 5, 6 }, { 5, 6 }, { 5, 6 } }));
  const Problem& refusal = point.Problems.Groups().back().First.front();
  ASSERT_EQ(refusal.Code, ProblemCode::NoClosedLoop);
  EXPECT_EQ(refusal.Place, (Point3{ 5, 6, 0 }));
  EXPECT_EQ(refusal.Detail, "all segments have length 0, the first of them");
}

TEST(Domain, NamesTheFirstInterfaceOrPointByPlaceWhereThereIsNothingElse)
{
  const auto refusalOf = [](const PolylineBuilder& builder)
  { return Make(builder).Problems.Groups().back().First.front(); };
  const Problem interfaces = refusalOf(
    PolylineBuilder().Box(2, 3, 4, 5, ChainKind::Interface).Box(6, 7, 8, 9, ChainKind::Interface));
  ASSERT_EQ(interfaces.Code, ProblemCode::NoClosedLoop);
  EXPECT_EQ(interfaces.Place, (Point3{ 2, 3, 0 }));
  EXPECT_EQ(interfaces.Detail, "there are interfaces only, the first of cell 0");
  const Problem points = refusalOf(PolylineBuilder()
                                     .Chain({ { 4, 5 } }, ChainKind::EmbeddedPoint)
                                     .Chain({ { 2, 3 } }, ChainKind::EmbeddedPoint));
  ASSERT_EQ(points.Code, ProblemCode::NoClosedLoop);
  EXPECT_EQ(points.Place, (Point3{ 2, 3, 0 }));
  EXPECT_EQ(points.Detail, "there are embedded points only, the first of them point 1");
}

TEST(Domain, NamesTheOpenEndsWhereNothingIsClosed)
{
  // Two chains that meet in one end, by coordinates: what is open are the others.
  const MadeDomain made =
    Make(PolylineBuilder().Chain({ { 0, 0 }, { 1, 0 }, { 1, 1 } }).Chain({ { 1, 1 }, { 0, 1 } }));
  EXPECT_EQ(made.Problems.Count(ProblemCode::NoClosedLoop), 2);
  EXPECT_EQ(FirstIds(made, ProblemCode::NoClosedLoop), Ids{ 0 });
  const MadeDomain closed = Make(PolylineBuilder().Box(0, 0, 1, 1, ChainKind::Interface));
  EXPECT_EQ(closed.Problems.Count(ProblemCode::NoClosedLoop), 1);
  EXPECT_EQ(FirstIds(closed, ProblemCode::NoClosedLoop), Ids());
}

TEST(Domain, OfAPlanarSubdivisionIsItsOutline)
{
  const PolylineBuilder cells = PolylineBuilder().Box(0, 0, 1, 1).Box(1, 0, 2, 1).Box(0, 1, 2, 2);
  PolylineBuilder grid;
  for (int i = 0; i <= 3; ++i)
  {
    const double at = i;
    for (int k = 0; k < 3; ++k)
    {
      grid.Chain({ { at, k * 1.0 }, { at, k + 1.0 } }).Chain({ { k * 1.0, at }, { k + 1.0, at } });
    }
  }
  const MadeDomain made = Make(grid);
  ExpectDomain(made, 9.0);
  EXPECT_EQ(InterfaceCount(made.Domain), 12);
  EXPECT_DOUBLE_EQ(Make(cells).Domain.Area, 4.0);
}

TEST(Domain, OfAThetaGraphIsItsOutline)
{
  const MadeDomain made = Make(PolylineBuilder()
                                 .Chain({ { 0, 0 }, { 1, 1 }, { 2, 0 } })
                                 .Chain({ { 0, 0 }, { 1, -1 }, { 2, 0 } })
                                 .Chain({ { 0, 0 }, { 2, 0 } }));
  ExpectDomain(made, 2.0);
  EXPECT_EQ(InterfaceCount(made.Domain), 1);
}

TEST(Domain, TakesOpenChainsThatCloseTogetherAsLoops)
{
  const MadeDomain made = Make(PolylineBuilder()
                                 .Chain({ { 0, 0 }, { 4, 0 }, { 4, 4 } })
                                 .Chain({ { 0, 0 }, { 0, 4 }, { 4, 4 } })
                                 .Chain({ { 4, 4 }, { 2, 2 }, { 1, 2 } }));
  ExpectDomain(made, 16.0);
  EXPECT_EQ(InterfaceCount(made.Domain), 2);
}

TEST(Domain, TakesABridgeBetweenLoopsAsInterface)
{
  const Polylines loops = Unmerge(
    PolylineBuilder().Box(0, 0, 8, 8).Box(2, 2, 4, 4).Chain({ { 0, 3 }, { 2, 3 } }).Lines());
  const MadeDomain made = Make(loops);
  ExpectDomain(made, 60.0);
  EXPECT_EQ(InterfaceCount(made.Domain), 1);
}

TEST(Domain, TakesInterfacesThatCrossWithinTheDomainAsInterfaces)
{
  PolylineBuilder lines;
  lines.Chain({ { 1, 2 }, { 7, 2 } }).Chain({ { 1, 5 }, { 7, 5 } });
  lines.Chain({ { 2, 1 }, { 2, 7 } }).Chain({ { 5, 1 }, { 5, 7 } });
  PolylineBuilder inClosed = lines;
  inClosed.Box(0, 0, 8, 8);
  ExpectDomain(Make(inClosed), 64.0, 1);
  ExpectDomain(Make(Unmerge(inClosed.Lines())), 64.0, 1);
  ExpectDomain(Make(lines), 9.0, 2);
}

TEST(Domain, TakesBordersOfStatesWithinACoastAsInterfaces)
{
  const MadeDomain made = Make(PolylineBuilder()
                                 .Box(0, 0, 8, 8)
                                 .Chain({ { 0, 4 }, { 2, 4 } })
                                 .Chain({ { 2, 4 }, { 4, 6 }, { 6, 4 } })
                                 .Chain({ { 2, 4 }, { 4, 2 }, { 6, 4 } })
                                 .Chain({ { 2, 4 }, { 6, 4 } })
                                 .Chain({ { 6, 4 }, { 8, 4 } }));
  ExpectDomain(made, 64.0);
  EXPECT_EQ(InterfaceCount(made.Domain), 7);
}

TEST(Domain, KeepsAHoleFromWhichACrackStarts)
{
  const PolylineBuilder builder =
    PolylineBuilder().Box(0, 0, 8, 8).Box(2, 2, 4, 4).Chain({ { 4, 3 }, { 6, 3 } });
  ExpectDomain(Make(builder), 60.0);
  ExpectDomain(Make(Unmerge(builder.Lines())), 60.0);
}

TEST(Domain, DemotesBoundaryChainsThatDoNotClose)
{
  const MadeDomain made = Make(PolylineBuilder()
                                 .Box(0, 0, 4, 4, ChainKind::Boundary)
                                 .Chain({ { 1, 1 }, { 2, 2 } }, ChainKind::Boundary));
  ExpectDomain(made, 16.0);
  EXPECT_EQ(InterfaceCount(made.Domain), 1);
}

TEST(Domain, TakesACombOfTwoThousandTeeth)
{
  std::vector<Point2> places{ { 4000, 2 }, { 0, 2 } };
  for (int tooth = 0; tooth < 2000; ++tooth)
  {
    const double x = 2.0 * tooth;
    places.insert(places.end(), { { x, 0 }, { x + 1, 0 }, { x + 1, 1 }, { x + 2, 1 } });
  }
  ExpectDomain(Make(PolylineBuilder().Loop(places), false), 6000.0);
}

TEST(Domain, CheckFindsWhatIsWrong)
{
  const Domain good = Make(PolylineBuilder().Box(0, 0, 2, 2).Box(3, 0, 4, 1)).Domain;
  Domain moved = good;
  moved.Vertices[4] = { 1.5, 1 };
  moved.Bounds.Add({ 1.5, 1 });
  EXPECT_NE(CheckDomain(moved), "");
  Domain same = good;
  same.Vertices[4] = same.Vertices[0];
  EXPECT_NE(CheckDomain(same), "");
  Domain flipped = good;
  std::swap(flipped.LeftInside[0], flipped.RightInside[0]);
  EXPECT_NE(CheckDomain(flipped), "");
  Domain demoted = good;
  demoted.IsBoundary[2] = 0;
  EXPECT_NE(CheckDomain(demoted), "");
  EXPECT_EQ(CheckDomain(good), "");
}

} // namespace

} // namespace biting
