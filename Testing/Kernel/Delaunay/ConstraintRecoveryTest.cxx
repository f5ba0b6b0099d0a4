// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Delaunay/ConstrainedMesh.h"

#include "Delaunay/Scene.h"

#include <gtest/gtest.h>

#include <algorithm> // for count
#include <set>       // for those that cross

namespace
{

using namespace biting;

void ExpectAllCovered(const Scene& scene, const Triangulation& mesh, double phi = 1.0)
{
  EXPECT_EQ(CheckTriangulation(scene.Points, mesh, { phi }), "");
  const EdgeMap edges = DirectedEdges(mesh);
  for (std::size_t c = 0; c < scene.Edges.Starts.size(); ++c)
  {
    EXPECT_TRUE(IsCovered(scene, edges, c)) << "constraint " << c;
  }
}

bool CrossesNone(const Scene& scene, Id start, Id end)
{
  for (std::size_t c = 0; c < scene.Edges.Starts.size(); ++c)
  {
    if (Meet(scene.Points[start], scene.Points[end], scene.Points[scene.Edges.Starts[c]],
          scene.Points[scene.Edges.Ends[c]]) == Meeting::Crossing)
    {
      return false;
    }
  }
  return true;
}

std::set<Id> CrossingConstraints(const Scene& scene)
{
  const ConstraintEdges& edges = scene.Edges;
  const auto count = static_cast<Id>(edges.Starts.size());
  const auto cross = [&scene, &edges](Id a, Id b)
  {
    return Meet(scene.Points[edges.Starts[a]], scene.Points[edges.Ends[a]],
             scene.Points[edges.Starts[b]], scene.Points[edges.Ends[b]]) == Meeting::Crossing;
  };
  std::set<Id> crossing;
  for (Id a = 0; a < count; ++a)
  {
    for (Id b = a + 1; b < count; ++b)
    {
      if (cross(a, b))
      {
        crossing.insert({ a, b });
      }
    }
  }
  return crossing;
}

/// A square with random points and as many random interfaces as `tries` give without crossings.
Scene TangledScene(int count, int size, int tries, std::uint64_t seed)
{
  Scene scene = RandomScene(count, size, seed);
  Dice dice(seed + 1000);
  for (int i = 0; i < tries; ++i)
  {
    const Id start = dice.Below(count + 4);
    const Id end = dice.Below(count + 4);
    if (start != end && CrossesNone(scene, start, end))
    {
      scene.AddEdge(start, end, false);
    }
  }
  return scene;
}

/// A square with an interface from side to side that has `count` points on both sides, at heights
/// that the function gives.
Scene CrossedScene(int count, double (*height)(double))
{
  Scene scene;
  scene.AddSquare(-2.0, 2.0);
  scene.AddEdge(scene.AddPoint(-1.5, 0.0), scene.AddPoint(1.5, 0.0), false);
  for (int i = 0; i < count; ++i)
  {
    const double x = -1.0 + 2.0 * i / count;
    scene.AddPoint(x, height(x));
    scene.AddPoint(x + 0.5 / count, -height(x));
  }
  return scene;
}

} // namespace

TEST(RecoverConstraints, KeepsATangleOfInterfaces)
{
  for (std::uint64_t seed = 0; seed < 60; ++seed)
  {
    const Scene scene = TangledScene(80, 1000, 60, seed);
    const TriangulationResult result = scene.Triangulate();
    ExpectAllCovered(scene, result.Mesh);
    EXPECT_EQ(result.Mesh.NumberOfTriangles(), 2 * 84 - 6);
  }
}

TEST(RecoverConstraints, KeepsATangleThroughCrowdedWholePoints)
{
  for (std::uint64_t seed = 0; seed < 60; ++seed)
  {
    const Scene scene = TangledScene(60, 12, 80, seed);
    const TriangulationResult result = scene.Triangulate();
    ExpectAllCovered(scene, result.Mesh);
    EXPECT_EQ(DoubledArea(scene.Points, result.Mesh), 288.0);
  }
}

TEST(RecoverConstraints, KeepsATangleOfLongInterfaces)
{
  for (std::uint64_t seed = 0; seed < 6; ++seed)
  {
    const Scene scene = TangledScene(3000, 1 << 20, 40, seed);
    ExpectAllCovered(scene, scene.Triangulate().Mesh);
  }
}

TEST(RecoverConstraints, KeepsATangleForSmallPhi)
{
  for (std::uint64_t seed = 0; seed < 20; ++seed)
  {
    const Scene scene = TangledScene(200, 100, 60, seed);
    ExpectAllCovered(scene, scene.Triangulate(0.3).Mesh, 0.3);
  }
}

TEST(RecoverConstraints, FillsTheLongCavitiesOfAnyShape)
{
  for (const auto height : { +[](double) { return 1e-5; }, +[](double x) { return 1e-3 + x * x; },
         +[](double x) { return 1.001 - x * x; },
         +[](double x) { return 1e-4 + 1e-3 * (1.0 + std::sin(1e4 * x)); } })
  {
    const Scene scene = CrossedScene(4000, height);
    const TriangulationResult result = scene.Triangulate();
    ExpectAllCovered(scene, result.Mesh);
    EXPECT_EQ(result.Mesh.NumberOfTriangles(), static_cast<Id>(2 * scene.Points.size()) - 6);
  }
}

TEST(RecoverConstraints, RecoversAFanInTimeThatGrowsWithItsSize)
{
  Scene scene;
  scene.AddSquare(-2.0, 2.0);
  const Id hub = scene.AddPoint(0.0, 0.0);
  for (int i = 0; i < 20000; ++i)
  {
    const double angle = 6.283 * i / 20000;
    scene.AddEdge(scene.AddPoint(std::cos(angle), std::sin(angle)), hub, false);
  }
  const TriangulationResult result = scene.Triangulate();
  EXPECT_EQ(CheckTriangulation(scene.Points, result.Mesh, {}), "");
  EXPECT_EQ(*std::max_element(result.Mesh.Constraints.begin(), result.Mesh.Constraints.end()),
    static_cast<Id>(scene.Edges.Starts.size()) - 1);
}

TEST(RecoverConstraints, SplitsAConstraintAtTheVerticesOnIt)
{
  Scene scene;
  scene.AddSquare(0.0, 8.0);
  scene.AddPoint(4.0, 4.0);
  scene.AddPoint(2.0, 2.0);
  scene.AddPoint(5.0, 5.0);
  const Id diagonal = scene.AddEdge(2, 0, false);
  const EdgeMap edges = DirectedEdges(scene.Triangulate().Mesh);
  EXPECT_EQ(edges.at({ 0, 5 }), diagonal);
  EXPECT_EQ(edges.at({ 5, 4 }), diagonal);
  EXPECT_EQ(edges.at({ 4, 6 }), diagonal);
  EXPECT_EQ(edges.at({ 6, 2 }), diagonal);
}

TEST(RecoverConstraints, KeepsTheFirstNumberWhereTwoCoincide)
{
  Scene scene;
  scene.AddSquare(0.0, 8.0);
  const Id middle = scene.AddPoint(4.0, 4.0);
  const Id half = scene.AddEdge(middle, 2, false);
  const Id whole = scene.AddEdge(0, 2, false);
  scene.AddEdge(2, 0, false);
  const EdgeMap edges = DirectedEdges(scene.Triangulate().Mesh);
  EXPECT_EQ(edges.at({ middle, 2 }), half);
  EXPECT_EQ(edges.at({ 2, middle }), half);
  EXPECT_EQ(edges.at({ 0, middle }), whole);
}

TEST(RecoverConstraints, ReportsBothNumbersOfAConflict)
{
  Scene scene;
  scene.AddSquare(0.0, 8.0);
  const Id rising = scene.AddEdge(0, 2, false);
  const Id falling = scene.AddEdge(1, 3, false);
  const TriangulationResult result = scene.Triangulate();
  ASSERT_EQ(result.Conflicts.size(), 1u);
  EXPECT_EQ(result.Conflicts[0].First, rising);
  EXPECT_EQ(result.Conflicts[0].Second, falling);
  EXPECT_EQ(result.Mesh.NumberOfTriangles(), 0);
  EXPECT_FALSE(result.WasAborted);
}

TEST(RecoverConstraints, ReportsAllConflictsOfALongConstraintWhateverItsPlaceAmongThem)
{
  for (int place = 1; place <= 10; ++place)
  {
    Scene scene;
    scene.AddSquare(0.0, 100.0);
    Id across = NoId;
    for (int i = 1; i <= 10; ++i)
    {
      const Id low = i == place ? scene.AddPoint(1, 50) : scene.AddPoint(9 * i, 10);
      const Id high = i == place ? scene.AddPoint(99, 51) : scene.AddPoint(9 * i + 1, 90);
      const Id edge = scene.AddEdge(low, high, false);
      across = i == place ? edge : across;
    }
    const TriangulationResult result = scene.Triangulate();
    ASSERT_EQ(result.Conflicts.size(), 9u) << "at place " << place;
    for (const ConstraintConflict& conflict : result.Conflicts)
    {
      EXPECT_TRUE(conflict.First == across || conflict.Second == across) << "at place " << place;
      EXPECT_LT(conflict.First, conflict.Second);
    }
  }
}

TEST(RecoverConstraints, ReportsEachConstraintThatCrossesAnother)
{
  for (std::uint64_t seed = 0; seed < 20; ++seed)
  {
    Scene scene = RandomScene(60, 100000, seed);
    for (Id start = 4; start + 1 < 60; start += 2)
    {
      scene.AddEdge(start, start + 1, false);
    }
    const std::set<Id> crossing = CrossingConstraints(scene);
    ASSERT_GE(crossing.size(), 20u);
    std::set<Id> reported;
    for (const ConstraintConflict& conflict : scene.Triangulate().Conflicts)
    {
      reported.insert({ conflict.First, conflict.Second });
    }
    EXPECT_EQ(reported, crossing) << "of seed " << seed;
  }
}

TEST(RecoverConstraints, GivesAnEdgeOnManyConstraintsTheSmallestNumber)
{
  Scene scene;
  scene.AddSquare(0.0, 8.0);
  const Id first = scene.AddEdge(0, 2, false);
  for (int i = 0; i < 12; ++i)
  {
    scene.AddEdge(i % 2 ? 0 : 2, i % 2 ? 2 : 0, false);
  }
  const TriangulationResult result = scene.Triangulate();
  EXPECT_EQ(result.Coincidences.size(), 12u);
  EXPECT_EQ(std::count(result.Mesh.Constraints.begin(), result.Mesh.Constraints.end(), first), 2);
}

TEST(RecoverConstraints, IgnoresAConstraintOfNoLength)
{
  Scene scene = RandomScene(20, 100, 1);
  const TriangleSet triangles = Triangles(scene.Triangulate().Mesh);
  scene.AddEdge(7, 7, false);
  EXPECT_EQ(Triangles(scene.Triangulate().Mesh), triangles);
}
