// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "../Support/Monitors.h"
#include "RawMesh.h"

#include <gtest/gtest.h>

#include <cmath> // for abs

namespace biting
{

namespace
{

/// The parts of each segment lead from its start to its end, each begins where the last one ended,
/// and all vertices between are on the segment to rounding.
void ExpectSegmentsCovered(const RawMesh& raw)
{
  const Domain& domain = raw.Domain;
  const RelaxationMesh& mesh = raw.Mesh;
  std::size_t part = 0;
  for (Id segment = 0; segment < domain.NumberOfSegments(); ++segment)
  {
    Id at = domain.Starts[segment];
    const Point2& start = domain.Vertices[at];
    const Point2 direction = domain.Vertices[domain.Ends[segment]] - start;
    double along = 0.0;
    for (; part < mesh.EdgeSegments.size() && mesh.EdgeSegments[part] == segment; ++part)
    {
      ASSERT_EQ(mesh.EdgeStarts[part], at);
      at = mesh.EdgeEnds[part];
      const Point2 way = mesh.Points[at] - start;
      EXPECT_GT(Dot(way, direction), along);
      along = Dot(way, direction);
      EXPECT_LE(std::abs(Cross(way, direction)), domain.Resolution * Length(direction));
    }
    ASSERT_EQ(at, domain.Ends[segment]);
  }
  EXPECT_EQ(part, mesh.EdgeSegments.size());
}

// Each constraint of the triangles is the part of the same number.
void ExpectConstraintsListed(const RelaxationMesh& mesh)
{
  std::vector<Id> sides(mesh.EdgeStarts.size(), 0);
  for (std::size_t half = 0; half < mesh.Triangles.Corners.size(); ++half)
  {
    const Id constraint = mesh.Triangles.Constraints[half];
    if (constraint != NoId)
    {
      const Id* corners = mesh.Triangles.Corners.data() + half / 3 * 3;
      const Id u = corners[(half + 1) % 3];
      const Id v = corners[(half + 2) % 3];
      ASSERT_EQ(std::min(u, v), std::min(mesh.EdgeStarts[constraint], mesh.EdgeEnds[constraint]));
      ASSERT_EQ(std::max(u, v), std::max(mesh.EdgeStarts[constraint], mesh.EdgeEnds[constraint]));
      ++sides[constraint];
    }
  }
  for (const Id count : sides)
  {
    EXPECT_GE(count, 1);
  }
}

Polylines Transformed(const Polylines& lines, Point2 (*transform)(const Point2&))
{
  Polylines moved = lines;
  for (Point2& point : moved.Points)
  {
    point = transform(point);
  }
  return moved;
}

} // namespace

TEST(Relax, LeavesAValidDelaunayMeshThatCoversAllSegments)
{
  for (RawMesh& raw : AllRawMeshes())
  {
    raw.Relax();
    ASSERT_EQ(raw.Violation(true), "");
    ExpectSegmentsCovered(raw);
    ExpectConstraintsListed(raw.Mesh);
  }
}

TEST(Relax, MakesAllMeshesBetterAndLowersNoAngleBelow20Degrees)
{
  for (RawMesh& raw : AllRawMeshes())
  {
    const double mean = raw.MeanMinimumAngle();
    const double smallest = raw.Quality().SmallestAngle;
    raw.Relax();
    EXPECT_GT(raw.MeanMinimumAngle(), mean + 2.0);
    EXPECT_GE(raw.Quality().SmallestAngle, std::min(smallest, 20.0) - 1e-9);
  }
}

TEST(Relax, MakesAGoodMeshOfASquare)
{
  RawMesh raw = UnitSquare(0.05);
  raw.Relax();
  const MeshQuality quality = raw.Quality();
  EXPECT_GT(quality.SmallestAngle, 35.0);
  EXPECT_GT(raw.MeanMinimumAngle(), 50.0);
  EXPECT_GT(quality.ShareOfEdgesInBand, 0.995);
}

TEST(Relax, KeepsTheVerticesOfTheDomainBitForBitThenTheOldOnesInTheirOrderThenTheNewOnes)
{
  for (RawMesh& raw : AllRawMeshes())
  {
    const RelaxationMesh before = raw.Mesh;
    const RelaxationResult result = raw.Relax();
    ASSERT_EQ(result.Origins.size(), raw.Mesh.Points.size());
    for (std::size_t vertex = 0; vertex < raw.Domain.Vertices.size(); ++vertex)
    {
      EXPECT_EQ(raw.Mesh.Points[vertex], raw.Domain.Vertices[vertex]);
      EXPECT_EQ(result.Origins[vertex], static_cast<Id>(vertex));
    }
    Id last = -1;
    bool isNew = false;
    for (std::size_t vertex = 0; vertex < result.Origins.size(); ++vertex)
    {
      const Id origin = result.Origins[vertex];
      EXPECT_TRUE(origin == NoId ? true : !isNew && origin > last);
      isNew = origin == NoId;
      last = origin;
      EXPECT_TRUE(origin == NoId || raw.Mesh.Segments[vertex] == before.Segments[origin]);
    }
  }
}

TEST(Relax, IsTheSameEveryTime)
{
  RawMesh first = Plate();
  RawMesh second = Plate();
  first.Relax();
  second.Relax();
  EXPECT_TRUE(AreSame(first.Mesh, second.Mesh));
}

TEST(Relax, AddsNoVertexToSegmentsThatMustNotBeDivided)
{
  RelaxationOptions options;
  options.DividesSegments = false;
  for (RawMesh& raw : AllRawMeshes())
  {
    const std::size_t before = raw.Mesh.EdgeStarts.size();
    const RelaxationResult result = raw.Relax(options);
    EXPECT_LE(raw.Mesh.EdgeStarts.size(), before);
    for (std::size_t vertex = 0; vertex < result.Origins.size(); ++vertex)
    {
      EXPECT_TRUE(result.Origins[vertex] != NoId || raw.Mesh.Segments[vertex] == NoId);
    }
  }
}

TEST(Relax, KeepsTheSpacingAsTheTargetOfLengths)
{
  RawMesh raw = GradedSquare();
  raw.Relax();
  EXPECT_NEAR(raw.Quality().MeanRelativeLength, 1.0, 0.05);
  for (std::size_t vertex = 0; vertex < raw.Mesh.Points.size(); ++vertex)
  {
    ASSERT_EQ(raw.Mesh.Spacings[vertex], raw.Spacing(raw.Mesh.Points[vertex]));
  }
}

TEST(Relax, ChangesAGoodMeshHardly)
{
  RawMesh raw = UnitSquare(0.05);
  raw.Relax();
  const std::size_t vertices = raw.Mesh.Points.size();
  const double angle = raw.MeanMinimumAngle();
  raw.Relax();
  EXPECT_NEAR(static_cast<double>(raw.Mesh.Points.size()), vertices, 0.03 * vertices);
  EXPECT_GT(raw.MeanMinimumAngle(), angle - 0.2);
}

TEST(Relax, IsAsGoodWhenMirroredOrTurned)
{
  const Polylines lines =
    PolylineBuilder().Box(0.0, 0.0, 1.0, 1.0).Loop(RegularPolygon({ 0.6, 0.6 }, 0.2, 14)).Lines();
  RawMesh plain(lines, UniformSpacing(0.05));
  RawMesh mirrored(Transformed(lines,
                     [](const Point2& p) {
                       return Point2{ -p.X, p.Y };
                     }),
    UniformSpacing(0.05));
  RawMesh turned(Transformed(lines,
                   [](const Point2& p) {
                     return Point2{ -p.Y, p.X };
                   }),
    UniformSpacing(0.05));
  for (RawMesh* raw : { &plain, &mirrored, &turned })
  {
    raw->Relax();
  }
  EXPECT_NEAR(mirrored.MeanMinimumAngle(), plain.MeanMinimumAngle(), 1.5);
  EXPECT_NEAR(turned.MeanMinimumAngle(), plain.MeanMinimumAngle(), 1.5);
}

TEST(Relax, LeavesNoMeshWhenStopped)
{
  for (int calls = 1; calls < 40; calls += 3)
  {
    RawMesh raw = Plate();
    StoppingMonitor monitor(calls);
    const RelaxationResult result = Relax(raw.Domain, raw.Spacing, {}, raw.Mesh, monitor);
    EXPECT_TRUE(!result.WasAborted || AreSame(RelaxationMesh(), raw.Mesh));
  }
}

TEST(Relax, AcceptsASingleTriangleAndNone)
{
  RawMesh raw(PolylineBuilder().Loop({ { 0.0, 0.0 }, { 1.0, 0.0 }, { 0.0, 1.0 } }).Lines(),
    UniformSpacing(2.0), 1.0, 0);
  const RelaxationMesh before = raw.Mesh;
  raw.Relax();
  EXPECT_TRUE(HaveSameBytes(raw.Domain.Vertices,
    std::vector<Point2>(raw.Mesh.Points.begin(), raw.Mesh.Points.begin() + 3)));
  EXPECT_EQ(raw.Violation(true), "");
  RawMesh none(Polylines(), UniformSpacing(1.0), 1.0, 0);
  EXPECT_TRUE(none.Relax().Origins.empty());
}

TEST(Relax, StaysValidFarFromTheOriginAndWhereEdgesAreAsSmallAsRounding)
{
  const double far = 1e8;
  for (const double size : { 1.0, 1e-5, 1e-7 })
  {
    RawMesh raw(PolylineBuilder().Box(far, far, far + size, far + size).Lines(),
      UniformSpacing(0.1 * size), 0.7, 1000);
    raw.Relax();
    EXPECT_EQ(raw.Violation(true), "");
  }
}

} // namespace biting
