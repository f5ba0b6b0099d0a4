// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "../Simplification/SimplifiedDrawing.h"
#include "../Support/MeshRun.h"

#include <gtest/gtest.h>

#include <algorithm> // for count, min_element

namespace biting
{

namespace
{

constexpr double PixelDiscSpacing = 10.0;

Polylines FineDisc()
{
  return PolylineBuilder().Loop(biting::PixelDisc({ 0.0, 0.0 }, 80.0)).Lines();
}

BitingMeshOptions OptionsOf(double tolerance)
{
  BitingMeshOptions options;
  options.Spacing = UniformSpacing(PixelDiscSpacing);
  options.Simplification.Tolerance = tolerance;
  return options;
}

double VerticesAskedFor(double area)
{
  return 1.1547 * area / (PixelDiscSpacing * PixelDiscSpacing);
}

} // namespace

TEST(BoundaryTolerance, AFineDrawingGetsTheMeshOfTheSpacing)
{
  const MeshRun run = RunMesh(FineDisc(), OptionsOf(0.2));
  ASSERT_EQ(run.Error(), "");
  EXPECT_LT(run.NumberOfVertices(), 1.5 * VerticesAskedFor(Area(run.Mesh)));
  EXPECT_GT(run.Mesh.Quality.SmallestAngle, 30.0);
  EXPECT_GT(run.Mesh.RemovedVertices, 500);
  EXPECT_FALSE(run.Problems.Has(ProblemCode::FineDrawing));
}

TEST(BoundaryTolerance, TheFeatureSizeIsThatOfTheSimplifiedDrawing)
{
  const MeshRun run = RunMesh(FineDisc(), OptionsOf(0.2));
  const std::vector<double>& spacing = run.Mesh.Spacing;
  EXPECT_GT(*std::min_element(spacing.begin(), spacing.end()), 0.7 * PixelDiscSpacing);
}

/// Short segments along a slit keep triangles there small; the tolerance takes them away.
TEST(BoundaryTolerance, ASlitOfASixthOfTheSpacingHasGoodTriangles)
{
  std::vector<Point2> wall;
  for (int k = 0; k <= 100; ++k)
  {
    wall.push_back({ 10.0 + 0.8 * k, 1.6 + 0.02 * (k % 2) });
  }
  wall.push_back({ 90.0, 40.0 });
  wall.push_back({ 10.0, 40.0 });
  const Polylines lines = PolylineBuilder().Box(0.0, 0.0, 100.0, 100.0).Loop(wall).Lines();
  const MeshRun run = RunMesh(lines, OptionsOf(0.1));
  ASSERT_EQ(run.Error(), "");
  EXPECT_GT(run.Mesh.RemovedVertices, 90);
  EXPECT_GT(run.Mesh.Quality.SmallestAngle, 25.0);
}

/// A hole comes so near to the outline that f does not follow it; the short segments do, which the
/// tolerance takes away.
TEST(BoundaryTolerance, ASlitFarBelowTheSpacingIsNoWorseThanWithoutIt)
{
  const std::vector<Point2> hole{ { 1.0, 0.03 }, { 1.02, 0.05 }, { 1.4, 0.6 }, { 1.41, 0.63 },
    { 1.39, 0.65 }, { 0.7, 0.66 }, { 0.98, 0.05 } };
  const Polylines lines = PolylineBuilder().Box(0.0, 0.0, 2.0, 1.0).Loop(hole).Lines();
  for (const double spacing : { 0.5, 1.0, 4.0, 100.0 })
  {
    BitingMeshOptions options;
    options.Spacing = UniformSpacing(spacing);
    const double without = RunMesh(lines, options).Mesh.Quality.SmallestAngle;
    options.Simplification.Tolerance = 0.1;
    const MeshRun run = RunMesh(lines, options);
    ASSERT_EQ(run.Error(), "");
    EXPECT_GE(run.Mesh.Quality.SmallestAngle, 0.99 * without);
  }
}

/// Its tip is far narrower than what the spacing follows.
TEST(BoundaryTolerance, ABluntInletIsNoWorseThanWithoutIt)
{
  const Polylines lines = PolylineBuilder()
                            .Loop({ { 0.0, -1.0 }, { 0.4, -1.0 }, { 0.4, 0.0 }, { 0.201, 0.0 },
                              { 0.201, 0.5 }, { 0.2, 0.5 }, { 0.2, 0.0 }, { 0.0, 0.0 } })
                            .Lines();
  BitingMeshOptions options;
  options.Spacing = UniformSpacing(2.5);
  const double without = RunMesh(lines, options).Mesh.Quality.SmallestAngle;
  options.Simplification.Tolerance = 0.1;
  const MeshRun run = RunMesh(lines, options);
  ASSERT_EQ(run.Error(), "");
  EXPECT_GT(run.Mesh.Quality.SmallestAngle, 0.9 * without);
}

TEST(BoundaryTolerance, VerticesThatStayNameTheirInputPoint)
{
  const Polylines input = FineDisc();
  const MeshRun run = RunMesh(input, OptionsOf(0.2));
  int count = 0;
  for (std::size_t vertex = 0; vertex < run.Mesh.Points.size(); ++vertex)
  {
    const Id original = run.Mesh.OriginalPoints[vertex];
    if (original != NoId)
    {
      EXPECT_EQ(run.Mesh.Points[vertex], input.Points[original]);
      ++count;
    }
  }
  EXPECT_GT(count, 3);
}

TEST(BoundaryTolerance, AFineDrawingIsToldWithoutOne)
{
  const MeshRun run = RunMesh(FineDisc(), OptionsOf(0.0));
  ASSERT_EQ(run.Error(), "");
  EXPECT_EQ(run.Problems.Count(ProblemCode::FineDrawing), 1);
  EXPECT_NEAR(
    run.Mesh.ShareOfDrawing, 1.0 - VerticesAskedFor(Area(run.Mesh)) / run.NumberOfVertices(), 0.01);
}

TEST(BoundaryTolerance, AFineDrawingOfASmallMeshIsNotTold)
{
  // A pixel is smaller than the spacing, a mesh of a few hundred vertices small anyway.
  for (const double radius : { 1.0, 10.0 })
  {
    const MeshRun run = RunMesh(
      PolylineBuilder().Loop(biting::PixelDisc({ 0.0, 0.0 }, radius)).Lines(), OptionsOf(0.0));
    ASSERT_EQ(run.Error(), "");
    EXPECT_GT(run.Mesh.ShareOfDrawing, 0.5);
    EXPECT_FALSE(run.Problems.Has(ProblemCode::FineDrawing));
  }
}

TEST(BoundaryTolerance, ADrawingAsFineAsTheSpacingIsNotTold)
{
  const MeshRun run =
    RunMesh(PolylineBuilder().Loop(RegularPolygon({ 0.0, 0.0 }, 80.0, 60)).Lines(), OptionsOf(0.0));
  EXPECT_FALSE(run.Problems.Has(ProblemCode::FineDrawing));
  EXPECT_EQ(run.Mesh.ShareOfDrawing, 0.0);
}

TEST(BoundaryTolerance, APreservedBoundaryKeepsEveryVertex)
{
  BitingMeshOptions options = OptionsOf(0.2);
  options.PreserveBoundary = true;
  const Polylines input = PolylineBuilder().Loop(RegularPolygon({ 0.0, 0.0 }, 20.0, 60)).Lines();
  const MeshRun run = RunMesh(input, options);
  ASSERT_EQ(run.Error(), "");
  EXPECT_EQ(std::count(run.Mesh.Kinds.begin(), run.Mesh.Kinds.end(), VertexKind::Input), 60);
}

TEST(BoundaryTolerance, LoopsThatAreLeftOutAreMeshedOver)
{
  BitingMeshOptions options = OptionsOf(0.0);
  options.Simplification.MinimumLoopSize = 1.0;
  const MeshRun run = RunMesh(
    PolylineBuilder().Box(0.0, 0.0, 100.0, 100.0).Box(50.0, 50.0, 52.0, 53.0).Lines(), options);
  ASSERT_EQ(run.Error(), "");
  EXPECT_NEAR(Area(run.Mesh), 10000.0, 1e-6);
  EXPECT_EQ(run.Mesh.LeftOutLoops, 1);
  EXPECT_EQ(run.Mesh.LeftOutArea, 6.0);
}

} // namespace biting
