// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "DomainLaws.h"

#include <algorithm> // for replace, reverse, rotate
#include <cmath>     // for ldexp

namespace biting
{

namespace
{

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

} // namespace

} // namespace biting
