// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "OldMeshShapes.h"
#include "Remeshing/KeptVertices.h"

#include <gtest/gtest.h>

#include <algorithm> // for sort

namespace biting
{

namespace
{

/// Those of a mesh with one spacing, all of it in the region, and all kept but `gone`.
std::vector<Point2> MiddlesOf(const RemeshInput& input, double spacing, Id gone = NoId)
{
  ProblemList problems;
  const OldMesh mesh = ReadOldMesh(input, 0.0, problems, NoMonitor());
  EXPECT_TRUE(problems.Groups().empty());
  const std::vector<double> spacings(mesh.Points.size(), spacing);
  const ChangedRegion region = WholeRegion(mesh, MeanLengths(mesh, spacings));
  std::vector<std::uint8_t> isKept(mesh.Points.size(), 1);
  if (gone != NoId)
  {
    isKept[gone] = 0;
  }
  return FindMiddles(mesh, region, isKept, spacings);
}

} // namespace

TEST(DividedEdges, HaveTheirMiddlesOnInnerEdges)
{
  const RemeshInput input = Hexagon();
  std::vector<Point2> expected;
  for (std::size_t k = 0; k < 6; ++k)
  {
    expected.push_back(0.5 * input.Points[k]);
  }
  std::vector<Point2> middles = MiddlesOf(input, 0.5);
  std::sort(expected.begin(), expected.end());
  std::sort(middles.begin(), middles.end());
  EXPECT_EQ(middles, expected);
}

TEST(DividedEdges, AreThoseWhoseHalvesAreWithinTheBand)
{
  for (const double spacing : { 0.36, 0.5, 0.7 })
  {
    EXPECT_EQ(MiddlesOf(Hexagon(), spacing).size(), 6u);
  }
  for (const double spacing : { 0.35, 0.71, 1.0 })
  {
    EXPECT_TRUE(MiddlesOf(Hexagon(), spacing).empty());
  }
}

TEST(DividedEdges, AreNoneAtVerticesThatGo)
{
  EXPECT_EQ(MiddlesOf(Hexagon(), 0.5, 0).size(), 3u);
  EXPECT_TRUE(MiddlesOf(Hexagon(), 0.5, 6).empty());
}

TEST(DividedEdges, AreNoneOnLines)
{
  RemeshInput input = Hexagon();
  input.LineStarts = { 6 };
  input.LineEnds = { 2 };
  input.LineCells = { 0 };
  EXPECT_EQ(MiddlesOf(input, 0.5).size(), 5u);
}

TEST(DividedEdges, AreNoneBesideFlatTriangles)
{
  RemeshInput input;
  input.Points = { { 0.0, 0.0 }, { 2.8, 0.0 }, { 1.4, 1.8 }, { 1.4, -0.6 } };
  input.Corners = { 0, 1, 2, 1, 0, 3 };
  EXPECT_TRUE(MiddlesOf(input, 1.0).empty());
  input.Points[3].Y = -0.8;
  EXPECT_EQ(MiddlesOf(input, 1.0), (std::vector<Point2>{ { 1.4, 0.0 } }));
}

TEST(DividedEdges, AreNoneBesideTrianglesWithAShortEdge)
{
  RemeshInput input;
  input.Points = { { 0.0, 0.0 }, { 2.0, 0.0 }, { 1.0, 1.8 }, { 0.2, -1.2 } };
  input.Corners = { 0, 1, 2, 1, 0, 3 };
  EXPECT_TRUE(MiddlesOf(input, 1.0).empty());
  input.Points[3] = { 0.8, -1.8 };
  EXPECT_EQ(MiddlesOf(input, 1.0).size(), 1u);
}

} // namespace biting
