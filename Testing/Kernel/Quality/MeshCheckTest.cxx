// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Quality/MeshCheck.h"

#include "../Support/TestThreads.h"
#include "TestMesh.h"

#include <gtest/gtest.h>

#include <algorithm> // for swap_ranges
#include <cmath>     // for ldexp, nan
#include <utility>   // for swap

namespace
{

using biting::Id;
using biting::NoId;
using biting::Point2;
using biting::TestMesh;

std::string Check(const TestMesh& mesh, double expectedArea)
{
  return biting::CheckMesh(
    { mesh.Points, mesh.Corners, mesh.Neighbors, mesh.Constraints, expectedArea });
}

std::string Check(const TestMesh& mesh)
{
  return Check(mesh, mesh.Area());
}

void ExpectViolation(const std::string& violation, const std::string& part)
{
  EXPECT_NE(violation.find(part), std::string::npos) << "was: " << violation;
}

TestMesh HoledGrid()
{
  TestMesh mesh = TestMesh::Grid(biting::UnitLines(8), biting::UnitLines(6),
    [](std::size_t column, std::size_t row) { return column % 3 != 1 || row % 3 != 1; });
  mesh.Jitter(0.3, 7);
  return mesh;
}

std::size_t SlotWithNeighbor(const TestMesh& mesh)
{
  std::size_t slot = 0;
  while (mesh.Neighbors[slot] == NoId)
  {
    slot += 1;
  }
  return slot;
}

std::size_t SlotWithoutNeighbor(const TestMesh& mesh)
{
  std::size_t slot = 0;
  while (mesh.Neighbors[slot] != NoId)
  {
    slot += 1;
  }
  return slot;
}

std::string CheckDelaunay(const TestMesh& mesh)
{
  biting::MeshCheckInput input{ mesh.Points, mesh.Corners, mesh.Neighbors, mesh.Constraints,
    mesh.Area() };
  input.IsDelaunay = true;
  return biting::CheckMesh(input);
}

TEST(CheckMesh, AcceptsNoMeshOfNoArea)
{
  EXPECT_EQ(Check({}), "");
}

TEST(CheckMesh, FindsEachEdgeThatIsNotDelaunayWhereItIsAsked)
{
  TestMesh mesh = TestMesh::Random(60, 3);
  mesh.MakeDelaunay();
  EXPECT_EQ(CheckDelaunay(mesh), "");
  int flipped = 0;
  for (std::size_t slot = 0; slot < mesh.Corners.size(); ++slot)
  {
    TestMesh bent = mesh;
    if (mesh.Neighbors[slot] != NoId && bent.Flip(slot) && bent.IsCounterclockwise())
    {
      ++flipped;
      EXPECT_EQ(Check(bent), "");
      ExpectViolation(CheckDelaunay(bent), "is not Delaunay");
    }
  }
  EXPECT_GT(flipped, 50);
}

TEST(CheckMesh, AConstrainedEdgeNeedNotBeDelaunay)
{
  TestMesh mesh;
  mesh.Points = { { 0.0, 0.0 }, { 4.0, 0.0 }, { 2.0, 1.0 }, { 2.0, -1.0 } };
  mesh.Corners = { 0, 1, 2, 1, 0, 3 };
  mesh.Link();
  ExpectViolation(CheckDelaunay(mesh), "edge");
  for (std::size_t slot = 0; slot < mesh.Corners.size(); ++slot)
  {
    mesh.Constraints[slot] = 0;
  }
  EXPECT_EQ(CheckDelaunay(mesh), "");
}

TEST(CheckMesh, AcceptsHolesAndComponents)
{
  EXPECT_EQ(Check(HoledGrid()), "");
  EXPECT_EQ(Check(TestMesh::Grid(biting::UnitLines(9), biting::UnitLines(9),
              [](std::size_t column, std::size_t) { return column % 3 != 1; })),
    "");
}

/// So many triangles that there are several tasks, each with some of every component.
TEST(CheckMesh, CountsComponentsOnAnyNumberOfThreads)
{
  TestMesh mesh = TestMesh::Grid(biting::UnitLines(300), biting::UnitLines(300),
    [](std::size_t column, std::size_t row)
    { return column % 3 != 1 || (row == 299 && column < 9); });
  for (const int numberOfThreads : { 1, 2, 8 })
  {
    biting::MonitorWithThreads monitor(numberOfThreads);
    biting::MeshCheckInput input{ mesh.Points, mesh.Corners, mesh.Neighbors, mesh.Constraints,
      mesh.Area() };
    EXPECT_EQ(biting::CheckMesh(input, monitor), "");
    input.ExpectedArea += 1.0;
    ExpectViolation(biting::CheckMesh(input, monitor), "the area is");
  }
  mesh.Points.push_back({ 0.0, 0.0 });
  ExpectViolation(Check(mesh), "vertex " + std::to_string(mesh.Points.size() - 1) + " belongs");
}

TEST(CheckMesh, AcceptsPartsThatTouchInVertices)
{
  const TestMesh board = TestMesh::Grid(biting::UnitLines(8), biting::UnitLines(8),
    [](std::size_t column, std::size_t row) { return (column + row) % 2 == 0; });
  EXPECT_EQ(Check(board), "");
  const TestMesh chain = TestMesh::Grid(biting::UnitLines(4), biting::UnitLines(4),
    [](std::size_t column, std::size_t row)
    { return (column != 1 || row != 1) && (column != 2 || row != 2); });
  EXPECT_EQ(Check(chain), "");
}

TEST(CheckMesh, AcceptsTrianglesInAnyOrder)
{
  biting::Dice dice(41);
  TestMesh mesh = TestMesh::Grid(biting::UnitLines(9), biting::UnitLines(9),
    [](std::size_t column, std::size_t row)
    { return column % 4 != 3 && (column != 5 || row != 5); });
  for (std::size_t left = mesh.Corners.size() / 3; left > 1; --left)
  {
    const std::size_t chosen = 3 * (dice.Roll() % left);
    std::swap_ranges(mesh.Corners.begin() + static_cast<std::ptrdiff_t>(chosen),
      mesh.Corners.begin() + static_cast<std::ptrdiff_t>(chosen + 3),
      mesh.Corners.begin() + static_cast<std::ptrdiff_t>(3 * left - 3));
  }
  mesh.Link();
  EXPECT_EQ(Check(mesh), "");
}

TEST(CheckMesh, AcceptsTrianglesOfAnyShape)
{
  for (std::uint64_t seed = 1; seed <= 10; ++seed)
  {
    TestMesh mesh = TestMesh::Random(80, seed);
    EXPECT_EQ(Check(mesh, 1.0), "");
    mesh.Shuffle(200, seed);
    EXPECT_EQ(Check(mesh, 1.0), "");
  }
}

TEST(CheckMesh, AcceptsRoundedBoundariesFarFromTheOrigin)
{
  std::vector<double> lines;
  for (int i = 0; i <= 30; ++i)
  {
    lines.push_back(1e8 + i / 30.0);
  }
  const TestMesh mesh = TestMesh::Grid(lines, lines, [](std::size_t, std::size_t) { return true; });
  EXPECT_EQ(Check(mesh, 1.0), "");
}

TEST(CheckMesh, RefusesArraysOfDifferentSizes)
{
  TestMesh mesh = HoledGrid();
  mesh.Constraints.pop_back();
  ExpectViolation(Check(mesh), "size");
}

TEST(CheckMesh, RefusesIdsOutOfRange)
{
  for (const Id id : { -2, -1, 1000000 })
  {
    TestMesh mesh = HoledGrid();
    const double area = mesh.Area();
    mesh.Corners[10] = id;
    ExpectViolation(Check(mesh, area), "triangle 3 is out of range");
  }
  for (const Id id : { -2, 1000000 })
  {
    TestMesh mesh = HoledGrid();
    mesh.Neighbors[10] = id;
    ExpectViolation(Check(mesh), "triangle 3 is out of range");
  }
}

TEST(CheckMesh, DoesNotLookForVerticesOutOfRangeBeyondAnEdge)
{
  const TestMesh sound = HoledGrid();
  for (std::size_t slot = 0; slot < sound.Corners.size(); ++slot)
  {
    TestMesh mesh = sound;
    mesh.Corners[slot] = 1000000000;
    biting::MeshCheckInput input{ mesh.Points, mesh.Corners, mesh.Neighbors, mesh.Constraints,
      sound.Area() };
    input.IsDelaunay = true;
    ExpectViolation(biting::CheckMesh(input, biting::NoMonitor()),
      "triangle " + std::to_string(slot / 3) + " is out of range");
  }
}

TEST(CheckMesh, RefusesClockwiseTriangles)
{
  TestMesh mesh = HoledGrid();
  std::swap(mesh.Corners[12], mesh.Corners[13]);
  ExpectViolation(Check(mesh), "triangle 4 is not counterclockwise");
}

TEST(CheckMesh, RefusesFlatTriangles)
{
  TestMesh mesh;
  mesh.Points = { { 0.1, 0.1 }, { 0.2, 0.2 }, { 0.3, 0.3 } };
  mesh.Corners = { 0, 1, 2 };
  mesh.Link();
  mesh.Points[2] = mesh.Points[1];
  ExpectViolation(Check(mesh), "triangle 0 is not counterclockwise");
}

TEST(CheckMesh, RefusesAnyNeighborThatIsNotMutual)
{
  const TestMesh sound = HoledGrid();
  for (std::size_t slot = 0; slot < sound.Neighbors.size(); ++slot)
  {
    TestMesh mesh = sound;
    mesh.Neighbors[slot] = (mesh.Neighbors[slot] + 2) % 20;
    EXPECT_NE(Check(mesh), "");
  }
}

TEST(CheckMesh, RefusesAnyLinkThatIsMissingOnOneSide)
{
  const TestMesh sound = HoledGrid();
  for (std::size_t slot = 0; slot < sound.Neighbors.size(); ++slot)
  {
    TestMesh mesh = sound;
    mesh.Neighbors[slot] = NoId;
    mesh.Constraints[slot] = 0;
    EXPECT_EQ(Check(mesh).empty(), sound.Neighbors[slot] == NoId);
  }
}

TEST(CheckMesh, RefusesAConstraintOnOneSideOnly)
{
  TestMesh mesh = HoledGrid();
  mesh.Constraints[SlotWithNeighbor(mesh)] = 5;
  ExpectViolation(Check(mesh), "do not match");
}

TEST(CheckMesh, RefusesABoundaryWithoutConstraint)
{
  TestMesh mesh = HoledGrid();
  mesh.Constraints[SlotWithoutNeighbor(mesh)] = NoId;
  ExpectViolation(Check(mesh), "no constraint covers the boundary");
}

TEST(CheckMesh, RefusesUnusedVertices)
{
  TestMesh mesh = HoledGrid();
  mesh.Points.push_back({ 0.5, 0.5 });
  ExpectViolation(
    Check(mesh), "vertex " + std::to_string(mesh.Points.size() - 1) + " belongs to no triangle");
}

// A second sheet over inner triangles, glued to the first in one inner vertex.
TEST(CheckMesh, RefusesTwoSheetsThatShareAnInnerVertex)
{
  TestMesh mesh = TestMesh::Grid(
    biting::UnitLines(4), biting::UnitLines(4), [](std::size_t, std::size_t) { return true; });
  const std::size_t size = mesh.Points.size();
  const std::vector<Id> first = mesh.Corners;
  Id center = NoId;
  for (std::size_t i = 0; i < size; ++i)
  {
    const bool isCenter = mesh.Points[i] == Point2{ 2, 2 };
    center = isCenter ? static_cast<Id>(i) : center;
    mesh.Points.push_back(mesh.Points[i]);
  }
  for (const Id corner : first)
  {
    mesh.Corners.push_back(corner == center ? corner : corner + static_cast<Id>(size));
  }
  mesh.DropUnusedPoints();
  mesh.Link();
  ExpectViolation(Check(mesh), "Euler");
}

TEST(CheckMesh, RefusesAWrongArea)
{
  const TestMesh mesh = HoledGrid();
  const double area = mesh.Area();
  ExpectViolation(Check(mesh, area * (1.0 + 1e-9)), "the area is");
  ExpectViolation(Check(mesh, area * (1.0 - 1e-9)), "the area is");
  ExpectViolation(Check(mesh, std::nan("")), "the area is");
}

TEST(CheckMesh, DoesNotDependOnTheUnitOfLength)
{
  for (const int exponent : { -100, -30, 30, 100 })
  {
    TestMesh mesh = HoledGrid();
    for (Point2& p : mesh.Points)
    {
      p = std::ldexp(1.0, exponent) * p;
    }
    EXPECT_EQ(Check(mesh), "");
    ExpectViolation(Check(mesh, mesh.Area() * (1.0 + 1e-9)), "the area is");
  }
}

} // namespace
