// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Support/PolylineShapes.h"

#include <gtest/gtest.h>

#include <algorithm> // for count, reverse, rotate, sort
#include <cmath>     // for cos, sin
#include <limits>    // for NaN, infinity
#include <set>       // for distinct places

namespace biting
{

namespace
{

constexpr double Pi = 3.14159265358979323846;

/// A valid domain of that area, and nothing said but `repairs` kinds.
void ExpectDomain(const MadeDomain& made, double area, std::size_t repairs = 0)
{
  EXPECT_EQ(made.Violation, "");
  EXPECT_FALSE(made.Problems.HasErrors());
  EXPECT_EQ(made.Problems.Groups().size(), repairs);
  EXPECT_DOUBLE_EQ(made.Domain.Area, area);
}

void ExpectRefused(const MadeDomain& made, ProblemCode code)
{
  EXPECT_TRUE(made.Problems.Has(code));
  EXPECT_EQ(made.Domain.NumberOfVertices(), 0);
  EXPECT_EQ(made.Domain.NumberOfSegments(), 0);
  EXPECT_EQ(made.Domain.Area, 0.0);
}

std::vector<std::int64_t> FirstIds(const MadeDomain& made, ProblemCode code)
{
  for (const ProblemGroup& group : made.Problems.Groups())
  {
    if (group.Code == code)
    {
      return group.First.front().Ids;
    }
  }
  return {};
}

using Ids = std::vector<std::int64_t>;

Id InterfaceCount(const Domain& domain)
{
  return static_cast<Id>(std::count(domain.IsBoundary.begin(), domain.IsBoundary.end(), 0));
}

std::vector<Point2> WigglyCircle(int count)
{
  std::vector<Point2> places;
  for (int i = 0; i < count; ++i)
  {
    const double angle = 2 * Pi * i / count;
    const double radius = 1.0 + 0.05 * std::cos(50 * angle);
    places.push_back({ radius * std::cos(angle), radius * std::sin(angle) });
  }
  return places;
}

/// Equal but for the numbers of vertices and segments and the direction of segments.
std::set<std::pair<Point2, Point2>> Drawing(const Domain& domain, bool boundary)
{
  std::set<std::pair<Point2, Point2>> drawing;
  for (std::size_t s = 0; s < domain.Starts.size(); ++s)
  {
    const Point2& a = domain.Vertices[static_cast<std::size_t>(domain.Starts[s])];
    const Point2& b = domain.Vertices[static_cast<std::size_t>(domain.Ends[s])];
    if ((domain.IsBoundary[s] != 0) == boundary)
    {
      drawing.emplace(std::min(a, b), std::max(a, b));
    }
  }
  return drawing;
}

/// Equal to the last bit, but for ids of the input.
void ExpectSame(const Domain& a, const Domain& b)
{
  EXPECT_EQ(a.Vertices, b.Vertices);
  EXPECT_EQ(a.IsEmbedded, b.IsEmbedded);
  EXPECT_EQ(a.Starts, b.Starts);
  EXPECT_EQ(a.Ends, b.Ends);
  EXPECT_EQ(a.IsBoundary, b.IsBoundary);
  EXPECT_EQ(a.LeftInside, b.LeftInside);
  EXPECT_EQ(a.RightInside, b.RightInside);
  EXPECT_EQ(a.Area, b.Area);
}

/// Says stop at one call, and counts them.
class Stopper : public SilentMonitor
{
public:
  explicit Stopper(int stopAtCall = -1)
    : StopAtCall(stopAtCall)
  {
  }
  bool Advance(double) override { return this->Calls++ != this->StopAtCall; }

  int StopAtCall;
  int Calls = 0;
};

/// Much of everything: holes, crossing interfaces and open chains, points.
Polylines Medley(int size)
{
  PolylineBuilder builder;
  builder.Box(-1, -1, size + 1, size + 1, ChainKind::Boundary);
  for (int i = 0; i < size; ++i)
  {
    builder.Box(i + 0.25, 0.25, i + 0.5, 0.5, ChainKind::Boundary);
    builder.Chain({ { 0.0, i + 0.625 }, { size - 0.5, i + 0.75 } }, ChainKind::Interface);
    builder.Chain({ { i + 0.75, 0.0 }, { i + 0.625, size - 0.5 } });
    builder.Chain({ { i + 0.875, 0.875 }, { i + 0.25, 0.375 } }, ChainKind::EmbeddedPoint);
  }
  return builder.Lines();
}

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
  EXPECT_EQ(refusal.Place, (Point2{ 2, 3 }));
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
  EXPECT_EQ(refusal.Place, (Point2{ 5, 6 }));
  EXPECT_EQ(refusal.Detail, "all segments have length 0, the first of them");
}

TEST(Domain, NamesTheFirstInterfaceOrPointByPlaceWhereThereIsNothingElse)
{
  const auto refusalOf = [](const PolylineBuilder& builder)
  { return Make(builder).Problems.Groups().back().First.front(); };
  const Problem interfaces = refusalOf(
    PolylineBuilder().Box(2, 3, 4, 5, ChainKind::Interface).Box(6, 7, 8, 9, ChainKind::Interface));
  ASSERT_EQ(interfaces.Code, ProblemCode::NoClosedLoop);
  EXPECT_EQ(interfaces.Place, (Point2{ 2, 3 }));
  EXPECT_EQ(interfaces.Detail, "there are interfaces only, the first of cell 0");
  const Problem points = refusalOf(PolylineBuilder()
                                     .Chain({ { 4, 5 } }, ChainKind::EmbeddedPoint)
                                     .Chain({ { 2, 3 } }, ChainKind::EmbeddedPoint));
  ASSERT_EQ(points.Code, ProblemCode::NoClosedLoop);
  EXPECT_EQ(points.Place, (Point2{ 2, 3 }));
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

/// Each overlaps all others: split in pairs there were 4 n^2 parts.
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
  EXPECT_EQ(made.Problems.Count(ProblemCode::DuplicateSegments), 2 * Count - 3);
  ExpectRefused(Make(builder, false), ProblemCode::NotResolved);
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

TEST(Domain, StopsAtEachCall)
{
  const Polylines input = Medley(25);
  Stopper counter;
  ProblemList nothing;
  EXPECT_GT(MakeDomain(input, DomainOptions(), nothing, counter).NumberOfSegments(), 0);
  EXPECT_FALSE(nothing.HasErrors());
  for (int call = 0; call < counter.Calls; ++call)
  {
    Stopper stopper(call);
    ProblemList problems;
    const Domain domain = MakeDomain(input, DomainOptions(), problems, stopper);
    EXPECT_EQ(problems.Count(ProblemCode::Aborted), 1) << "call " << call;
    EXPECT_EQ(domain.NumberOfVertices(), 0);
    EXPECT_EQ(stopper.Calls, call + 1) << "asked again after call " << call;
  }
}

TEST(Domain, AsksTheMoreOftenTheMoreThereIsToDo)
{
  const auto callsOf = [](const Polylines& input)
  {
    Stopper counter;
    ProblemList problems;
    MakeDomain(input, DomainOptions(), problems, counter);
    return counter.Calls;
  };
  EXPECT_GT(callsOf(Medley(80)), 5 * callsOf(Medley(20)));
  const Polylines small = PolylineBuilder().Loop(WigglyCircle(1000)).Lines();
  const Polylines large = PolylineBuilder().Loop(WigglyCircle(32000)).Lines();
  EXPECT_GT(callsOf(large), 10 * callsOf(small));
}

TEST(Domain, ProgressOnlyGrows)
{
  class Watcher : public SilentMonitor
  {
  public:
    bool Advance(double fraction) override
    {
      this->IsGrowing = this->IsGrowing && fraction >= this->Last && fraction <= 1.0;
      this->Last = fraction;
      this->Calls += 1;
      return true;
    }
    bool IsGrowing = true;
    double Last = 0.0;
    int Calls = 0;
  };
  Watcher watcher;
  ProblemList problems;
  const Polylines input = PolylineBuilder().Loop(WigglyCircle(20000)).Box(0, 0, 2, 2).Lines();
  MakeDomain(input, DomainOptions(), problems, watcher);
  EXPECT_TRUE(watcher.IsGrowing);
  EXPECT_GE(watcher.Calls, 40);
  EXPECT_GE(watcher.Last, 0.9);
}

TEST(Domain, AreaIsExactFarFromTheOrigin)
{
  const auto move = [](const Point2& p) { return Point2{ p.X + 1e8, p.Y - 1e8 }; };
  const double side = std::ldexp(1.0, -20);
  const Polylines input = PolylineBuilder().Box(0, 0, side, side).Lines();
  ExpectDomain(Make(Move(input, move)), side * side);
}

Polylines CrossingShapes()
{
  return PolylineBuilder()
    .Loop({ { 0, 0 }, { 7, 1 }, { 6, 6 }, { 1, 5 } })
    .Loop({ { 3, -1 }, { 5, 7 }, { 2, 7 }, { 4, 3 } })
    .Loop({ { 2, 2 }, { 6, 6 }, { 3, 4 } })
    .Chain({ { 0, 3 }, { 4, 3 }, { 8, 4 } })
    .Lines();
}

TEST(Domain, ReversedChainsDrawTheSame)
{
  const MadeDomain made = Make(CrossingShapes());
  const MadeDomain reversed = Make(Reverse(CrossingShapes()));
  EXPECT_EQ(made.Violation, "");
  ExpectSame(reversed.Domain, made.Domain);
}

TEST(Domain, OrderOfChainsDoesNotMatter)
{
  const Polylines input = Unmerge(CrossingShapes());
  Polylines permuted = input;
  std::reverse(permuted.Connectivity.begin(), permuted.Connectivity.end());
  std::reverse(permuted.Kinds.begin(), permuted.Kinds.end());
  std::reverse(permuted.Cells.begin(), permuted.Cells.end());
  const MadeDomain made = Make(input);
  const MadeDomain other = Make(permuted);
  EXPECT_EQ(made.Violation, "");
  ExpectSame(other.Domain, made.Domain);
}

TEST(Domain, FirstPointsOfLoopsDoNotMatter)
{
  const auto shape = [](int shift)
  {
    std::vector<Point2> places = WigglyCircle(200);
    std::rotate(places.begin(), places.begin() + shift, places.end());
    return PolylineBuilder().Loop(places).Box(-0.3, -0.2, 0.1, 0.4).Lines();
  };
  ExpectSame(Make(shape(71)).Domain, Make(shape(0)).Domain);
}

// Chains whose kind is given: closed ones of automatic kind are more than their segments.
Polylines CutIntoSegments(const Polylines& chains)
{
  Polylines segments = chains;
  segments.Offsets = { 0 };
  segments.Connectivity.clear();
  segments.Kinds.clear();
  segments.Cells.clear();
  for (std::size_t c = 0; c < chains.Kinds.size(); ++c)
  {
    const bool arePoints = chains.Kinds[c] == ChainKind::EmbeddedPoint;
    for (Id k = chains.Offsets[c]; k + (arePoints ? 0 : 1) < chains.Offsets[c + 1]; ++k)
    {
      const auto place = chains.Connectivity.begin() + k;
      segments.Connectivity.insert(segments.Connectivity.end(), place, place + (arePoints ? 1 : 2));
      segments.Offsets.push_back(static_cast<Id>(segments.Connectivity.size()));
      segments.Kinds.push_back(chains.Kinds[c]);
      segments.Cells.push_back(static_cast<Id>(segments.Cells.size()));
    }
  }
  return segments;
}

TEST(Domain, ChainsDrawWhatTheirSegmentsDraw)
{
  Polylines chains = Medley(5);
  std::replace(
    chains.Kinds.begin(), chains.Kinds.end(), ChainKind::Automatic, ChainKind::Interface);
  ExpectSame(Make(CutIntoSegments(chains)).Domain, Make(chains).Domain);
}

TEST(Domain, BoundaryHasTheInsideOnItsLeft)
{
  const Domain domain = Make(Reverse(Medley(5))).Domain;
  for (std::size_t s = 0; s < domain.Starts.size(); ++s)
  {
    EXPECT_EQ(domain.LeftInside[s], 1);
    EXPECT_EQ(domain.RightInside[s], domain.IsBoundary[s] ? 0 : 1);
  }
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

TEST(Domain, ScaledByAPowerOfTwoScalesToTheLastBit)
{
  const double factor = std::ldexp(1.0, 37);
  const auto scale = [factor](const Point2& p) { return factor * p; };
  const MadeDomain made = Make(CrossingShapes());
  const MadeDomain scaled = Make(Move(CrossingShapes(), scale));
  EXPECT_EQ(scaled.Domain.Area, factor * factor * made.Domain.Area);
  ASSERT_EQ(scaled.Domain.NumberOfVertices(), made.Domain.NumberOfVertices());
  for (std::size_t v = 0; v < made.Domain.Vertices.size(); ++v)
  {
    EXPECT_EQ(scaled.Domain.Vertices[v], factor * made.Domain.Vertices[v]);
  }
  EXPECT_EQ(scaled.Domain.LeftInside, made.Domain.LeftInside);
}

Domain Moved(Domain domain, Point2 (*move)(const Point2&))
{
  for (Point2& vertex : domain.Vertices)
  {
    vertex = move(vertex);
  }
  return domain;
}

TEST(Domain, TurnedByNinetyDegreesOrMirroredKeepsItsGraph)
{
  const auto mirror = [](const Point2& p) { return Point2{ -p.X, p.Y }; };
  for (Point2 (*move)(const Point2&) : { +mirror, &Perpendicular })
  {
    const Domain moved = Moved(Make(CrossingShapes()).Domain, move);
    const MadeDomain made = Make(Move(CrossingShapes(), move));
    EXPECT_EQ(made.Violation, "");
    EXPECT_EQ(Drawing(made.Domain, true), Drawing(moved, true));
    EXPECT_EQ(Drawing(made.Domain, false), Drawing(moved, false));
    EXPECT_NEAR(made.Domain.Area, moved.Area, 1e-13);
  }
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
