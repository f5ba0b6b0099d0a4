// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "OldMeshShapes.h"
#include "Remeshing/ChangedRegion.h"

#include <gtest/gtest.h>

#include <algorithm> // for count

namespace biting
{

namespace
{

/// Of the vertices of a mesh with one spacing, how many are misfits.
std::ptrdiff_t CountMisfits(
  const RemeshInput& input, double spacing, const EdgeFreedom& freedom = {})
{
  ProblemList problems;
  const OldMesh mesh = ReadOldMesh(input, 0.0, problems, NoMonitor());
  EXPECT_TRUE(problems.Groups().empty());
  const std::vector<double> spacings(mesh.Points.size(), spacing);
  const std::vector<std::uint8_t> isMisfit =
    FindMisfits(mesh, spacings, MeanLengths(mesh, spacings), freedom);
  return std::count(isMisfit.begin(), isMisfit.end(), 1);
}

/// Two triangles, on a side of three vertices.
RemeshInput SideOfTwoEdges()
{
  RemeshInput input;
  input.Points = { { 0.0, 0.0 }, { 1.0, 0.0 }, { 2.0, 0.0 }, { 1.0, 1.0 } };
  input.Corners = { 0, 1, 3, 1, 2, 3 };
  input.Rounding = 1e-15;
  return input;
}

} // namespace

TEST(MisfitVertices, AreThereWhereEdgesAreBeyondTheBand)
{
  for (const double spacing : { 0.71, 1.0, 1.41 })
  {
    EXPECT_EQ(CountMisfits(Hexagon(), spacing), 0);
  }
  for (const double spacing : { 0.7, 1.42, 5.0 })
  {
    EXPECT_EQ(CountMisfits(Hexagon(), spacing), 7);
  }
}

TEST(MisfitVertices, AreNoneWhereNothingMayGo)
{
  RemeshInput input = Hexagon();
  input.IsFixed.assign(7, 0);
  input.IsFixed[6] = 1;
  EXPECT_EQ(CountMisfits(input, 2.0), 0);
  EXPECT_EQ(CountMisfits(input, 2.0, { EdgePolicy::Free, true }), 7);
  EXPECT_EQ(CountMisfits(input, 0.5), 7);
}

TEST(MisfitVertices, OfStraightEdgesMayGoWhereThePolicyLetsThem)
{
  EXPECT_EQ(CountMisfits(SideOfTwoEdges(), 4.0), 4);
  EXPECT_EQ(CountMisfits(SideOfTwoEdges(), 4.0, { EdgePolicy::SplitOnly, false }), 0);
}

TEST(MisfitVertices, AreNoneWhereNoEdgeMayBeDivided)
{
  RemeshInput input;
  input.Points = RegularPolygon({ 0.0, 0.0 }, 1.0, 3);
  input.Corners = { 0, 1, 2 };
  EXPECT_EQ(CountMisfits(input, 0.5), 3);
  EXPECT_EQ(CountMisfits(input, 0.5, { EdgePolicy::SplitOnly, false }), 3);
  EXPECT_EQ(CountMisfits(input, 0.5, { EdgePolicy::Frozen, false }), 0);
}

} // namespace biting
