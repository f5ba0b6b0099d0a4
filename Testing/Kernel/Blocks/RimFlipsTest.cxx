// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "../Quality/TestMesh.h"

#include "Blocks/StripReturn.h"
#include "Quality/MeshCheck.h"

#include <gtest/gtest.h>

#include <numeric> // for iota

namespace biting
{

namespace
{

std::string CheckDelaunay(
  const std::vector<Point2>& points, const Triangulation& mesh, double expectedArea)
{
  MeshCheckInput input{ points, mesh.Corners, mesh.Neighbors, mesh.Constraints, expectedArea };
  input.IsDelaunay = true;
  return CheckMesh(input);
}

Triangulation TrianglesOf(const TestMesh& mesh)
{
  Triangulation triangles;
  triangles.Corners = mesh.Corners;
  triangles.Neighbors = mesh.Neighbors;
  triangles.Constraints = mesh.Constraints;
  triangles.Regions.assign(mesh.Corners.size() / 3, 0);
  return triangles;
}

std::vector<std::size_t> AllSlots(const Triangulation& mesh)
{
  std::vector<std::size_t> slots(mesh.Corners.size());
  std::iota(slots.begin(), slots.end(), std::size_t{ 0 });
  return slots;
}

} // namespace

TEST(FlipUntilDelaunay, MakesAnyMeshDelaunay)
{
  for (std::uint64_t seed = 1; seed <= 6; ++seed)
  {
    TestMesh mesh = TestMesh::Random(80, seed);
    mesh.Shuffle(500, seed);
    Triangulation triangles = TrianglesOf(mesh);
    ASSERT_NE(CheckDelaunay(mesh.Points, triangles, 1.0), "");
    Pulse pulse(NoMonitor());
    FlipUntilDelaunay(mesh.Points, AllSlots(triangles), triangles, pulse);
    EXPECT_EQ(CheckDelaunay(mesh.Points, triangles, 1.0), "");
  }
}

/// One flip makes its four neighbours doubtful, and so on.
TEST(FlipUntilDelaunay, GoesOnFromTheEdgesThatAreListed)
{
  int numberOfMeshes = 0;
  for (std::uint64_t seed = 1; seed <= 24; ++seed)
  {
    TestMesh mesh = TestMesh::Random(80, seed);
    mesh.MakeDelaunay();
    const std::size_t slot = 3 * (seed % 20);
    if (mesh.Neighbors[slot] == NoId || !mesh.Flip(slot) || !mesh.IsCounterclockwise())
    {
      continue;
    }
    ++numberOfMeshes;
    Triangulation triangles = TrianglesOf(mesh);
    const std::size_t first = slot - slot % 3;
    Pulse pulse(NoMonitor());
    FlipUntilDelaunay(mesh.Points, { first, first + 1, first + 2 }, triangles, pulse);
    EXPECT_EQ(CheckDelaunay(mesh.Points, triangles, 1.0), "");
  }
  EXPECT_GT(numberOfMeshes, 5);
}

TEST(FlipUntilDelaunay, ConstraintsStay)
{
  const std::vector<Point2> points{ { 0.0, 0.0 }, { 4.0, 0.0 }, { 2.0, 1.0 }, { 2.0, -1.0 } };
  Triangulation mesh;
  mesh.Corners = { 0, 1, 2, 1, 0, 3 };
  mesh.Neighbors = { NoId, NoId, 1, NoId, NoId, 0 };
  mesh.Constraints = { 1, 2, 0, 3, 4, 0 };
  mesh.Regions = { 0, 0 };
  const Triangulation before = mesh;
  Pulse pulse(NoMonitor());
  FlipUntilDelaunay(points, AllSlots(mesh), mesh, pulse);
  EXPECT_EQ(mesh.Corners, before.Corners);
  mesh.Constraints[2] = mesh.Constraints[5] = NoId;
  FlipUntilDelaunay(points, AllSlots(mesh), mesh, pulse);
  EXPECT_NE(mesh.Corners, before.Corners);
  EXPECT_EQ(CheckDelaunay(points, mesh, 4.0), "");
}

} // namespace biting
