// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "../Support/MeshRun.h"
#include "../Support/MeshShapes.h"
#include "../Support/Monitors.h"
#include "../Support/RemeshLaws.h"
#include "BitingRemesh.h"

#include <gtest/gtest.h>

#include <cmath>      // for sin
#include <functional> // for spacings

namespace biting
{

namespace
{

using SpacingFunction = std::function<double(const Point2&)>;

BitingMesh MeshOf(const Polylines& lines, double spacing)
{
  BitingMeshOptions options;
  options.Spacing.Uniform = spacing;
  return RunMesh(lines, options).Mesh;
}

BitingMesh DiscMesh()
{
  return MeshOf(PolylineBuilder()
                  .Loop(RegularPolygon({ 0.0, 0.0 }, 1.0, 120))
                  .Loop(RegularPolygon({ 0.2, 0.1 }, 0.3, 60))
                  .Lines(),
    0.05);
}

/// A wave from (0, y) to (2, y), in steps of 1 / 25.
std::vector<Point2> Wave(double y)
{
  std::vector<Point2> places;
  for (int k = 0; k <= 50; ++k)
  {
    places.push_back({ k / 25.0, y + 0.1 * std::sin(0.16 * k) });
  }
  return places;
}

/// Two regions with a wave between, cut into two cells by a vertex, and an embedded point near it.
BitingMesh WaveMesh()
{
  const std::vector<Point2> wave = Wave(0.5);
  return MeshOf(PolylineBuilder()
                  .Box(0.0, -0.5, 2.0, 1.5)
                  .Chain({ wave.begin(), wave.begin() + 22 }, ChainKind::Interface)
                  .Chain({ wave.begin() + 21, wave.end() }, ChainKind::Interface)
                  .Chain({ { 0.51, 0.643 } }, ChainKind::EmbeddedPoint)
                  .Lines(),
    0.04);
}

struct ThinningRun
{
  RemeshInput Input;
  RemeshResult Result;

  Id BoundaryEdges() const
  {
    const std::vector<std::uint8_t>& flags = this->Result.Mesh.EdgeIsBoundary;
    return static_cast<Id>(std::count(flags.begin(), flags.end(), 1));
  }
};

ThinningRun Make(const BitingMesh& mesh, const SpacingFunction& f, RemeshOptions options)
{
  ThinningRun run;
  run.Input = RemeshInputOf(mesh, Rounding);
  std::vector<double> allowed;
  for (const Point2& point : run.Input.Points)
  {
    options.Values.push_back(f(point));
    allowed.push_back(options.BoundaryTolerance * options.Values.back());
  }
  ProblemList problems;
  run.Result = Remesh(run.Input, options, problems, NoMonitor());
  EXPECT_FALSE(problems.HasErrors());
  if (options.BoundaryTolerance == 0.0)
  {
    allowed.clear();
  }
  EXPECT_EQ(RemeshLaws(run.Input, run.Result, allowed).Violation(), "");
  return run;
}

RemeshOptions WithTolerance(double tolerance)
{
  RemeshOptions options;
  options.BoundaryTolerance = tolerance;
  return options;
}

double LargestDistance(const BitingMesh& from, const std::vector<Point2>& points,
  const BitingMesh& to, const std::vector<Point2>& places)
{
  constexpr int Samples = 20;
  double largest = 0.0;
  for (std::size_t k = 0; k < from.EdgeStarts.size(); ++k)
  {
    for (int sample = 0; sample <= Samples; ++sample)
    {
      const Point2& start = points[from.EdgeStarts[k]];
      const Point2 place =
        start + (static_cast<double>(sample) / Samples) * (points[from.EdgeEnds[k]] - start);
      double least = 1e9;
      for (std::size_t m = 0; m < to.EdgeStarts.size(); ++m)
      {
        const Point2& a = places[to.EdgeStarts[m]];
        const Point2 along = places[to.EdgeEnds[m]] - a;
        const double share = std::clamp(Dot(place - a, along) / Dot(along, along), 0.0, 1.0);
        least = std::min(least, Distance(place, a + share * along));
      }
      largest = std::max(largest, least);
    }
  }
  return largest;
}

/// Between the edges before and after, sampled both ways.
double Hausdorff(const ThinningRun& run)
{
  const BitingMesh before = EdgesOf(run.Result.Old);
  const BitingMesh& after = run.Result.Mesh;
  return std::max(LargestDistance(before, run.Input.Points, after, after.Points),
    LargestDistance(after, after.Points, before, run.Input.Points));
}

} // namespace

TEST(EdgeSimplification, CoarseningThinsABentBoundaryWithinTheTolerance)
{
  const auto f = [](const Point2&) { return 0.2; };
  const ThinningRun exact = Make(DiscMesh(), f, WithTolerance(0.0));
  EXPECT_EQ(exact.BoundaryEdges(), 180);
  Id before = 180;
  for (const double tolerance : { 0.02, 0.1, 0.3 })
  {
    const ThinningRun run = Make(DiscMesh(), f, WithTolerance(tolerance));
    EXPECT_LT(run.BoundaryEdges(), before);
    EXPECT_LE(Hausdorff(run), tolerance * 0.2);
    EXPECT_GT(run.Result.Mesh.Quality.SmallestAngle, 28.0);
    before = run.BoundaryEdges() + 1;
  }
  // Lengths of 6.2 + 1.9 in edges of 0.2.
  EXPECT_LE(before, 50);
}

// Old edges are two thirds as long as f: between vertices of the polygon they would be 2/3 or 4/3.
TEST(EdgeSimplification, EdgesAreDividedAnewWhereNoOldVertexIsNearTheEndOfAPart)
{
  const BitingMesh mesh =
    MeshOf(PolylineBuilder().Loop(RegularPolygon({ 0.0, 0.0 }, 1.0, 120)).Lines(), 0.05);
  const double spacing = 0.078;
  const BitingMesh coarse = Make(
    mesh, [spacing](const Point2&) { return spacing; }, WithTolerance(0.1))
                              .Result.Mesh;
  std::size_t good = 0;
  for (std::size_t edge = 0; edge < coarse.EdgeStarts.size(); ++edge)
  {
    const double length =
      Distance(coarse.Points[coarse.EdgeStarts[edge]], coarse.Points[coarse.EdgeEnds[edge]]);
    good += length > 0.75 * spacing && length < 1.3 * spacing;
  }
  EXPECT_GT(good, coarse.EdgeStarts.size() / 2); // none but for that
}

TEST(EdgeSimplification, TheFeatureSizeIsThatOfTheThinnedBoundary)
{
  const auto f = [](const Point2&) { return 0.2; };
  const ThinningRun run = Make(DiscMesh(), f, WithTolerance(0.2));
  for (const double spacing : run.Result.Mesh.Spacing)
  {
    EXPECT_GT(spacing, 0.12);
  }
}

TEST(EdgeSimplification, RefinementStaysOnTheOldPolygon)
{
  const auto f = [](const Point2&) { return 0.025; };
  const ThinningRun run = Make(DiscMesh(), f, WithTolerance(0.5));
  EXPECT_LE(Hausdorff(run), 2.0 * Rounding);
  EXPECT_GT(run.BoundaryEdges(), 240);
}

TEST(EdgeSimplification, WhatFitsStaysWhateverTheTolerance)
{
  const BitingMesh mesh =
    MeshOf(PolylineBuilder().Loop(RegularPolygon({ 0.0, 0.0 }, 1.0, 120)).Lines(), 0.05);
  RemeshOptions options = WithTolerance(0.5);
  options.Values = mesh.Spacing;
  ProblemList problems;
  const RemeshInput input = RemeshInputOf(mesh, Rounding);
  EXPECT_TRUE(Remesh(input, options, problems, NoMonitor()).IsUnchanged);
}

TEST(EdgeSimplification, InterfacesAreThinnedAndEndsOfTagsStay)
{
  const BitingMesh mesh = WaveMesh();
  const Point2 meeting = Wave(0.5)[21];
  for (const double spacing : { 0.1, 0.2, 0.4 })
  {
    const ThinningRun run = Make(
      mesh, [spacing](const Point2&) { return spacing; }, WithTolerance(0.25));
    const std::vector<Point2>& points = run.Result.Mesh.Points;
    EXPECT_NE(std::find(points.begin(), points.end(), meeting), points.end());
    EXPECT_LE(Hausdorff(run), 0.25 * spacing);
    EXPECT_LT(points.size(), mesh.Points.size() / 3);
  }
}

TEST(EdgeSimplification, OnlyWhereTheSpacingGrew)
{
  const BitingMesh mesh = WaveMesh();
  const auto f = [](const Point2& p) { return 0.04 + 0.15 * std::max(0.0, p.X - 1.0); };
  const ThinningRun run = Make(mesh, f, WithTolerance(0.25));
  const std::vector<Point2>& points = run.Result.Mesh.Points;
  for (const Point2& place : Wave(0.5))
  {
    EXPECT_TRUE(place.X > 0.9 || std::find(points.begin(), points.end(), place) != points.end());
  }
  EXPECT_LE(Hausdorff(run), 0.25 * 0.19);
}

TEST(EdgeSimplification, CornersStayByTheFeatureAngle)
{
  // A turn of 40 degrees in the middle of a side.
  const double height = std::tan(std::acos(-1.0) / 9.0);
  const BitingMesh mesh = MeshOf(
    PolylineBuilder().Loop({ { 0, 0 }, { 2, 0 }, { 2, 1 }, { 1, 1 + height }, { 0, 1 } }).Lines(),
    0.04);
  for (const double tolerance : { 0.1, 0.2, 0.3 })
  {
    RemeshOptions options = WithTolerance(tolerance);
    options.FeatureAngle = 39.0;
    const ThinningRun run = Make(
      mesh, [](const Point2&) { return 0.4; }, options);
    const std::vector<Point2>& points = run.Result.Mesh.Points;
    const bool stays =
      std::find(points.begin(), points.end(), Point2{ 1, 1 + height }) != points.end();
    EXPECT_TRUE(stays);
  }
}

TEST(EdgeSimplification, WhereNoneMayGoNoneDoes)
{
  const auto f = [](const Point2&) { return 0.2; };
  for (const EdgePolicy policy : { EdgePolicy::SplitOnly, EdgePolicy::Frozen })
  {
    RemeshOptions options = WithTolerance(0.3);
    options.Edges = policy;
    EXPECT_LE(Hausdorff(Make(DiscMesh(), f, options)), 2.0 * Rounding);
  }
}

TEST(EdgeSimplification, FixedVerticesAndFrozenTrianglesStay)
{
  const BitingMesh mesh = DiscMesh();
  RemeshInput input = RemeshInputOf(mesh, Rounding);
  input.IsFrozen.assign(input.Corners.size() / 3, 0);
  for (std::size_t corner = 0; corner < input.Corners.size(); corner += 3)
  {
    input.IsFrozen[corner / 3] = input.Points[input.Corners[corner]].X < -0.7;
  }
  for (std::size_t vertex = 0; vertex < input.Points.size(); vertex += 7)
  {
    input.IsFixed[vertex] = 1;
  }
  RemeshOptions options = WithTolerance(0.5);
  options.Values.assign(input.Points.size(), 0.3);
  ProblemList problems;
  const RemeshResult result = Remesh(input, options, problems, NoMonitor());
  const std::vector<double> allowed(input.Points.size(), 0.15);
  EXPECT_EQ(RemeshLaws(input, result, allowed).Violation(), "");
}

/// A slit outside of the mesh; on its other side triangles stay, which have no vertex in the way.
TEST(EdgeSimplification, EdgesDoNotMoveOverWhatIsUnchangedAcrossASlit)
{
  RemeshInput input;
  input.Points = { { 0, 0 }, { 2, 0 }, { 1, 0.1 }, { 0, -2 }, { 2, -2 }, { 1, 2 } };
  input.Corners = { 1, 0, 3, 3, 4, 1, 0, 2, 5, 2, 1, 5 };
  input.IsFrozen = { 1, 1, 0, 0 };
  RemeshOptions options = WithTolerance(0.9);
  options.Values.assign(input.Points.size(), 4.0);
  options.LimitByFeatureSize = false;
  ProblemList problems;
  const RemeshResult result = Remesh(input, options, problems, NoMonitor());
  EXPECT_FALSE(problems.HasErrors());
  const std::vector<double> allowed(input.Points.size(), 3.6);
  EXPECT_TRUE(result.IsUnchanged || RemeshLaws(input, result, allowed).Violation().empty());
}

TEST(EdgeSimplification, AMonitorThatStopsGetsNothing)
{
  const RemeshInput input = RemeshInputOf(WaveMesh(), Rounding);
  RemeshOptions options = WithTolerance(0.3);
  options.Values.assign(input.Points.size(), 0.2);
  for (int calls = 0; calls < 150; calls += 3)
  {
    StoppingMonitor monitor(calls);
    ProblemList problems;
    const RemeshResult result = Remesh(input, options, problems, monitor);
    EXPECT_EQ(result.Mesh.Points.empty(), monitor.HasStopped());
  }
}

} // namespace biting
