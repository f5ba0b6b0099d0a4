// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Delaunay/ConstrainedMesh.h"

#include "Scene.h"

#include <gtest/gtest.h>

#include <utility> // for move

namespace biting
{

namespace
{

/// The triangulation of the scene, its last points inserted late.
TriangulationResult TriangulateLate(const Scene& scene, std::size_t numberOfLate, double phi = 1.0)
{
  SilentMonitor monitor;
  Pulse pulse(monitor);
  const std::vector<Point2> early(
    scene.Points.begin(), scene.Points.end() - static_cast<std::ptrdiff_t>(numberOfLate));
  ConstrainedMesh made = MakeConstrainedMesh(early, scene.Edges, phi, pulse);
  EXPECT_TRUE(made.IsWhole());
  InsertLate(scene.Points, phi, made, pulse);
  return FinishTriangulation(std::move(made), monitor);
}

/// A square, halved by an interface, with `count` whole points.
Scene HalvedSquare(int count, int bound, std::uint64_t seed)
{
  Scene scene;
  scene.AddSquare(0.0, bound);
  Dice dice(seed);
  scene.AddEdge(scene.AddPoint(1.0, bound / 2), scene.AddPoint(bound - 1.0, bound / 2), false);
  for (int i = 0; i < count; ++i)
  {
    scene.AddPoint(dice.Below(bound - 1) + 1, dice.Below(bound - 1) + 1);
  }
  return scene;
}

void ExpectSameTriangles(const TriangulationResult& late, const Scene& scene)
{
  const TriangulationResult early = scene.Triangulate();
  EXPECT_EQ(late.Mesh.NumberOfTriangles(), early.Mesh.NumberOfTriangles());
  EXPECT_EQ(CheckTriangulation(scene.Points, late.Mesh, {}), "");
}

} // namespace

TEST(InsertLate, GivesTheTriangulationOfAllPoints)
{
  for (std::uint64_t seed = 0; seed < 20; ++seed)
  {
    // So many places that circles through four points are rare.
    Scene scene = HalvedSquare(300, 1 << 26, seed);
    const TriangulationResult late = TriangulateLate(scene, 60);
    EXPECT_EQ(Triangles(late.Mesh), Triangles(scene.Triangulate().Mesh));
    ExpectSameTriangles(late, scene);
  }
}

TEST(InsertLate, DividesConstraintsAndSharesVerticesAmongWholePoints)
{
  for (std::uint64_t seed = 0; seed < 50; ++seed)
  {
    const Scene scene = HalvedSquare(200, 20, seed);
    const TriangulationResult late = TriangulateLate(scene, 150);
    ExpectSameTriangles(late, scene);
    EXPECT_EQ(Triangles(late.Mesh).size(), static_cast<std::size_t>(late.Mesh.NumberOfTriangles()));
  }
}

TEST(InsertLate, WorksOnTheBoundaryAndBeyondTheHull)
{
  Scene scene;
  scene.AddSquare(0.0, 4.0);
  scene.AddPoint(2.0, 1.0);
  scene.AddPoint(2.0, 0.0);
  scene.AddPoint(4.0, 3.0);
  scene.AddPoint(6.0, 3.0);
  const TriangulationResult late = TriangulateLate(scene, 3);
  EXPECT_EQ(CheckTriangulation(scene.Points, late.Mesh, {}), "");
  EXPECT_EQ(late.Mesh.NumberOfTriangles(), 6);
}

TEST(InsertLate, KeepsPhi)
{
  for (std::uint64_t seed = 0; seed < 10; ++seed)
  {
    const Scene scene = HalvedSquare(300, 1 << 20, seed);
    const TriangulationResult late = TriangulateLate(scene, 100, 0.5);
    EXPECT_EQ(CheckTriangulation(scene.Points, late.Mesh, { 0.5 }), "");
    EXPECT_EQ(late.Mesh.NumberOfTriangles(), scene.Triangulate().Mesh.NumberOfTriangles());
  }
}

} // namespace biting
