// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Domain/ResolutionReport.h"

#include "../Support/Monitors.h"
#include "Base/Monitor.h"

#include <gtest/gtest.h>

namespace biting
{

namespace
{

ArrangementEdge Edge(Id start, Id end, Id cell, Id boundaryCount)
{
  ArrangementEdge edge;
  edge.Ends = { start, end };
  edge.Cell = cell;
  edge.BoundaryCount = boundaryCount;
  edge.IsInterface = boundaryCount == 0;
  return edge;
}

/// Two boundary edges that cross in (1, 1), and an interface that ends near the first.
Arrangement Cross()
{
  Arrangement cross;
  cross.Vertices = { { 0.0, 0.0 }, { 2.0, 2.0 }, { 0.0, 2.0 }, { 2.0, 0.0 }, { 0.5, 0.5 + 1e-12 },
    { 0.0, 1.0 } };
  cross.VertexPoints = { 10, 11, 12, 13, 14, 15 };
  cross.Edges = { Edge(0, 1, 7, 1), Edge(2, 3, 5, 1), Edge(4, 5, 3, 0) };
  cross.Rounding = 1e-15;
  cross.Resolution = 1e-11;
  return cross;
}

} // namespace

TEST(ResolutionReport, HasTheFirstRoundOnly)
{
  const Arrangement cross = Cross();
  ProblemList problems;
  SilentMonitor monitor;
  Pulse pulse(monitor);
  ResolutionReport report(cross, problems);
  Meetings found;
  found.Reports = { { ProblemCode::Crossings, 0, 1, NoId } };
  EXPECT_FALSE(report.HasDefect());
  report.AddRound(found, pulse);
  EXPECT_TRUE(report.HasDefect());
  report.AddRound(found, pulse);
  EXPECT_EQ(problems.Count(ProblemCode::Crossings), 1);
  const Problem& first = problems.Groups().front().First.front();
  EXPECT_EQ(first.Ids, (std::vector<std::int64_t>{ 5, 7 })) << "cells, ascending";
  EXPECT_EQ(first.Place, (Point3{ 1.0, 1.0, 0 }));
}

TEST(ResolutionReport, RefusesWithThePlaceOfTheFirstDefect)
{
  const Arrangement cross = Cross();
  ProblemList problems;
  SilentMonitor monitor;
  Pulse pulse(monitor);
  ResolutionReport report(cross, problems);
  Meetings found;
  found.Reports = { { ProblemCode::Crossings, 0, 1, NoId } };
  report.AddRound(found, pulse);
  found.Reports.clear();
  found.Splits = { { 0, 4 } };
  report.AddRound(found, pulse);
  EXPECT_FALSE(report.Refuse(ProblemCode::NotResolved));
  EXPECT_EQ(problems.Groups().back().First.front().Place, (Point3{ 1.0, 1.0, 0 }));
}

TEST(ResolutionReport, RefusesWithThePlaceOfTheLastRoundWhereTheFirstHadNothingToSay)
{
  const Arrangement cross = Cross();
  ProblemList problems;
  SilentMonitor monitor;
  Pulse pulse(monitor);
  ResolutionReport report(cross, problems);
  Meetings found;
  found.Splits = { { 0, 4 } };
  report.AddRound(found, pulse);
  EXPECT_FALSE(report.HasDefect());
  EXPECT_FALSE(report.Refuse(ProblemCode::NotResolved));
  EXPECT_EQ(problems.Groups().back().First.front().Place, Point3(cross.Vertices[4]));
}

} // namespace biting
