// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Delaunay/Scene.h"

#include <gtest/gtest.h>

namespace
{

using namespace biting;

Triangulation CheckedMesh(const Scene& scene)
{
  const TriangulationResult result = scene.Triangulate();
  EXPECT_EQ(CheckTriangulation(scene.Points, result.Mesh, {}), "");
  EXPECT_TRUE(result.Conflicts.empty());
  return result.Mesh;
}

double DoubledArea(const Scene& scene)
{
  return biting::DoubledArea(scene.Points, CheckedMesh(scene));
}

Id NumberOfRegions(const Triangulation& mesh)
{
  return mesh.Regions.empty() ? 0 : *std::max_element(mesh.Regions.begin(), mesh.Regions.end()) + 1;
}

} // namespace

TEST(TakeInside, CountsNestedLoopsEvenOdd)
{
  Scene scene;
  double area = 0.0;
  for (int depth = 0; depth < 5; ++depth)
  {
    const double low = depth;
    const double high = 20.0 - depth;
    scene.AddSquare(low, high);
    area += (depth % 2 == 0 ? 1.0 : -1.0) * (high - low) * (high - low);
    EXPECT_EQ(DoubledArea(scene), 2.0 * area);
  }
  EXPECT_EQ(NumberOfRegions(CheckedMesh(scene)), 3);
}

TEST(TakeInside, DoesNotDependOnTheDirectionOfLoops)
{
  Scene scene;
  scene.AddSquare(0.0, 20.0);
  scene.AddLoop({ { 5.0, 5.0 }, { 5.0, 15.0 }, { 15.0, 15.0 }, { 15.0, 5.0 } });
  EXPECT_EQ(DoubledArea(scene), 600.0);
  std::swap(scene.Edges.Starts, scene.Edges.Ends);
  EXPECT_EQ(DoubledArea(scene), 600.0);
}

TEST(TakeInside, StaysInsideAcrossADoubleBoundary)
{
  Scene scene;
  scene.AddLoop({ { 0.0, 0.0 }, { 1.0, 0.0 }, { 1.0, 1.0 }, { 0.0, 1.0 } });
  const Id low = scene.AddPoint(2.0, 0.0);
  const Id high = scene.AddPoint(2.0, 1.0);
  scene.AddEdge(1, low, true);
  scene.AddEdge(low, high, true);
  scene.AddEdge(high, 2, true);
  scene.AddEdge(2, 1, true);
  const Triangulation mesh = CheckedMesh(scene);
  EXPECT_EQ(DoubledArea(scene), 4.0);
  EXPECT_EQ(NumberOfRegions(mesh), 2);
  EXPECT_EQ(DirectedEdges(mesh).at({ 1, 2 }), 1);
}

TEST(TakeInside, StaysOutsideAcrossADoubleBoundary)
{
  Scene scene = RandomScene(30, 20, 1);
  const double area = DoubledArea(scene);
  const Id first = scene.AddPoint(30.0, 3.0);
  const Id second = scene.AddPoint(40.0, 3.0);
  scene.AddEdge(first, second, true);
  scene.AddEdge(second, first, true);
  EXPECT_EQ(DoubledArea(scene), area);
}

TEST(TakeInside, GoesAroundADanglingInterface)
{
  Scene scene;
  scene.AddSquare(0.0, 10.0);
  const Id first = scene.AddPoint(3.0, 4.0);
  const Id second = scene.AddPoint(7.0, 5.0);
  const Id crack = scene.AddEdge(first, second, false);
  const Id spike = scene.AddEdge(0, first, false);
  const Triangulation mesh = CheckedMesh(scene);
  const EdgeMap edges = DirectedEdges(mesh);
  EXPECT_EQ(NumberOfRegions(mesh), 1);
  EXPECT_EQ(DoubledArea(scene), 200.0);
  EXPECT_EQ(edges.at({ first, second }), crack);
  EXPECT_EQ(edges.at({ second, first }), crack);
  EXPECT_EQ(edges.at({ 0, first }), spike);
}

TEST(TakeInside, LeavesOutHolesThatShareVertices)
{
  Scene scene;
  scene.AddSquare(0.0, 10.0);
  const Id shared = scene.AddLoop({ { 5.0, 5.0 }, { 2.0, 6.0 }, { 2.0, 4.0 } });
  const Id high = scene.AddPoint(8.0, 6.0);
  const Id low = scene.AddPoint(8.0, 4.0);
  scene.AddEdge(shared, high, true);
  scene.AddEdge(high, low, true);
  scene.AddEdge(low, shared, true);
  EXPECT_EQ(DoubledArea(scene), 200.0 - 12.0);
  EXPECT_EQ(NumberOfRegions(CheckedMesh(scene)), 1);
}

TEST(TakeInside, LeavesOutAHoleThatTouchesTheBoundary)
{
  Scene scene;
  scene.AddSquare(0.0, 10.0);
  const Id first = scene.AddPoint(4.0, 2.0);
  const Id second = scene.AddPoint(2.0, 4.0);
  scene.AddEdge(0, first, true);
  scene.AddEdge(first, second, true);
  scene.AddEdge(second, 0, true);
  EXPECT_EQ(DoubledArea(scene), 200.0 - 12.0);
}

TEST(TakeInside, KeepsSeveralDomainsApart)
{
  Scene scene;
  for (int i = 0; i < 50; ++i)
  {
    scene.AddSquare(3.0 * i, 3.0 * i + 2.0);
  }
  const Triangulation mesh = CheckedMesh(scene);
  EXPECT_EQ(DoubledArea(scene), 50.0 * 8.0);
  EXPECT_EQ(NumberOfRegions(mesh), 50);
  for (Id t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    EXPECT_EQ(mesh.Regions[t], mesh.Corners[3 * t] / 4);
  }
}

TEST(TakeInside, NumbersRegionsByTheSmallestConstraintOnTheirBorders)
{
  Scene scene;
  scene.AddSquare(20.0, 30.0);
  scene.AddSquare(0.0, 10.0);
  scene.AddEdge(4, 6, false);
  const Triangulation mesh = CheckedMesh(scene);
  EXPECT_EQ(NumberOfRegions(mesh), 3);
  EXPECT_EQ(RegionAt(scene, mesh, { 25.0, 26.0 }), 0);
  EXPECT_EQ(RegionAt(scene, mesh, { 6.0, 1.0 }), 1);
  EXPECT_EQ(RegionAt(scene, mesh, { 1.0, 6.0 }), 2);
}

TEST(TakeInside, NumbersTheLeftOfAConstraintBeforeItsRightAndItsStartBeforeItsEnd)
{
  Scene scene;
  const std::vector<Point2> corners{ { 0.0, 0.0 }, { 4.0, 0.0 }, { 8.0, 0.0 }, { 8.0, 8.0 },
    { 4.0, 8.0 }, { 0.0, 8.0 }, { 8.0, 4.0 }, { 0.0, 4.0 } };
  scene.Points = corners;
  scene.AddEdge(6, 7, false);
  scene.AddEdge(1, 4, false);
  scene.AddPoint(4.0, 4.0);
  scene.AddEdge(0, 2, true);
  scene.AddEdge(2, 3, true);
  scene.AddEdge(3, 5, true);
  scene.AddEdge(5, 0, true);
  const Triangulation mesh = CheckedMesh(scene);
  EXPECT_EQ(NumberOfRegions(mesh), 4);
  EXPECT_EQ(RegionAt(scene, mesh, { 6.0, 1.0 }), 0);
  EXPECT_EQ(RegionAt(scene, mesh, { 6.0, 7.0 }), 1);
  EXPECT_EQ(RegionAt(scene, mesh, { 1.0, 2.0 }), 2);
  EXPECT_EQ(RegionAt(scene, mesh, { 1.0, 7.0 }), 3);
}

TEST(TakeInside, OrdersTrianglesByRegionsAndWithinByTheirLastCorners)
{
  Scene scene = RandomScene(20000, 1 << 20, 3);
  scene.AddEdge(0, 2, false);
  const Triangulation mesh = CheckedMesh(scene);
  EXPECT_EQ(NumberOfRegions(mesh), 2);
  const auto placeOf = [&mesh](Id t)
  {
    const Id* corners = &mesh.Corners[3 * t];
    return std::make_pair(mesh.Regions[t], std::max({ corners[0], corners[1], corners[2] }));
  };
  for (Id t = 1; t < mesh.NumberOfTriangles(); ++t)
  {
    EXPECT_LE(placeOf(t - 1), placeOf(t));
  }
}
