// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/OldMesh.h"

#include <gtest/gtest.h>

#include <algorithm> // for count
#include <map>       // for counts

namespace biting
{

TEST(OldMesh, LinesAndFixedVerticesStayWherePointsAreMadeOne)
{
  RemeshInput input;
  input.Points = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 }, { 0, 0 }, { 1, 1 }, { 2, 1 }, { 1, 0 } };
  input.Corners = { 0, 1, 2, 4, 5, 3, 7, 6, 5 };
  input.LineStarts = { 4, 5, 7 };
  input.LineEnds = { 5, 7, 0 };
  input.LineCells = { 7, 8, 9 };
  input.IsFixed = { 0, 0, 0, 0, 0, 1, 0, 0 };
  ProblemList problems;
  const OldMesh mesh = ReadOldMesh(input, 0.0, problems, NoMonitor());
  EXPECT_EQ(problems.Count(ProblemCode::DuplicatePoints), 3);
  EXPECT_EQ(problems.Count(ProblemCode::OutsideInterfaces), 0);
  std::map<Id, int> sides; // of the triangles, on each line
  for (const Id mark : mesh.Marks)
  {
    ++sides[mark];
  }
  EXPECT_EQ(sides, (std::map<Id, int>{ { OldMesh::Untagged, 4 }, { 1, 2 }, { 2, 2 }, { 3, 1 } }));
  EXPECT_EQ(mesh.IsFixed[2], 1);
}

// Frozen by itself, or by a triangle or line at it; of two such the lower number stays.
TEST(OldMesh, FrozenPlacesStayWherePointsAreMadeOne)
{
  RemeshInput input;
  input.Points = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 }, { 1e-16, 0 }, { 1, 1 + 2.3e-16 } };
  input.Corners = { 0, 1, 2, 4, 5, 3 };
  input.Rounding = 1e-15;
  const auto cornersWith = [&input](std::vector<std::uint8_t> isFixed, Id frozen)
  {
    input.IsFixed = std::move(isFixed);
    input.IsFrozen = { frozen == 0, frozen == 1 };
    ProblemList problems;
    const OldMesh mesh = ReadOldMesh(input, 1e-15, problems, NoMonitor());
    EXPECT_EQ(problems.Count(ProblemCode::NearPoints), 2);
    return mesh.Corners;
  };
  const std::vector<std::uint8_t> none(6, 0);
  EXPECT_EQ(cornersWith(none, NoId), (std::vector<Id>{ 0, 1, 2, 0, 2, 3 }));
  EXPECT_EQ(cornersWith(none, 0), (std::vector<Id>{ 0, 1, 2, 0, 2, 3 }));
  EXPECT_EQ(cornersWith(none, 1), (std::vector<Id>{ 4, 1, 5, 4, 5, 3 }));
  EXPECT_EQ(cornersWith({ 0, 0, 0, 0, 0, 1 }, NoId), (std::vector<Id>{ 0, 1, 5, 0, 5, 3 }));
  EXPECT_EQ(cornersWith({ 0, 0, 1, 0, 0, 1 }, NoId), (std::vector<Id>{ 0, 1, 2, 0, 2, 3 }));
  input.LineStarts = { 4, 0 };
  input.LineEnds = { 3, 1 };
  input.LineCells = { 0, 1 };
  input.IsFrozenLine = { 0, 0 };
  EXPECT_EQ(cornersWith(none, NoId), (std::vector<Id>{ 0, 1, 2, 0, 2, 3 }));
  input.IsFrozenLine = { 1, 0 };
  EXPECT_EQ(cornersWith(none, NoId), (std::vector<Id>{ 4, 1, 2, 4, 2, 3 }));
  input.IsFrozenLine = { 1, 1 };
  EXPECT_EQ(cornersWith(none, NoId), (std::vector<Id>{ 0, 1, 2, 0, 2, 3 }));
}

// The tags are those of the first.
TEST(OldMesh, AnEdgeIsFrozenWhereOneOfItsLinesIs)
{
  RemeshInput input;
  input.Points = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } };
  input.Corners = { 0, 1, 2, 0, 2, 3 };
  input.LineStarts = { 0, 2, 1 };
  input.LineEnds = { 2, 0, 2 };
  input.LineCells = { 7, 8, 9 };
  input.IsFrozenLine = { 0, 1, 0 };
  ProblemList problems;
  const OldMesh mesh = ReadOldMesh(input, 0.0, problems, NoMonitor());
  std::map<Id, bool> isFrozen; // of the lines on edges
  for (const Id mark : mesh.Marks)
  {
    if (mark > OldMesh::Untagged)
    {
      isFrozen[mesh.LineCells[mark - 1]] = mesh.IsFrozenEdge(mark);
    }
  }
  EXPECT_EQ(isFrozen, (std::map<Id, bool>{ { 7, true }, { 9, false } }));
}

TEST(OldMesh, FlatTrianglesAreMendedWithWhatIsKnownOfTheirNeighbours)
{
  RemeshInput input;
  input.Points = { { 0, 0 }, { 2, 0 }, { 1, 1 }, { 1, -1 }, { 1, 0 } };
  input.Corners = { 0, 4, 2, 4, 1, 2, 0, 1, 4, 1, 0, 3 };
  input.Regions = { 5, 5, 6, 7 };
  input.IsFrozen = { 1, 0, 0, 1 };
  input.CellIds = { 10, 11, 12, 13 };
  ProblemList problems;
  const OldMesh mesh = ReadOldMesh(input, 0.0, problems, NoMonitor());
  ASSERT_EQ(problems.Groups().size(), 1u);
  EXPECT_EQ(problems.Groups()[0].Code, ProblemCode::FlatTriangles);
  EXPECT_EQ(problems.Groups()[0].First[0].Ids, (std::vector<std::int64_t>{ 12 }));
  EXPECT_EQ(mesh.Origins, (std::vector<Id>{ 0, 1, 3, 3 }));
  EXPECT_EQ(mesh.Regions, (std::vector<Id>{ 5, 5, 7, 7 }));
  EXPECT_EQ(mesh.IsRepaired, (std::vector<std::uint8_t>{ 0, 0, 1, 1 }));
  EXPECT_EQ(mesh.IsFrozen, (std::vector<std::uint8_t>{ 1, 0, 0, 0 }));
  EXPECT_DOUBLE_EQ(mesh.Area, 2.0);
}

TEST(OldMesh, LinesAlongFlatTrianglesAreTheirParts)
{
  // Two flat triangles in turn, the first of them at a free edge or not.
  const std::vector<Id> corners{ 0, 4, 2, 4, 5, 2, 5, 1, 2, 0, 5, 4, 0, 1, 5, 1, 0, 3 };
  for (const std::size_t triangles : { 5u, 6u })
  {
    RemeshInput input;
    input.Points = { { 0, 0 }, { 4, 0 }, { 2, 1 }, { 2, -1 }, { 1, 0 }, { 3, 0 } };
    input.Corners.assign(
      corners.begin(), corners.begin() + 3 * static_cast<std::ptrdiff_t>(triangles));
    input.LineStarts = { 1, 0 };
    input.LineEnds = { 0, 2 };
    input.LineCells = { 7, 8 };
    ProblemList problems;
    const OldMesh mesh = ReadOldMesh(input, 0.0, problems, NoMonitor());
    EXPECT_EQ(problems.Count(ProblemCode::FlatTriangles), 2);
    EXPECT_EQ(problems.Count(ProblemCode::OutsideInterfaces), 0);
    const std::ptrdiff_t sides = triangles == 5 ? 1 : 2;
    EXPECT_EQ(std::count(mesh.Marks.begin(), mesh.Marks.end(), 1), 3 * sides);
    EXPECT_EQ(std::count(mesh.Marks.begin(), mesh.Marks.end(), 2), 1);
  }
}

TEST(OldMesh, SlitsAreClosedThatAreNoWiderThanAsked)
{
  for (const double width : { 1e-7, 1e-5 })
  {
    RemeshInput input;
    input.Points = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 }, { 0, width }, { 1 - width, 1 } };
    input.Corners = { 0, 1, 2, 5, 4, 3 }; // of both orientations
    ProblemList problems;
    const OldMesh mesh = ReadOldMesh(input, 1e-6, problems, NoMonitor());
    ASSERT_FALSE(mesh.Corners.empty());
    EXPECT_EQ(problems.Count(ProblemCode::NearPoints), width < 1e-6 ? 2 : 0);
    EXPECT_EQ(std::count(mesh.Neighbors.begin(), mesh.Neighbors.end(), NoId), width < 1e-6 ? 4 : 6);
  }
}

TEST(OldMesh, CoordinatesThatPredicatesCannotHandleAreRefusedAsSuch)
{
  for (const double size : { 1e-300, 1e-80, 1e-60, 1.0, 1e60, 1e100, 1e150, 1e300 })
  {
    RemeshInput input;
    input.Points = { { 0, 0 }, { size, 0 }, { size, size }, { 0, size } };
    input.Corners = { 0, 1, 2, 0, 2, 3 };
    input.PointIds = { 10, 11, 12, 13 };
    ProblemList problems;
    ReadOldMesh(input, 0.0, problems, NoMonitor());
    const bool isRefused = size < 1e-70 || size > 1e70;
    EXPECT_EQ(problems.Has(ProblemCode::OutOfRange), isRefused) << size;
    EXPECT_EQ(problems.Groups().size(), isRefused ? 1 : 0) << size;
    if (size > 1e70)
    {
      EXPECT_EQ(problems.Count(ProblemCode::OutOfRange), 3);
      EXPECT_EQ(problems.Groups().front().First.front().Ids.front(), 11);
    }
  }
}

TEST(OldMesh, WhatIsNoMeshIsRefusedWithItsCells)
{
  const std::vector<Point2> points{ { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 }, { 2, 0 }, { 0.5, 0.2 },
    { 0.8, 0.3 }, { 0.6, 0.6 }, { 0, 0 }, { 1, 0 }, { 1, 1 } };
  const std::vector<std::vector<Id>> bad{
    { 0, 1, 4 },                   // no area
    { 0, 1, 2, 0, 1, 3 },          // folded
    { 0, 1, 2, 0, 1, 2 },          // twice the same
    { 0, 1, 2, 0, 2, 3, 1, 0, 2 }, // one of them twice, turned
    { 0, 1, 2, 8, 9, 10 },         // twice the same, by points of its own
    { 0, 1, 2, 0, 2, 3, 0, 2, 4 }, // three at an edge
    { 0, 1, 2, 0, 2, 3, 5, 6, 7 }, // one on top of the others
    { 0, 1, 2, 3, 5, 6 },          // crossing
  };
  for (const std::vector<Id>& corners : bad)
  {
    RemeshInput input;
    input.Points = points;
    input.Corners = corners;
    ProblemList problems;
    EXPECT_TRUE(ReadOldMesh(input, 0.0, problems, NoMonitor()).Points.empty());
    ASSERT_GE(problems.Count(ProblemCode::BadTriangles), 1);
    const Problem& first = problems.Groups().back().First.front();
    EXPECT_EQ(first.Ids.size(), 1u);
    EXPECT_TRUE(first.Place.X >= 0.0 && first.Place.X <= 1.0);
  }
}

// However little of the mesh they are.
TEST(OldMesh, SmallTrianglesOnTopOfOthersAreRefused)
{
  for (const Point2& place : { Point2{ 600.0, 300.0 }, Point2{ -0.003, 500.0 } })
  {
    RemeshInput input;
    input.Points = { { 0, 0 }, { 1000, 0 }, { 1000, 1000 }, { 0, 1000 }, place,
      place + Point2{ 0.01, 0.0 }, place + Point2{ 0.0, 0.01 } };
    input.Corners = { 0, 1, 2, 0, 2, 3, 4, 5, 6 };
    input.Rounding = 1e-12;
    ProblemList problems;
    EXPECT_TRUE(ReadOldMesh(input, 0.0, problems, NoMonitor()).Points.empty());
    EXPECT_GE(problems.Count(ProblemCode::BadTriangles), 1);
  }
}

// Rounding may have moved only what is near to other edges.
TEST(OldMesh, NoLongBoundaryExcusesTrianglesOnOthers)
{
  for (const bool hasNarrowWedge : { false, true })
  {
    RemeshInput input;
    input.Points = { { 0, 0 }, { 1e6, 0 }, { 1e6, 1e6 }, { 0, 1e6 } };
    input.Corners = { 0, 1, 2, 0, 2, 3 };
    input.Rounding = 1.0;
    if (hasNarrowWedge)
    {
      input.Points.insert(input.Points.end(), { { -200, 0 }, { -100, 0 }, { -100, 0.5 } });
      input.Points.insert(input.Points.end(), { { -150, -100 }, { -150, 100 } });
      input.Corners.insert(input.Corners.end(), { 4, 7, 5, 4, 6, 8 });
    }
    ProblemList problems;
    EXPECT_FALSE(ReadOldMesh(input, 0.0, problems, NoMonitor()).Corners.empty());
    EXPECT_FALSE(problems.HasErrors());

    const auto first = static_cast<Id>(input.Points.size());
    input.Points.insert(
      input.Points.end(), { { 5e5, 4e5 }, { 5e5 + 100, 4e5 }, { 5e5, 4e5 + 90 } });
    input.Corners.insert(input.Corners.end(), { first, first + 1, first + 2 });
    EXPECT_TRUE(ReadOldMesh(input, 0.0, problems, NoMonitor()).Corners.empty());
    ASSERT_TRUE(problems.Has(ProblemCode::BadTriangles));
    EXPECT_EQ(problems.Groups().back().First.front().Ids.front(),
      static_cast<std::int64_t>(input.Corners.size() / 3) - 1);
  }
}

} // namespace biting
