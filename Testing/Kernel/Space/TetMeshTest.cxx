// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Base/Pulse.h"
#include "Delaunay/SpatialOrder.h"
#include "Space/Delaunay/SpaceTriangulation.h"
#include "SpacePoints.h"

#include <gtest/gtest.h>

#include <cmath>  // for abs
#include <string> // for violations

namespace
{

using namespace space_test;
using biting::CheckTetMesh;
using biting::SpaceTriangulation;

SpaceTriangulation Triangulate(
  const std::vector<Point3>& points, const std::vector<double>& weights = {})
{
  return biting::TriangulateSpace(points, weights, biting::NoMonitor());
}

std::vector<Point3> PointsOf(PointKind kind, int count)
{
  SpaceDice dice(17);
  std::vector<Point3> points;
  points.reserve(static_cast<std::size_t>(count));
  for (int k = 0; k < count; ++k)
  {
    points.push_back(RandomPoint(kind, dice));
  }
  return points;
}

TetMesh OneCube()
{
  std::vector<Point3> points;
  for (int k = 0; k < 8; ++k)
  {
    points.push_back({ k & 1 ? 1.0 : 0.0, k & 2 ? 1.0 : 0.0, k & 4 ? 1.0 : 0.0 });
  }
  return Triangulate(points).Mesh;
}

Id FirstTetrahedron(const TetMesh& mesh)
{
  Id cell = 0;
  while (!mesh.IsTetrahedron(cell))
  {
    ++cell;
  }
  return cell;
}

double VolumeOf(const TetMesh& mesh)
{
  double volume = 0.0;
  for (Id cell = 0; cell < mesh.NumberOfSlots(); ++cell)
  {
    if (mesh.IsTetrahedron(cell))
    {
      const Id* c = &mesh.Corners[TetMesh::Index(4 * cell)];
      const Point3& a = mesh.PointAt(c[0]);
      volume +=
        Dot(mesh.PointAt(c[1]) - a, Cross(mesh.PointAt(c[2]) - a, mesh.PointAt(c[3]) - a)) / 6.0;
    }
  }
  return volume;
}

} // namespace

TEST(CheckTetMesh, FindsWhatIsWrong)
{
  const TetMesh good = OneCube();
  EXPECT_EQ(CheckTetMesh(good, true), "");
  const auto first = TetMesh::Index(4 * FirstTetrahedron(good));
  const auto violation = [](TetMesh mesh) { return CheckTetMesh(mesh, true); };
  TetMesh bad = good;
  std::swap(bad.Corners[first], bad.Corners[first + 1]);
  EXPECT_NE(violation(bad), "");
  bad = good;
  std::swap(bad.Twins[first], bad.Twins[first + 1]);
  EXPECT_NE(violation(bad), "");
  bad = good;
  bad.Corners[first] = 77;
  EXPECT_NE(violation(bad), "");
  bad = good;
  bad.VertexCells[0] = 1000;
  EXPECT_NE(violation(bad), "");
  bad = good;
  bad.NumberOfFree = 0;
  bad.FirstFree = NoId;
  bad.Corners[first + 3] = TetMesh::Free;
  EXPECT_NE(violation(bad), "");
  bad = good;
  bad.Points[7] = { 0.4, 0.4, 0.4 }; // not convex, and no cell is regular any more
  EXPECT_NE(violation(bad), "");
}

TEST(TriangulateSpace, IsRegularForAllKindsOfPoints)
{
  for (int kind = 0; kind < NumberOfPointKinds; ++kind)
  {
    SCOPED_TRACE(kind);
    const std::vector<Point3> points = PointsOf(static_cast<PointKind>(kind), 1200);
    const SpaceTriangulation result = Triangulate(points);
    EXPECT_EQ(CheckTetMesh(result.Mesh, true), "");
    for (std::size_t v = 0; v < result.Order.size(); ++v)
    {
      EXPECT_EQ(result.Mesh.Points[v], points[TetMesh::Index(result.Order[v])]);
    }
    if (result.Dimension == 3)
    {
      std::size_t vertices = 0;
      for (const Id cell : result.Mesh.VertexCells)
      {
        vertices += cell == NoId ? 0 : 1;
      }
      EXPECT_EQ(vertices + result.Duplicates.size(), points.size());
    }
  }
}

TEST(TriangulateSpace, DependsNeitherOnTheOrderOfPointsNorOnScale)
{
  for (const PointKind kind : { PointKind::Lattice, PointKind::Sphere, PointKind::Layers })
  {
    std::vector<Point3> points = PointsOf(kind, 500);
    const std::vector<PlacedCell> cells = PlacedCells(Triangulate(points).Mesh);
    SpaceDice dice(3);
    dice.Shuffle(points);
    EXPECT_EQ(PlacedCells(Triangulate(points).Mesh), cells);
    for (Point3& p : points)
    {
      p = 0x1p-40 * p;
    }
    std::vector<PlacedCell> scaled = PlacedCells(Triangulate(points).Mesh);
    for (PlacedCell& cell : scaled)
    {
      for (std::array<double, 3>& place : cell)
      {
        place = { 0x1p40 * place[0], 0x1p40 * place[1], 0x1p40 * place[2] };
      }
    }
    EXPECT_EQ(scaled, cells);
  }
}

TEST(TriangulateSpace, TellsDuplicatesAndTheVertexAtTheirPlace)
{
  std::vector<Point3> points = PointsOf(PointKind::Uniform, 300);
  points.insert(points.end(), points.begin(), points.begin() + 20);
  const SpaceTriangulation result = Triangulate(points);
  EXPECT_EQ(result.Duplicates.size(), 20u);
  for (const biting::PointPair& pair : result.Duplicates)
  {
    EXPECT_EQ(std::abs(pair.Point - pair.Of), 300);
  }
}

TEST(TriangulateSpace, KnowsTheDimensionOfWhatHasNoVolume)
{
  EXPECT_EQ(Triangulate({}).Dimension, -1);
  EXPECT_EQ(Triangulate(std::vector<Point3>(5, Point3{ 1, 2, 3 })).Dimension, 0);
  EXPECT_EQ(Triangulate(PointsOf(PointKind::Line, 50)).Dimension, 1);
  EXPECT_EQ(Triangulate(PointsOf(PointKind::Plane, 50)).Dimension, 2);
  EXPECT_EQ(Triangulate(PointsOf(PointKind::Plane, 50)).Mesh.NumberOfCells(), 0);
  EXPECT_EQ(Triangulate(PointsOf(PointKind::Uniform, 50)).Dimension, 3);
}

TEST(TriangulateSpace, FillsTheHullOfALattice)
{
  std::vector<Point3> points;
  for (int k = 0; k < 1000; ++k)
  {
    points.push_back({ k % 10 * 1.0, k / 10 % 10 * 1.0, k / 100 * 1.0 });
  }
  const SpaceTriangulation result = Triangulate(points);
  EXPECT_EQ(CheckTetMesh(result.Mesh, true), "");
  EXPECT_NEAR(VolumeOf(result.Mesh), 729.0, 1e-9);
}

// Flat hull cells: their spheres are as large as they like, on either side. Which side of a hull's
// triangle is outside is known by the ghost alone, and is right.
TEST(TriangulateSpace, KnowsTheOutsideOfNearlyFlatHulls)
{
  SpaceDice dice(5);
  std::vector<Point3> points;
  for (int k = 0; k < 600; ++k)
  {
    points.push_back({ dice.Unit(), dice.Unit(), 1e-14 * dice.Unit() });
  }
  const TetMesh mesh = Triangulate(points).Mesh;
  EXPECT_EQ(CheckTetMesh(mesh, true), "");
  for (Id cell = 0; cell < mesh.NumberOfSlots(); ++cell)
  {
    const Id* c = &mesh.Corners[TetMesh::Index(4 * cell)];
    for (std::size_t v = 0; v < 30 && mesh.IsGhost(cell); ++v)
    {
      EXPECT_LE(biting::Orient3D(
                  mesh.PointAt(c[0]), mesh.PointAt(c[1]), mesh.PointAt(c[2]), mesh.Points[v]),
        0);
    }
  }
}

TEST(TriangulateSpace, StopsWhereItIsAsked)
{
  class Stopping : public biting::SilentMonitor
  {
  public:
    bool Advance(double) override { return --this->Left > 0; }
    int Left = 3;
  };
  Stopping monitor;
  EXPECT_TRUE(
    biting::TriangulateSpace(PointsOf(PointKind::Uniform, 20000), {}, monitor).WasAborted);
}

TEST(RegularTriangulation, LabelsOfNewCellsAreNone)
{
  biting::RegularTriangulation triangulation;
  const std::vector<Point3> points = PointsOf(PointKind::Uniform, 60);
  for (std::size_t k = 0; k < 50; ++k)
  {
    triangulation.Insert(points[k]);
  }
  std::vector<Id>& labels = triangulation.KeepLabels();
  for (std::size_t k = 0; k < labels.size(); ++k)
  {
    labels[k] = static_cast<Id>(k);
  }
  const TetMesh before = triangulation.Mesh();
  triangulation.Insert(points[50]);
  triangulation.Remove(7);
  const TetMesh& after = triangulation.Mesh();
  ASSERT_EQ(after.Labels.size(), TetMesh::Index(after.NumberOfSlots()));
  for (std::size_t k = 0; k < after.Labels.size(); ++k)
  {
    if (after.Labels[k] != NoId)
    {
      EXPECT_EQ(after.Labels[k], static_cast<Id>(k));
      EXPECT_TRUE(std::equal(after.Corners.begin() + static_cast<Id>(4 * k),
        after.Corners.begin() + static_cast<Id>(4 * k + 4),
        before.Corners.begin() + static_cast<Id>(4 * k)));
    }
  }
}

TEST(RegularTriangulation, HiddenPointsComeBack)
{
  biting::RegularTriangulation triangulation(true);
  for (int k = 0; k < 8; ++k)
  {
    triangulation.Insert({ k & 1 ? 1.0 : 0.0, k & 2 ? 1.0 : 0.0, k & 4 ? 1.0 : 0.0 });
  }
  const Id heavy = triangulation.Insert({ 0.5, 0.5, 0.5 }, 0.7).Vertex;
  const biting::PointInsertion light = triangulation.Insert({ 0.5, 0.5, 0.25 });
  EXPECT_EQ(light.What, biting::PointOutcome::Hidden);
  triangulation.Remove(heavy);
  EXPECT_TRUE(triangulation.HiddenVertices().empty());
  EXPECT_NE(triangulation.Mesh().VertexCells[TetMesh::Index(light.Vertex)], NoId);
  EXPECT_EQ(CheckTetMesh(triangulation.Mesh(), true), "");
}

TEST(SpatialOrderOfSpace, HasStepsOfTheLengthOfTheSpacing)
{
  const std::vector<Point3> points = PointsOf(PointKind::Uniform, 8000);
  biting::Pulse pulse(biting::NoMonitor());
  std::vector<Id> order = biting::SpatialOrder(points, pulse);
  double sum = 0.0;
  for (std::size_t k = order.size() / 2; k + 1 < order.size(); ++k) // of the last round
  {
    sum += Distance(points[TetMesh::Index(order[k])], points[TetMesh::Index(order[k + 1])]);
  }
  EXPECT_LT(sum / (0.5 * 8000), 1.5 / 20.0);
  std::sort(order.begin(), order.end());
  for (std::size_t k = 0; k < order.size(); ++k)
  {
    EXPECT_EQ(order[k], static_cast<Id>(k));
  }
}
