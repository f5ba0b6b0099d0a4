// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Domain/CrossingEstimate.h"
#include "Domain/Arrangement.h"
#include "Domain/Domain.h"
#include "Support/PolylineShapes.h"

#include <gtest/gtest.h>

namespace biting
{

namespace
{

/// Edges of their own, each between two vertices.
Arrangement EdgesBetween(const std::vector<Point2>& ends)
{
  Arrangement made;
  made.Vertices = ends;
  for (std::size_t v = 0; v < ends.size(); v += 2)
  {
    ArrangementEdge edge;
    edge.Ends = { static_cast<Id>(v), static_cast<Id>(v) + 1 };
    edge.Cell = static_cast<Id>(v / 2);
    made.Edges.push_back(edge);
  }
  return made;
}

/// Half of the edges lead across, half of them up: count * count / 4 crossings.
Arrangement Lattice(int count)
{
  std::vector<Point2> ends;
  for (int i = 0; i < count; ++i)
  {
    const double at = i + 0.5;
    const bool leadsUp = i % 2 != 0;
    ends.push_back(leadsUp ? Point2{ at, -1.0 } : Point2{ -1.0, at });
    ends.push_back(leadsUp ? Point2{ at, count + 1.0 } : Point2{ count + 1.0, at });
  }
  return EdgesBetween(ends);
}

/// Short edges beside each other, and one that crosses all of them.
Arrangement Comb(int count)
{
  std::vector<Point2> ends{ { -1.0, 0.25 }, { count + 1.0, 0.25 } };
  for (int i = 0; i < count; ++i)
  {
    ends.push_back({ i + 0.0, 0.0 });
    ends.push_back({ i + 0.0, 0.5 });
  }
  return EdgesBetween(ends);
}

CrossingEstimate Estimate(const Arrangement& arrangement, std::size_t most)
{
  SilentMonitor monitor;
  Pulse pulse(monitor);
  const std::vector<SegmentEnds> edges = arrangement.EdgeEnds();
  Pulse unheard(NoMonitor());
  const SegmentTree tree(arrangement.Vertices, edges, 0.0, unheard);
  return EstimateCrossingsAbove(most, arrangement.Vertices, edges, tree, pulse);
}

TEST(CrossingEstimate, IsNearWhereTheLimitIsFarExceeded)
{
  const CrossingEstimate estimate = Estimate(Lattice(400), 4000);
  EXPECT_NEAR(estimate.Count, 40000.0, 10000.0);
  EXPECT_NE(estimate.First % 2, estimate.Second % 2);
}

TEST(CrossingEstimate, IsNoneWhereTheLimitIsNotExceeded)
{
  EXPECT_EQ(Estimate(Lattice(400), 40000).Count, 0.0);
  EXPECT_EQ(Estimate(Lattice(400), 60000).Count, 0.0);
  EXPECT_EQ(Estimate(Lattice(1), 0).Count, 0.0);
}

TEST(CrossingEstimate, IsNotLedAstrayByOneEdgeThatCrossesAll)
{
  EXPECT_EQ(Estimate(Comb(3000), 3000).Count, 0.0);
  EXPECT_EQ(Estimate(Comb(3000), 5000).Count, 0.0);
}

/// Nor are ends joined, each of which may have thousands of lines near it.
TEST(CrossingEstimate, RefusesADrawingBeforeItsCrossingsAreMade)
{
  PolylineBuilder drawing = PolylineBuilder().Box(-2, -2, 402, 402);
  const Arrangement lattice = Lattice(400);
  for (const ArrangementEdge& edge : lattice.Edges)
  {
    drawing.Chain({ lattice.At(edge.Ends.Start), lattice.At(edge.Ends.End) });
  }
  DomainOptions options;
  options.MaximumNumberOfCrossings = 20000;
  options.GivenSpacing = [](const Point2&) { return 200.0; };
  ProblemList problems;
  SilentMonitor monitor;
  EXPECT_EQ(MakeDomain(drawing.Lines(), options, problems, monitor).NumberOfSegments(), 0);
  ASSERT_EQ(problems.Count(ProblemCode::NotResolved), 1);
  const Problem& refusal = problems.Groups().back().First.front();
  EXPECT_EQ(refusal.Ids.size(), 2u);
  EXPECT_NE(refusal.Detail, "");
  EXPECT_FALSE(problems.Has(ProblemCode::JoinedEnds));
}

} // namespace

} // namespace biting
