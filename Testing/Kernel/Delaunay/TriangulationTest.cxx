// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Delaunay/Triangulation.h"

#include "Delaunay/Scene.h"

#include <gtest/gtest.h>

#include <cmath> // for sqrt
#include <set>   // for corners in use

namespace
{

using namespace biting;

/// Stops when it is asked for the nth time.
class StoppingMonitor : public Monitor
{
public:
  explicit StoppingMonitor(int calls)
    : CallsLeft(calls)
  {
  }
  bool Advance(double fraction) override
  {
    EXPECT_GE(fraction, this->LastFraction);
    EXPECT_LE(fraction, 1.0);
    this->LastFraction = fraction;
    return --this->CallsLeft > 0;
  }
  void BeginStage(const char*) override {}

  int CallsLeft;
  double LastFraction = 0.0;
};

void ExpectValid(const Scene& scene, const Triangulation& mesh, double phi = 1.0)
{
  EXPECT_EQ(CheckTriangulation(scene.Points, mesh, { phi }), "");
}

/// A square whose only hull vertices are its corners: Euler gives 2n - 6 triangles for n points.
void ExpectFullSquare(const Scene& scene, double size)
{
  const TriangulationResult result = scene.Triangulate();
  ExpectValid(scene, result.Mesh);
  EXPECT_EQ(result.Mesh.Corners.size(), 3 * (2 * scene.Points.size() - 6));
  EXPECT_EQ(DoubledArea(scene.Points, result.Mesh), 2.0 * size * size);
}

Scene GridScene(int columns, int rows)
{
  Scene scene;
  for (int y = 0; y < rows; ++y)
  {
    for (int x = 0; x < columns; ++x)
    {
      scene.AddPoint(x, y);
    }
  }
  const Id last = columns * rows - 1;
  scene.AddEdge(0, columns - 1, true);
  scene.AddEdge(columns - 1, last, true);
  scene.AddEdge(last, last - columns + 1, true);
  scene.AddEdge(last - columns + 1, 0, true);
  return scene;
}

/// All 972 points with whole coordinates on the circle with radius 5 * 13 * 17 * 29 * 37.
std::vector<Point2> PointsOfACircle()
{
  const std::int64_t radius = 1185665;
  std::vector<Point2> points;
  for (std::int64_t x = 0; x < radius; ++x)
  {
    const std::int64_t square = radius * radius - x * x;
    const auto y = static_cast<std::int64_t>(std::llround(std::sqrt(static_cast<double>(square))));
    if (y * y == square)
    {
      const auto u = static_cast<double>(x);
      const auto v = static_cast<double>(y);
      points.insert(points.end(), { { u, v }, { -v, u }, { -u, -v }, { v, -u } });
    }
  }
  return points;
}

/// The same scene with its points in another order; `places` tells where each went.
Scene Permuted(const Scene& scene, std::vector<Id>& places)
{
  const Id size = static_cast<Id>(scene.Points.size());
  Scene permuted = scene;
  for (Id i = 0; i < size; ++i)
  {
    places.push_back(static_cast<Id>((i * std::int64_t(7919) + 13) % size));
    permuted.Points[places.back()] = scene.Points[i];
  }
  for (std::size_t c = 0; c < scene.Edges.Starts.size(); ++c)
  {
    permuted.Edges.Starts[c] = places[scene.Edges.Starts[c]];
    permuted.Edges.Ends[c] = places[scene.Edges.Ends[c]];
  }
  return permuted;
}

/// How near d comes to the circumcentre of (a, b, c), in circumradii.
double RelativeDistance(const Point2& a, const Point2& b, const Point2& c, const Point2& d)
{
  const Point2 u = b - a;
  const Point2 v = c - a;
  const double scale = 0.5 / Cross(u, v);
  const Point2 center =
    scale * Point2{ Dot(u, u) * v.Y - Dot(v, v) * u.Y, Dot(v, v) * u.X - Dot(u, u) * v.X };
  return Distance(d - a, center) / Length(center);
}

/// The least such distance over all unconstrained edges, both ways.
double SmallestPhi(const Scene& scene, const Triangulation& mesh)
{
  double smallest = 1e300;
  for (Id t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    for (Id k = 0; k < 3; ++k)
    {
      const Id neighbor = mesh.Neighbors[3 * t + k];
      for (Id j = 0; neighbor != NoId && mesh.Constraints[3 * t + k] == NoId && j < 3; ++j)
      {
        if (mesh.Neighbors[3 * neighbor + j] == t)
        {
          smallest = std::min(smallest,
            RelativeDistance(scene.Points[mesh.Corners[3 * t]],
              scene.Points[mesh.Corners[3 * t + 1]], scene.Points[mesh.Corners[3 * t + 2]],
              scene.Points[mesh.Corners[3 * neighbor + j]]));
        }
      }
    }
  }
  return smallest;
}

} // namespace

TEST(Triangulate, FillsASquareOfRandomPoints)
{
  for (int count = 0; count < 40; ++count)
  {
    ExpectFullSquare(RandomScene(count, 1000, static_cast<std::uint64_t>(count)), 1000.0);
  }
  ExpectFullSquare(RandomScene(20000, 1 << 20, 5), 1 << 20);
}

TEST(Triangulate, FillsASquareOfCrowdedWholePoints)
{
  for (std::uint64_t seed = 0; seed < 40; ++seed)
  {
    ExpectFullSquare(RandomScene(60, 10, seed), 10.0);
  }
  ExpectFullSquare(RandomScene(81, 10, 0), 10.0);
}

TEST(Triangulate, FillsAGridOfCocircularPoints)
{
  const Scene scene = GridScene(40, 30);
  const TriangulationResult result = scene.Triangulate();
  ExpectValid(scene, result.Mesh);
  EXPECT_EQ(result.Mesh.NumberOfTriangles(), 2 * 39 * 29);
}

TEST(Triangulate, FillsACircleOfPointsThatAreExactlyOnIt)
{
  Scene scene;
  std::vector<Point2> points = PointsOfACircle();
  ASSERT_EQ(points.size(), 972u);
  std::sort(points.begin(), points.end(),
    [](const Point2& a, const Point2& b) { return std::atan2(a.Y, a.X) < std::atan2(b.Y, b.X); });
  scene.AddLoop(points);
  const TriangulationResult result = scene.Triangulate();
  ExpectValid(scene, result.Mesh);
  EXPECT_EQ(result.Mesh.NumberOfTriangles(), 970);
}

TEST(Triangulate, FillsAFanOverThousandCollinearPoints)
{
  Scene scene;
  const Id apex = scene.AddPoint(300.0, 50.0);
  for (int i = 0; i < 1000; ++i)
  {
    scene.AddPoint(i, i);
  }
  scene.AddEdge(1, 1000, true);
  scene.AddEdge(1000, apex, true);
  scene.AddEdge(apex, 1, true);
  const TriangulationResult result = scene.Triangulate();
  ExpectValid(scene, result.Mesh);
  EXPECT_EQ(result.Mesh.NumberOfTriangles(), 999);
}

TEST(Triangulate, GivesNothingWhereThereIsNoTriangle)
{
  for (const int count : { 0, 1, 2, 3, 1000 })
  {
    Scene scene;
    for (int i = 0; i < count; ++i)
    {
      scene.AddPoint(2 * i, 3 * i);
    }
    if (count >= 2)
    {
      scene.AddEdge(0, count - 1, true);
    }
    const TriangulationResult result = scene.Triangulate();
    EXPECT_EQ(result.Mesh.NumberOfTriangles(), 0);
    EXPECT_TRUE(result.Conflicts.empty());
    EXPECT_FALSE(result.WasAborted);
  }
}

TEST(Triangulate, GivesNothingWithoutBoundary)
{
  Scene scene;
  scene.Points = RandomPoints(100, 1000, 6);
  EXPECT_EQ(scene.Triangulate().Mesh.NumberOfTriangles(), 0);
  scene.AddEdge(0, 1, false);
  EXPECT_EQ(scene.Triangulate().Mesh.NumberOfTriangles(), 0);
}

TEST(Triangulate, DoesNotReferToPointsOutside)
{
  Scene scene = RandomScene(300, 1000, 7);
  const std::size_t inside = scene.Points.size();
  for (const Point2& p : RandomPoints(300, 1000, 8))
  {
    scene.AddPoint(p.X + 1001.0, p.Y - 500.0);
  }
  const TriangulationResult result = scene.Triangulate();
  ExpectValid(scene, result.Mesh);
  const std::set<Id> used(result.Mesh.Corners.begin(), result.Mesh.Corners.end());
  EXPECT_EQ(used.size(), inside);
  EXPECT_LT(static_cast<std::size_t>(*used.rbegin()), inside);
}

TEST(Triangulate, ToleratesEqualPoints)
{
  Scene scene = RandomScene(200, 1000, 9);
  const TriangulationResult single = scene.Triangulate();
  const std::vector<Point2> copies = scene.Points;
  scene.Points.insert(scene.Points.end(), copies.begin(), copies.end());
  const Id first = static_cast<Id>(copies.size());
  scene.Edges.Starts[1] += first;
  scene.Edges.Ends[2] += first;
  const TriangulationResult twice = scene.Triangulate();
  ExpectValid(scene, twice.Mesh);
  EXPECT_EQ(twice.Mesh.Corners.size(), single.Mesh.Corners.size());
}

TEST(Triangulate, GivesTheSameBytesAgain)
{
  const Scene scene = RandomScene(3000, 100, 10);
  const Triangulation first = scene.Triangulate().Mesh;
  const Triangulation second = scene.Triangulate().Mesh;
  EXPECT_EQ(first.Corners, second.Corners);
  EXPECT_EQ(first.Neighbors, second.Neighbors);
  EXPECT_EQ(first.Constraints, second.Constraints);
  EXPECT_EQ(first.Regions, second.Regions);
}

TEST(Triangulate, GivesTheSameTrianglesForPermutedPoints)
{
  const Scene scene = RandomScene(3001, 1 << 25, 11);
  std::vector<Id> places;
  const Scene permuted = Permuted(scene, places);
  Triangulation mesh = scene.Triangulate().Mesh;
  for (Id& corner : mesh.Corners)
  {
    corner = places[corner];
  }
  EXPECT_EQ(Triangles(mesh), Triangles(permuted.Triangulate().Mesh));
}

TEST(Triangulate, GivesTheSameTrianglesForScaledAndTurnedPoints)
{
  const Scene scene = RandomScene(2000, 1 << 25, 12);
  const TriangleSet triangles = Triangles(scene.Triangulate().Mesh);
  for (const double scale : { 0x1p-100, 0x1p+100 })
  {
    Scene turned = scene;
    for (Point2& p : turned.Points)
    {
      p = scale * Perpendicular(p);
    }
    EXPECT_EQ(Triangles(turned.Triangulate().Mesh), triangles);
  }
}

TEST(Triangulate, ObeysThePhiLaw)
{
  const Scene scene = RandomScene(3000, 1 << 20, 13);
  const TriangleSet delaunay = Triangles(scene.Triangulate().Mesh);
  for (const double phi : { 0.1, 0.5, 0.9 })
  {
    const TriangulationResult result = scene.Triangulate(phi);
    ExpectValid(scene, result.Mesh, phi);
    EXPECT_EQ(result.Mesh.NumberOfTriangles(), static_cast<Id>(delaunay.size()));
    EXPECT_GE(SmallestPhi(scene, result.Mesh), phi * (1.0 - 1e-9));
    EXPECT_LT(SmallestPhi(scene, result.Mesh), 1.0);
    EXPECT_NE(Triangles(result.Mesh), delaunay);
  }
}

/// Points that no bite is nearer to than 1, and none further from the next than sqrt(2): shaken
/// rows.
Scene BittenScene(int size)
{
  Scene scene;
  scene.AddSquare(0.0, size);
  Dice dice(5);
  const auto shift = [&dice]() { return 0.1 * (dice.Below(1000) / 1000.0 - 0.5); };
  for (int row = 1; row < size; ++row)
  {
    scene.AddPoint(row, 0);
    scene.AddPoint(row, size);
    scene.AddPoint(0, row);
    scene.AddPoint(size, row);
    for (int column = 1; column < size; ++column)
    {
      const double x = column + shift();
      scene.AddPoint(x, row + shift());
    }
  }
  return scene;
}

double LargestRadiusEdgeRatio(const Scene& scene, const Triangulation& mesh)
{
  double largest = 0.0;
  for (Id t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    const Point2& a = scene.Points[mesh.Corners[3 * t]];
    const Point2& b = scene.Points[mesh.Corners[3 * t + 1]];
    const Point2& c = scene.Points[mesh.Corners[3 * t + 2]];
    const double ab = Distance(a, b);
    const double bc = Distance(b, c);
    const double ca = Distance(c, a);
    const double radius = ab * bc * ca / (2.0 * Cross(b - a, c - a));
    largest = std::max(largest, radius / std::min({ ab, bc, ca }));
  }
  return largest;
}

TEST(Triangulate, KeepsTheBoundOfTheTheoremForAnyPhi)
{
  const Scene scene = BittenScene(60);
  for (const double phi : { 0.3, 0.6, 0.8, 0.95, 0.99 })
  {
    const TriangulationResult result = scene.Triangulate(phi);
    ExpectValid(scene, result.Mesh, phi);
    EXPECT_LE(LargestRadiusEdgeRatio(scene, result.Mesh), std::sqrt(2.0) / phi * (1.0 + 1e-9));
  }
}

TEST(Triangulate, FillsCrowdedSquaresForAnyPhi)
{
  for (std::uint64_t seed = 0; seed < 20; ++seed)
  {
    const Scene scene = RandomScene(60, 10, seed);
    const TriangulationResult result = scene.Triangulate(0.5);
    ExpectValid(scene, result.Mesh, 0.5);
    EXPECT_EQ(DoubledArea(scene.Points, result.Mesh), 200.0);
  }
}

TEST(Triangulate, StopsWhereverTheMonitorAsks)
{
  const Scene scene = RandomScene(5000, 1 << 20, 14);
  int calls = 1;
  while (true)
  {
    StoppingMonitor monitor(calls);
    const TriangulationResult result =
      Triangulate(scene.Points, scene.Edges, TriangulationOptions(), monitor);
    EXPECT_EQ(result.WasAborted, monitor.CallsLeft <= 0);
    EXPECT_EQ(result.Mesh.NumberOfTriangles() == 0, result.WasAborted);
    if (!result.WasAborted)
    {
      break;
    }
    ++calls;
  }
  EXPECT_GT(calls, 15);
}
