// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Quality/NearestNeighbors.h"
#include "Base/Numbers.h"

#include "../Support/TestThreads.h"
#include "TestMesh.h"

#include <gtest/gtest.h>

#include <algorithm> // for min
#include <cmath>     // for sqrt, ldexp, cos

namespace
{

using biting::Infinity;
using biting::Point2;
using biting::TestMesh;

std::vector<double> DistancesOfAllPairs(const std::vector<Point2>& points)
{
  std::vector<double> distances(points.size(), Infinity);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    for (std::size_t k = 0; k < points.size(); ++k)
    {
      distances[i] = i == k ? distances[i] : std::min(distances[i], Distance(points[i], points[k]));
    }
  }
  return distances;
}

std::vector<double> Distances(const TestMesh& mesh)
{
  return biting::NearestNeighborDistances(mesh.Points, mesh.Corners, mesh.Neighbors);
}

void ExpectTruth(const TestMesh& mesh)
{
  EXPECT_EQ(Distances(mesh), DistancesOfAllPairs(mesh.Points));
}

bool IsKeptAlways(std::size_t, std::size_t)
{
  return true;
}

// Two halves with a slit of the given height, joined in the last of ten columns; the upper half is
// shifted, so that its vertices are not above those of the lower half.
TestMesh SlitMesh(double height, double shift)
{
  std::vector<double> yLines{ 0, 1, 2, 3 };
  for (const double y : { 0.0, 1.0, 2.0, 3.0 })
  {
    yLines.push_back(3 + height + y);
  }
  TestMesh mesh = TestMesh::Grid(biting::UnitLines(10), yLines,
    [](std::size_t column, std::size_t row) { return row != 3 || column == 9; });
  for (Point2& p : mesh.Points)
  {
    p.X += p.Y > 3.0 && p.X < 9.0 ? shift : 0.0;
  }
  return mesh;
}

// Long triangles around one vertex above a slit, below which vertices lie close together.
TestMesh TeethBelowALongEdge(double height)
{
  TestMesh mesh;
  mesh.Points = { { 0, 0 }, { 10, 0 }, { 5, 9 }, { 5, 0.1 } };
  mesh.Corners = { 0, 1, 3, 1, 2, 3, 2, 0, 3 };
  for (int i = 0; i < 20; ++i)
  {
    const biting::Id first = static_cast<biting::Id>(mesh.Points.size());
    const double x = 0.5 * i;
    mesh.Points.insert(
      mesh.Points.end(), { { x, -height }, { x + 0.05, -height - 1 }, { x + 0.1, -height } });
    mesh.Corners.insert(mesh.Corners.end(), { first, first + 1, first + 2 });
  }
  mesh.Link();
  return mesh;
}

TEST(NearestNeighbors, AreFoundInAGrid)
{
  ExpectTruth(TestMesh::Grid(biting::UnitLines(12), biting::UnitLines(7), IsKeptAlways));
}

TEST(NearestNeighbors, AreFoundInJitteredGrids)
{
  for (std::uint64_t seed = 1; seed <= 5; ++seed)
  {
    TestMesh mesh = TestMesh::Grid(biting::UnitLines(12), biting::UnitLines(12), IsKeptAlways);
    mesh.Jitter(0.45, seed);
    ExpectTruth(mesh);
    mesh.MakeDelaunay();
    ExpectTruth(mesh);
  }
}

/// So many triangles that there are several tasks.
TEST(NearestNeighbors, AreTheSameForAnyNumberOfThreads)
{
  TestMesh mesh = TestMesh::Grid(biting::UnitLines(300), biting::UnitLines(200), IsKeptAlways);
  for (std::size_t k = 0; k < mesh.Points.size(); ++k)
  {
    mesh.Points[k].X += 0.004 * static_cast<double>(7919 * k % 101);
    mesh.Points[k].Y += 0.004 * static_cast<double>(5413 * k % 97);
  }
  const std::vector<double> alone = Distances(mesh);
  EXPECT_EQ(alone, biting::NearestNeighborDistances(mesh.Points, biting::NoMonitor()));
  for (const int numberOfThreads : { 2, 3, 8 })
  {
    biting::MonitorWithThreads monitor(numberOfThreads);
    EXPECT_EQ(
      biting::NearestNeighborDistances(mesh.Points, mesh.Corners, mesh.Neighbors, monitor), alone);
  }
}

TEST(NearestNeighbors, AreFoundAcrossSlitsOfAnyHeight)
{
  for (const double shift : { 0.0, 0.3, 0.5 })
  {
    for (int exponent = -40; exponent <= 2; ++exponent)
    {
      ExpectTruth(SlitMesh(std::ldexp(1.0, exponent), shift));
    }
  }
}

TEST(NearestNeighbors, AreFoundBehindALongBoundaryEdge)
{
  for (const double height : { 1e-9, 0.01, 0.2, 1.0, 7.0 })
  {
    ExpectTruth(TeethBelowALongEdge(height));
  }
}

TEST(NearestNeighbors, AreFoundInTheDelaunayTriangulationOfRandomPoints)
{
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
  {
    TestMesh mesh = TestMesh::Random(60, seed);
    mesh.MakeDelaunay();
    ExpectTruth(mesh);
  }
}

TEST(NearestNeighbors, AreFoundInTrianglesOfAnyShape)
{
  for (std::uint64_t seed = 1; seed <= 40; ++seed)
  {
    TestMesh mesh = TestMesh::Random(60, seed);
    ExpectTruth(mesh);
    mesh.Shuffle(100, seed);
    ExpectTruth(mesh);
  }
}

TEST(NearestNeighbors, AreFoundInFlippedDelaunayTriangulations)
{
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
  {
    TestMesh mesh = TestMesh::Random(60, seed);
    mesh.MakeDelaunay();
    mesh.Shuffle(15, seed);
    ExpectTruth(mesh);
  }
}

TEST(NearestNeighbors, AreFoundAcrossHolesAndBays)
{
  for (std::uint64_t seed = 1; seed <= 8; ++seed)
  {
    TestMesh mesh = TestMesh::Random(80, seed);
    mesh.MakeDelaunay();
    mesh.Keep(
      [](const Point2& p) {
        return Distance(p, { 0.4, 0.5 }) > 0.15 && std::abs(p.X - 0.8) > 0.05 + 0.02 * p.Y;
      });
    ExpectTruth(mesh);
  }
}

TEST(NearestNeighbors, AreFoundWherePointsAreStretchedToNeedles)
{
  for (const double stretch : { 1e-3, 1e-6, 1e-12 })
  {
    TestMesh mesh = TestMesh::Random(60, 5);
    mesh.Shuffle(100, 6);
    for (Point2& p : mesh.Points)
    {
      p.Y *= stretch;
    }
    ExpectTruth(mesh);
  }
}

// Vertices close to one circle: a disc about one of them reaches beyond several edges.
TEST(NearestNeighbors, AreFoundAmongPointsNearACircle)
{
  biting::Dice dice(3);
  for (int trial = 0; trial < 20; ++trial)
  {
    TestMesh mesh;
    mesh.Points = { { -9, -9 }, { 9, -9 }, { 9, 9 }, { -9, 9 } };
    mesh.Corners = { 0, 1, 2, 0, 2, 3 };
    for (int i = 0; i < 30; ++i)
    {
      const double angle = dice.Between(0.0, 6.28);
      const double radius = dice.Between(1.0, 1.001);
      mesh.Insert({ radius * std::cos(angle), radius * std::sin(angle) });
    }
    mesh.Link();
    ExpectTruth(mesh);
    mesh.MakeDelaunay();
    ExpectTruth(mesh);
  }
}

TEST(NearestNeighbors, AreFoundWhereSpacingVariesByAMillion)
{
  std::vector<double> lines{ 0.0 };
  for (int i = 0; i < 20; ++i)
  {
    lines.push_back(std::ldexp(1.0, -20 + i));
  }
  TestMesh mesh = TestMesh::Grid(lines, lines,
    [](std::size_t column, std::size_t row) { return column % 5 != 2 || row % 7 != 3; });
  ExpectTruth(mesh);
}

TEST(NearestNeighbors, AreAsFarAsBeforeInTheUnitsOfAScaledMesh)
{
  TestMesh mesh = TestMesh::Random(60, 9);
  std::vector<double> expected = Distances(mesh);
  for (Point2& p : mesh.Points)
  {
    p = 0x1p-60 * p;
  }
  for (double& distance : expected)
  {
    distance *= 0x1p-60;
  }
  EXPECT_EQ(Distances(mesh), expected);
}

TEST(NearestNeighbors, OfVerticesWithoutTriangleAreFoundToo)
{
  TestMesh mesh = TestMesh::Random(60, 11);
  mesh.Points.push_back({ 0.51, 0.52 });
  mesh.Points.push_back({ 7.0, 7.0 });
  ExpectTruth(mesh);
}

TEST(NearestNeighbors, CoincideWhereVerticesDo)
{
  TestMesh mesh;
  mesh.Points = { { 0, 0 }, { 1, 0 }, { 0, 1 }, { 0, 0 }, { -1, 0 }, { 0, -1 } };
  mesh.Corners = { 0, 1, 2, 3, 4, 5 };
  mesh.Link();
  ExpectTruth(mesh);
}

TEST(NearestNeighbors, AreNowhereForASingleVertex)
{
  EXPECT_EQ(
    biting::NearestNeighborDistances({ { 3, 4 } }, {}, {}), std::vector<double>{ Infinity });
  EXPECT_TRUE(biting::NearestNeighborDistances({}, {}, {}).empty());
}

TEST(NearestNeighbors, OfPointsAloneAreTheSame)
{
  TestMesh mesh = TestMesh::Random(400, 31);
  mesh.Points.push_back(mesh.Points[17]);
  biting::SilentMonitor monitor;
  const std::vector<double> distances = biting::NearestNeighborDistances(mesh.Points, monitor);
  EXPECT_EQ(distances, DistancesOfAllPairs(mesh.Points));
  EXPECT_EQ(distances[17], 0.0);
}

} // namespace
