// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Spacing/BorderTurns.h"

#include <gtest/gtest.h>

#include <algorithm> // for reverse

namespace
{

using namespace biting;

constexpr double QuarterTurn = 1.5707963267948966;

/// Closed, from each point to the next one.
std::vector<BorderEdge> Loop(const std::vector<Point2>& points)
{
  std::vector<BorderEdge> edges;
  for (std::size_t k = 0; k < points.size(); ++k)
  {
    const std::size_t next = (k + 1) % points.size();
    edges.push_back(
      { points[k], points[next], 1.0, 1.0, static_cast<Id>(k), static_cast<Id>(next) });
  }
  return edges;
}

std::vector<Point2> Square()
{
  return { { 0.0, 0.0 }, { 1.0, 0.0 }, { 1.0, 1.0 }, { 0.0, 1.0 } };
}

double TurnAfter(const std::vector<BorderEdge>& edges, std::size_t edge)
{
  Pulse pulse(NoMonitor());
  return BorderTurns(edges, pulse).TurnAround(edges[edge]);
}

} // namespace

TEST(BorderTurns, AreQuartersAtTheCornersOfASquare)
{
  const std::vector<BorderEdge> edges = Loop(Square());
  for (std::size_t edge = 0; edge < edges.size(); ++edge)
  {
    EXPECT_NEAR(TurnAfter(edges, edge), QuarterTurn, 1e-12) << edge;
  }
}

TEST(BorderTurns, AreNegativeInTheCornersOfAHole)
{
  std::vector<Point2> points = Square();
  std::reverse(points.begin(), points.end());
  EXPECT_NEAR(TurnAfter(Loop(points), 0), -QuarterTurn, 1e-12);
}

/// Of two squares that meet in a corner, each turns up to the edge that follows counterclockwise.
TEST(BorderTurns, AreThoseToTheNextEdgeWherePartsOfTheBorderMeet)
{
  std::vector<BorderEdge> edges = Loop(Square());
  edges.push_back({ { 0.0, 0.0 }, { -1.0, 0.0 }, 1.0, 1.0, 0, 4 });
  edges.push_back({ { 0.0, -1.0 }, { 0.0, 0.0 }, 1.0, 1.0, 5, 0 });
  EXPECT_NEAR(TurnAfter(edges, 3), -QuarterTurn, 1e-12);
  EXPECT_NEAR(TurnAfter(edges, 5), -QuarterTurn, 1e-12);
}
