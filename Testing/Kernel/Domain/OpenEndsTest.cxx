// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Support/PolylineShapes.h"

#include <gtest/gtest.h>

#include <algorithm> // for count, sort
#include <cmath>     // for cos, sin

namespace biting
{

namespace
{

using Places = std::vector<Point2>;

const Places Square{ { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } };

/// With a spacing of .1, so that ends reach .001.
MadeDomain MakeJoined(const Polylines& input, double tolerance = 0.01, bool repair = true)
{
  MadeDomain made;
  SilentMonitor monitor;
  DomainOptions options;
  options.Repair = repair;
  options.EndTolerance = tolerance;
  options.GivenSpacing = [](const Point2&) { return 0.1; };
  made.Domain = MakeDomain(input, options, made.Problems, monitor);
  made.Violation = CheckDomain(made.Domain);
  return made;
}

const Problem& FirstOf(ProblemCode code, const MadeDomain& made)
{
  static const Problem none;
  for (const ProblemGroup& group : made.Problems.Groups())
  {
    if (group.Code == code)
    {
      return group.First.front();
    }
  }
  return none;
}

/// Whether the domain has a vertex there.
bool HasVertex(const Domain& domain, const Point2& place)
{
  return std::count(domain.Vertices.begin(), domain.Vertices.end(), place) == 1;
}

Places SortedVertices(const MadeDomain& made)
{
  Places places = made.Domain.Vertices;
  std::sort(places.begin(), places.end());
  return places;
}

/// A divider of the square that ends `gap` before both sides.
PolylineBuilder Divided(double gap)
{
  return PolylineBuilder().Loop(Square).Chain({ { gap, 0.3 }, { 0.5, 0.5 }, { 1 - gap, 0.6 } });
}

/// A square plate whose outline begins and ends at the origin, but for a gap, with a hole.
PolylineBuilder NearlyClosed(double gap)
{
  Places outline = Square;
  outline.push_back({ 0, gap });
  return PolylineBuilder().Box(0.4, 0.4, 0.6, 0.6).Chain(outline);
}

/// Sides and quarters of circles, each of which begins `gap` late.
PolylineBuilder Rounded(double gap)
{
  constexpr double RightAngle = 1.57079632679489661923;
  const Places corners{ { 0.8, 0.2 }, { 0.8, 0.8 }, { 0.2, 0.8 }, { 0.2, 0.2 } };
  PolylineBuilder builder;
  builder.Box(0.4, 0.4, 0.6, 0.6);
  for (int k = 0; k < 4; ++k)
  {
    Places arc;
    for (int i = 0; i <= 8; ++i)
    {
      const double angle = RightAngle * (k - 1 + i / 8.0);
      const Point2 place{ 0.2 * std::cos(angle), 0.2 * std::sin(angle) };
      arc.push_back(corners[static_cast<std::size_t>(k)] + place);
    }
    const Point2 start = arc.back();
    const Point2 along = Perpendicular(start - corners[static_cast<std::size_t>(k)]);
    arc.front() = arc.front() + gap * (arc[1] - arc[0]);
    builder.Chain(arc).Chain({ start + gap * along, start + 3.0 * along });
  }
  return builder;
}

TEST(OpenEnds, MoveOntoTheSideThatStays)
{
  for (const double gap : { 1e-12, 1e-9, 1e-6, 9e-4, -1e-12, -1e-9, -9e-4 })
  {
    SCOPED_TRACE(gap);
    const MadeDomain made = MakeJoined(Divided(gap).Lines());
    EXPECT_EQ(made.Violation, "");
    EXPECT_EQ(made.Domain.Area, 1.0);
    EXPECT_EQ(made.Domain.NumberOfVertices(), 7);
    EXPECT_TRUE(HasVertex(made.Domain, { 0, 0.3 }));
    EXPECT_EQ(made.Problems.Groups().size(), 1u);
    EXPECT_EQ(made.Problems.Count(ProblemCode::JoinedEnds), 2);
  }
}

TEST(OpenEnds, BeyondTheToleranceStay)
{
  const MadeDomain made = MakeJoined(Divided(1.1e-3).Lines());
  EXPECT_TRUE(made.Problems.Groups().empty());
  EXPECT_TRUE(HasVertex(made.Domain, { 1.1e-3, 0.3 }));
  EXPECT_EQ(MakeJoined(Divided(1e-9).Lines(), 0.0).Problems.Groups().size(), 0u);
  EXPECT_EQ(MakeJoined(Divided(0.05).Lines(), 0.6).Problems.Count(ProblemCode::JoinedEnds), 2);
}

TEST(OpenEnds, ThatTouchStayAndGoWithoutAWord)
{
  const MadeDomain exact = MakeJoined(Divided(0.0).Lines());
  EXPECT_TRUE(exact.Problems.Groups().empty());
  const double cosine = std::cos(0.6);
  const double sine = std::sin(0.6);
  const auto turn = [cosine, sine](const Point2& p) {
    return Point2{ cosine * p.X - sine * p.Y, sine * p.X + cosine * p.Y };
  };
  const MadeDomain turned = MakeJoined(Move(Divided(0.0).Lines(), turn));
  EXPECT_EQ(turned.Violation, "");
  EXPECT_TRUE(turned.Problems.Groups().empty());
  EXPECT_EQ(turned.Domain.NumberOfVertices(), 7);
}

TEST(OpenEnds, MoveWhereMergeToleranceJoinsThem)
{
  for (const Polylines& input :
    { Divided(1e-2).Lines(),
      PolylineBuilder().Loop(Square).Chain({ { -1e-3, 0 }, { 0.5, 0.5 }, { 1, 1.001 } }).Lines() })
  {
    MadeDomain made;
    SilentMonitor monitor;
    DomainOptions options;
    options.MergeTolerance = 0.01;
    made.Domain = MakeDomain(input, options, made.Problems, monitor);
    EXPECT_EQ(made.Domain.Area, 1.0);
    EXPECT_EQ(
      made.Problems.Count(ProblemCode::JoinedEnds) + made.Problems.Count(ProblemCode::NearPoints),
      2);
  }
}

TEST(OpenEnds, OfTwoSidesOfAWallMeetOnIt)
{
  const MadeDomain made = MakeJoined(PolylineBuilder()
                                       .Loop(Square)
                                       .Chain({ { 0.5, 0 }, { 0.5, 1 } })
                                       .Chain({ { 0.1, 0.3 }, { 0.4992, 0.3004 } })
                                       .Chain({ { 0.5008, 0.2997 }, { 0.9, 0.4 } })
                                       .Lines());
  EXPECT_EQ(made.Violation, "");
  EXPECT_EQ(made.Domain.Area, 1.0);
  EXPECT_EQ(made.Domain.NumberOfVertices(), 9);
  EXPECT_EQ(made.Problems.Count(ProblemCode::JoinedEnds), 2);
}

TEST(OpenEnds, GoToTheCornerBesideWhichTheyEnd)
{
  const MadeDomain made = MakeJoined(PolylineBuilder()
                                       .Loop(Square)
                                       .Chain({ { 1e-9, 9e-4 }, { 0.4, 0.5 }, { 1, 1 - 1e-5 } })
                                       .Lines());
  EXPECT_EQ(made.Domain.NumberOfVertices(), 6); // the second end lies on a side
  EXPECT_TRUE(HasVertex(made.Domain, { 1, 1 - 1e-5 }));
  EXPECT_EQ(made.Problems.Count(ProblemCode::JoinedEnds), 1);
}

TEST(OpenEnds, MeetAtOnePlaceBesideASegment)
{
  const MadeDomain made = MakeJoined(PolylineBuilder()
                                       .Loop(Square)
                                       .Chain({ { 0.2, 0.2 }, { 0.5, 0.5 } })
                                       .Chain({ { 0.5004, 0.5 }, { 0.8, 0.3 } })
                                       .Chain({ { 0.5, 0.5003 }, { 0.4, 0.8 } })
                                       .Lines());
  EXPECT_EQ(made.Domain.NumberOfVertices(), 8);
  EXPECT_EQ(made.Problems.Count(ProblemCode::JoinedEnds), 2);
}

TEST(OpenEnds, AreNotJoinedWithTheirOwnChain)
{
  Places spiral;
  for (int i = 0; i <= 100; ++i)
  {
    spiral.push_back({ 0.5 + 1e-5 * i, 0.5 + 2e-6 * (i % 2) });
  }
  const MadeDomain made = MakeJoined(
    PolylineBuilder().Loop(Square).Chain(spiral).Chain({ { 0.1, 0.1 }, { 0.1005, 0.1 } }).Lines());
  EXPECT_TRUE(made.Problems.Groups().empty());
  EXPECT_EQ(made.Domain.NumberOfVertices(), 4 + 101 + 2);
}

TEST(OpenEnds, WeldedToAnotherInterfaceAreSaid)
{
  for (const double gap : { 1e-12, 1e-9, 1e-4 })
  {
    const Polylines input = PolylineBuilder()
                              .Loop(Square)
                              .Chain({ { 0.2, 0.5 }, { 0.8, 0.5 } }, ChainKind::Interface)
                              .Chain({ { 0.4, 0.5 + gap }, { 0.4, 0.8 } }, ChainKind::Interface)
                              .Lines();
    const MadeDomain made = MakeJoined(input);
    EXPECT_EQ(made.Problems.Count(ProblemCode::JoinedEnds), 1);
    EXPECT_EQ(FirstOf(ProblemCode::JoinedEnds, made).Ids, (std::vector<std::int64_t>{ 6, 1 }));
    EXPECT_TRUE(HasVertex(made.Domain, { 0.4, 0.5 }));
    EXPECT_TRUE(MakeJoined(input, 0.01, false).Problems.Has(ProblemCode::NotResolved));
  }
}

TEST(OpenEnds, StayOnASideOfWhichTheEndMoves)
{
  Places outline = Square;
  outline.push_back({ 0, 9e-4 });
  outline.front() = { 1e-5, 0 };
  const MadeDomain made =
    MakeJoined(PolylineBuilder().Chain(outline).Chain({ { 0, 0.5 }, { 1, 0.6 } }).Lines());
  EXPECT_EQ(made.Violation, "");
  EXPECT_EQ(made.Problems.Groups().size(), 1u);
  EXPECT_EQ(made.Domain.NumberOfVertices(), 6);
}

TEST(OpenEnds, SayTheLargestDistanceFirst)
{
  const MadeDomain made = MakeJoined(PolylineBuilder()
                                       .Loop(Square)
                                       .Chain({ { 1e-9, 0.3 }, { 0.5, 0.5 }, { 1 - 5e-4, 0.6 } })
                                       .Lines());
  const Problem& first = FirstOf(ProblemCode::JoinedEnds, made);
  EXPECT_EQ(first.Ids, (std::vector<std::int64_t>{ 6, 0 }));
  EXPECT_EQ(first.Detail, "moved by 0.0005, which is the most");
}

TEST(OpenEnds, DependOnNeitherOrderNorDirection)
{
  for (const Polylines& input :
    { Divided(3e-4).Lines(), NearlyClosed(5e-4).Lines(), Rounded(2e-3).Lines() })
  {
    const MadeDomain made = MakeJoined(input);
    EXPECT_EQ(made.Violation, "");
    EXPECT_FALSE(made.Problems.HasErrors());
    for (const Polylines& other : { Reverse(input), Unmerge(input), Unmerge(Reverse(input)) })
    {
      EXPECT_EQ(SortedVertices(MakeJoined(other)), SortedVertices(made));
    }
  }
}

TEST(OpenOutlines, WithinTheToleranceClose)
{
  for (const double gap : { 1e-12, 1e-9, 1e-6, 9e-4 })
  {
    const MadeDomain made = MakeJoined(NearlyClosed(gap).Lines());
    EXPECT_NEAR(made.Domain.Area, 0.96, 1e-15);
    EXPECT_EQ(made.Problems.Count(ProblemCode::JoinedEnds), 1);
    const MadeDomain rounded = MakeJoined(Rounded(gap).Lines());
    EXPECT_NEAR(
      rounded.Domain.Area, MakeJoined(Rounded(0.0).Lines()).Domain.Area, 1e-2 * gap + 1e-12);
    EXPECT_FALSE(rounded.Problems.HasErrors());
  }
}

TEST(OpenOutlines, CloseOverGapsOfTenTimesTheTolerance)
{
  const MadeDomain made = MakeJoined(NearlyClosed(9.9e-3).Lines());
  EXPECT_NEAR(made.Domain.Area, 0.96, 1e-15);
  EXPECT_EQ(made.Problems.Count(ProblemCode::JoinedEnds), 1);
  EXPECT_TRUE(MakeJoined(NearlyClosed(1.01e-2).Lines()).Problems.Has(ProblemCode::OpenOutlines));
  const PolylineBuilder alone =
    PolylineBuilder().Chain({ { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 5e-3 } });
  EXPECT_EQ(MakeJoined(alone.Lines()).Domain.Area, 0.5);
}

TEST(OpenOutlines, BeyondTheToleranceAreRefusedWithWhatClosesThem)
{
  const MadeDomain made = MakeJoined(NearlyClosed(0.3).Lines());
  EXPECT_EQ(made.Domain.NumberOfVertices(), 0);
  const Problem& problem = FirstOf(ProblemCode::OpenOutlines, made);
  EXPECT_EQ(problem.Ids, (std::vector<std::int64_t>{ 4, 8 }));
  EXPECT_EQ(problem.Detail, "a gap of 0.3; an End Tolerance of 3 closes it");
  EXPECT_NEAR(MakeJoined(NearlyClosed(0.3).Lines(), 3.0).Domain.Area, 0.96, 1e-12);
  EXPECT_TRUE(MakeJoined(Rounded(0.2).Lines()).Problems.Has(ProblemCode::OpenOutlines));
}

TEST(OpenOutlines, BesideADomainAreRefused)
{
  Places outline = Square;
  outline.push_back({ 0, 0.03 });
  const PolylineBuilder builder = PolylineBuilder().Box(5, 5, 6, 6).Chain(outline);
  EXPECT_TRUE(MakeJoined(builder.Lines()).Problems.Has(ProblemCode::OpenOutlines));
}

TEST(OpenOutlines, OfWhichADividerClosesAPartAreRefused)
{
  Places outline = Square;
  outline.push_back({ 0, 0.03 });
  const PolylineBuilder builder =
    PolylineBuilder().Chain(outline).Chain({ { 0, 0.5 }, { 1, 0.6 } });
  for (const Polylines& input : { builder.Lines(), Reverse(builder.Lines()) })
  {
    const MadeDomain made = MakeJoined(input);
    EXPECT_TRUE(made.Problems.Has(ProblemCode::OpenOutlines));
    EXPECT_NEAR(MakeJoined(input, 0.3001).Domain.Area, 1.0, 1e-12);
  }
}

TEST(OpenOutlines, AreNoLinesThatLeaveTheDomain)
{
  PolylineBuilder builder;
  builder.Loop(Square);
  for (int k = 1; k < 9; ++k)
  {
    builder.Chain({ { 0.1 * k, -0.5 }, { 0.1 * k, 1.5 } });
  }
  EXPECT_EQ(MakeJoined(builder.Lines()).Domain.Area, 1.0);
}

TEST(OpenOutlines, AreNoLinesThatEndApart)
{
  const PolylineBuilder line =
    PolylineBuilder().Box(0, 0, 1, 1).Chain({ { 2, 0 }, { 2, 1 }, { 3, 2 } });
  const MadeDomain made = MakeJoined(line.Lines());
  EXPECT_EQ(made.Domain.Area, 1.0);
  EXPECT_EQ(made.Problems.Count(ProblemCode::OutsideInterfaces), 1);
  const PolylineBuilder river =
    PolylineBuilder().Box(0, 0, 1, 1).Chain({ { -3, 0.2 }, { 4, 0.7 } });
  EXPECT_FALSE(MakeJoined(river.Lines()).Problems.HasErrors());
}

TEST(OpenOutlines, AloneNameTheirGap)
{
  const MadeDomain made =
    MakeJoined(PolylineBuilder().Chain({ { 0, 0 }, { 1, 0 }, { 0, 0.02 } }).Lines());
  const Problem& problem = FirstOf(ProblemCode::NoClosedLoop, made);
  EXPECT_EQ(problem.Detail, "a gap of 0.02; an End Tolerance of 0.2 closes it");
}

} // namespace

} // namespace biting
