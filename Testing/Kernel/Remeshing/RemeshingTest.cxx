// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "../Support/MeshRun.h"
#include "../Support/MeshShapes.h"
#include "../Support/Monitors.h"
#include "../Support/RemeshLaws.h"
#include "BitingRemesh.h"
#include "Remeshing/Stitching.h"

#include <gtest/gtest.h>

#include <cmath>   // for sin
#include <cstring> // for memcmp
#include <limits>  // for the most rings

namespace biting
{

namespace
{

struct RemeshRun
{
  RemeshInput Input;
  RemeshResult Result;
  ProblemList Problems;

  double ShareOfKept() const
  {
    const std::vector<Id>& originals = this->Result.Mesh.OriginalPoints;
    const auto isNew = std::count(originals.begin(), originals.end(), NoId);
    return static_cast<double>(originals.size() - static_cast<std::size_t>(isNew)) /
      static_cast<double>(this->Input.Points.size());
  }

  double SmallestAngle() const { return this->Result.Mesh.Quality.SmallestAngle; }
};

RemeshRun RunRemesh(RemeshInput input, const RemeshOptions& options)
{
  RemeshRun run;
  run.Input = std::move(input);
  run.Result = Remesh(run.Input, options, run.Problems, NoMonitor());
  return run;
}

/// Runs, and expects that the laws hold.
RemeshRun RunLawfully(const RemeshInput& input, const RemeshOptions& options)
{
  RemeshRun run = RunRemesh(input, options);
  EXPECT_FALSE(run.Problems.HasErrors());
  if (!run.Result.IsUnchanged)
  {
    EXPECT_EQ(RemeshLaws(run.Input, run.Result).Violation(), "");
  }
  return run;
}

/// A square with a hole, two regions, an interface that ends within, and an embedded point.
BitingMesh PlateMesh(double spacing)
{
  BitingMeshOptions options;
  options.Spacing.Uniform = spacing;
  return RunMesh(PolylineBuilder()
                   .Box(0.0, 0.0, 2.0, 1.0)
                   .Loop(RegularPolygon({ 0.5, 0.5 }, 0.2, 30))
                   .Chain({ { 1.0, 0.0 }, { 1.1, 0.5 }, { 1.0, 1.0 } }, ChainKind::Interface)
                   .Chain({ { 1.3, 0.3 }, { 1.7, 0.6 } }, ChainKind::Interface)
                   .Chain({ { 1.513, 0.771 } }, ChainKind::EmbeddedPoint)
                   .Lines(),
    options)
    .Mesh;
}

template <typename Function>
RemeshOptions Wanting(const RemeshInput& input, const Function& f)
{
  RemeshOptions options;
  for (const Point2& point : input.Points)
  {
    options.Values.push_back(f(point));
  }
  return options;
}

RemeshOptions WantingUniform(const RemeshInput& input, double spacing)
{
  return Wanting(input, [spacing](const Point2&) { return spacing; });
}

/// Half of `spacing` in a disc, with slope 0.3 back.
RemeshOptions WantingDisc(const RemeshInput& input, double spacing)
{
  return Wanting(input,
    [spacing](const Point2& p)
    {
      const double distance = std::max(Distance(p, { 0.5, 0.5 }) - 0.2, 0.0);
      return std::min(0.5 * spacing + 0.3 * distance, spacing);
    });
}

/// A fine layer along a curved line.
RemeshOptions WantingLayer(const RemeshInput& input, double place)
{
  return Wanting(input,
    [place](const Point2& p)
    {
      const double distance = std::abs(p.X - place - 0.1 * std::sin(6.0 * p.Y));
      return std::min(0.01 + 0.25 * distance, 0.05);
    });
}

} // namespace

TEST(Remeshing, AMeshOfTheSpacingThatIsWantedIsUnchanged)
{
  for (const BitingMesh& mesh : { SquareMesh(0.04), PlateMesh(0.05) })
  {
    const RemeshInput input = RemeshInputOf(mesh, Rounding);
    RemeshOptions options;
    options.Values = mesh.Spacing;
    const RemeshRun run = RunLawfully(input, options);
    EXPECT_TRUE(run.Result.IsUnchanged);
    EXPECT_EQ(run.Result.Mesh.EdgeStarts.size(), mesh.EdgeStarts.size());
  }
}

TEST(Remeshing, AMeshWhoseDrawingIsFinerThanTheSpacingIsUnchanged)
{
  BitingMeshOptions meshing;
  meshing.Spacing.Uniform = 0.05;
  const BitingMesh mesh = RunMesh(
    PolylineBuilder().Box(0.0, 0.0, 1.0, 1.0).Loop(RegularPolygon({ 0.5, 0.5 }, 0.2, 36)).Lines(),
    meshing)
                            .Mesh;
  const RemeshInput input = RemeshInputOf(mesh, Rounding);
  RemeshOptions options;
  options.Values = mesh.Spacing;
  EXPECT_TRUE(RunLawfully(input, options).Result.IsUnchanged);
}

TEST(Remeshing, WhereTheSpacingIsHalvedNearlyAllVerticesStay)
{
  const RemeshInput input = RemeshInputOf(SquareMesh(0.02), Rounding);
  const RemeshRun disc = RunLawfully(input, WantingDisc(input, 0.02));
  EXPECT_GT(disc.ShareOfKept(), 0.97);
  EXPECT_GT(disc.SmallestAngle(), 30.0);
  EXPECT_GT(disc.Result.Mesh.Points.size(), 1.2 * static_cast<double>(input.Points.size()));
  const RemeshRun all = RunLawfully(input, WantingUniform(input, 0.01));
  EXPECT_GT(all.ShareOfKept(), 0.999);
  EXPECT_GT(all.SmallestAngle(), 35.0);
}

TEST(Remeshing, WithoutRelaxationTooVerticesBetweenOldOnesAreNew)
{
  const RemeshInput input = RemeshInputOf(SquareMesh(0.05), Rounding);
  RemeshOptions options = WantingUniform(input, 0.025);
  options.Relaxation = false;
  const RemeshRun raw = RunLawfully(input, options);
  EXPECT_EQ(raw.ShareOfKept(), 1.0);
  EXPECT_GT(raw.Result.Mesh.Points.size(), 3 * input.Points.size());
}

TEST(Remeshing, WhatIsFarFromAChangeIsUnchanged)
{
  const RemeshInput input = RemeshInputOf(SquareMesh(0.02), Rounding);
  const RemeshRun run = RunLawfully(input, WantingDisc(input, 0.02));
  std::vector<std::uint8_t> isKept(input.Corners.size() / 3, 0);
  for (const Id original : run.Result.OriginalTriangles)
  {
    isKept[original == NoId ? 0 : original] = 1;
  }
  for (std::size_t slot = 0; slot < input.Corners.size(); ++slot)
  {
    const bool isFar = Distance(input.Points[input.Corners[slot]], { 0.5, 0.5 }) > 0.36;
    EXPECT_TRUE(!isFar || isKept[slot / 3]);
  }
}

TEST(Remeshing, WhereTheSpacingIsDoubledNewVerticesAreOldOnes)
{
  const RemeshInput input = RemeshInputOf(SquareMesh(0.02), Rounding);
  const RemeshRun run = RunLawfully(input, WantingUniform(input, 0.04));
  EXPECT_GT(run.ShareOfKept(), 0.18);
  EXPECT_LT(run.Result.Mesh.Points.size(), 0.3 * static_cast<double>(input.Points.size()));
  EXPECT_GT(run.SmallestAngle(), 30.0);
}

TEST(Remeshing, BoundariesInterfacesAndEmbeddedPointsAreKept)
{
  const RemeshInput input = RemeshInputOf(PlateMesh(0.05), Rounding);
  for (const double spacing : { 0.02, 0.025, 0.04, 0.07, 0.1, 0.3 })
  {
    RunLawfully(input, WantingUniform(input, spacing));
  }
}

TEST(Remeshing, ALayerThatMovesKeepsTheLaws)
{
  RemeshInput input = RemeshInputOf(SquareMesh(0.03), Rounding);
  for (int step = 0; step < 5; ++step)
  {
    const RemeshRun run = RunLawfully(input, WantingLayer(input, 0.3 + 0.02 * step));
    ASSERT_FALSE(run.Result.IsUnchanged);
    EXPECT_GT(run.SmallestAngle(), 25.0);
    EXPECT_GT(run.Result.Mesh.Quality.ShareOfEdgesInBand, 0.98);
    input = RemeshInputOf(run.Result.Mesh, Rounding);
  }
}

TEST(Remeshing, PreferencesTradeKeptVerticesForShapes)
{
  const RemeshInput input = RemeshInputOf(SquareMesh(0.03), Rounding);
  RemeshOptions options = WantingLayer(input, 0.5);
  std::vector<double> kept;
  std::vector<double> inBand;
  for (const RemeshPreference preference :
    { RemeshPreference::Keeping, RemeshPreference::Balanced, RemeshPreference::Shape })
  {
    options.Preference = preference;
    const RemeshRun run = RunLawfully(input, options);
    kept.push_back(run.ShareOfKept());
    inBand.push_back(run.Result.Mesh.Quality.ShareOfEdgesInBand);
  }
  EXPECT_GT(kept[0], kept[1]);
  EXPECT_GE(kept[1], kept[2]);
  EXPECT_LT(inBand[0], inBand[1]);
}

TEST(Remeshing, EdgePoliciesHoldVerticesOfEdges)
{
  const RemeshInput input = RemeshInputOf(SquareMesh(0.05), Rounding);
  const auto onBoundary = [](const Point2& p)
  { return p.X == 0.0 || p.Y == 0.0 || p.X == 1.0 || p.Y == 1.0; };
  const auto before = std::count_if(input.Points.begin(), input.Points.end(), onBoundary);
  for (const double spacing : { 0.025, 0.1 })
  {
    RemeshOptions options = WantingUniform(input, spacing);
    options.LimitByFeatureSize = false;
    for (const EdgePolicy policy : { EdgePolicy::Free, EdgePolicy::SplitOnly, EdgePolicy::Frozen })
    {
      options.Edges = policy;
      const RemeshRun run = RunLawfully(input, options);
      const std::vector<Point2>& points = run.Result.Mesh.Points;
      const auto after = std::count_if(points.begin(), points.end(), onBoundary);
      const bool isHeld =
        policy == EdgePolicy::Frozen || (policy == EdgePolicy::SplitOnly && spacing > 0.05);
      EXPECT_TRUE(isHeld ? after == before : (spacing < 0.05 ? after > before : after < before));
    }
  }
}

TEST(Remeshing, WhatIsFrozenStays)
{
  RemeshInput input = RemeshInputOf(SquareMesh(0.03), Rounding);
  input.IsFrozen.assign(input.Corners.size() / 3, 0);
  for (std::size_t triangle = 0; triangle < input.IsFrozen.size(); ++triangle)
  {
    const Point2& corner = input.Points[input.Corners[3 * triangle]];
    input.IsFrozen[triangle] = corner.X < 0.4 && corner.Y < 0.6;
    input.IsFixed[input.Corners[3 * triangle]] |= corner.X > 0.8;
  }
  RunLawfully(input, WantingUniform(input, 0.06));
  RunLawfully(input, WantingUniform(input, 0.015));
}

TEST(Remeshing, TrianglesOfAnyOrientationAreRead)
{
  RemeshInput input = RemeshInputOf(SquareMesh(0.05), Rounding);
  for (std::size_t k = 0; k < input.Corners.size(); k += 6)
  {
    std::swap(input.Corners[k], input.Corners[k + 1]);
  }
  RunLawfully(input, WantingUniform(input, 0.025));
}

TEST(Remeshing, PointsOfFreeEdgesAtOnePlaceAreMadeOne)
{
  RemeshInput input;
  input.Points = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 }, { 0, 0 }, { 1, 1 } };
  input.Corners = { 0, 1, 2, 4, 5, 3 };
  const RemeshRun run = RunLawfully(input, WantingUniform(input, 0.25));
  EXPECT_EQ(run.Problems.Count(ProblemCode::DuplicatePoints), 2);
  EXPECT_EQ(run.Result.Mesh.Kinds.size(), run.Result.Mesh.Points.size());
  // None is left on the diagonal.
  for (std::size_t k = 0; k < run.Result.Mesh.EdgeStarts.size(); ++k)
  {
    const Point2 a = run.Result.Mesh.Points[run.Result.Mesh.EdgeStarts[k]];
    const Point2 b = run.Result.Mesh.Points[run.Result.Mesh.EdgeEnds[k]];
    EXPECT_TRUE(a.X == b.X || a.Y == b.Y);
  }
}

/// A hole as thin as rounding: both of its sides would be the same edge.
TEST(Remeshing, SidesOfAFlatHoleDoNotBecomeOne)
{
  RemeshInput input;
  input.Points = { { 0, 0 }, { 1, 0 }, { 2, 0 }, { 1, 1e-16 }, { 1, -1 }, { 1, 1 } };
  input.Corners = { 0, 4, 1, 1, 4, 2, 0, 3, 5, 3, 2, 5 };
  input.Rounding = Rounding;
  RunLawfully(input, WantingUniform(input, 3.0));
}

/// All that is refused is in OldMeshTest.
TEST(Remeshing, WhatIsNoMeshIsRefusedAndLeavesNoResult)
{
  for (const std::vector<Id>& corners : { std::vector<Id>{ 0, 1, 4 }, { 0, 1, 2, 0, 1, 3 },
         { 0, 1, 2, 0, 2, 3, 0, 2, 4 }, { 0, 1, 2, 0, 2, 3, 5, 6, 7 }, { 0, 1, 2, 3, 5, 6 } })
  {
    RemeshInput input;
    input.Points = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 }, { 2, 0 }, { 0.5, 0.2 }, { 0.8, 0.3 },
      { 0.6, 0.6 } };
    input.Corners = corners;
    const RemeshRun run = RunRemesh(input, WantingUniform(input, 0.1));
    EXPECT_GE(run.Problems.Count(ProblemCode::BadTriangles), 1);
    EXPECT_TRUE(run.Result.Mesh.Points.empty());
  }
}

TEST(Remeshing, ASpacingThatIsNoneIsRefused)
{
  const RemeshInput input = RemeshInputOf(SquareMesh(0.2), Rounding);
  RemeshOptions options = WantingUniform(input, 0.2);
  options.Values[3] = 0.0;
  EXPECT_EQ(RunRemesh(input, options).Problems.Count(ProblemCode::BadSpacing), 1);
  options = WantingUniform(input, 0.2);
  options.Spacing.Scale = -1.0;
  EXPECT_TRUE(RunRemesh(input, options).Problems.Has(ProblemCode::BadSpacing));
}

TEST(Remeshing, TooManyVerticesAreRefused)
{
  const RemeshInput input = RemeshInputOf(SquareMesh(0.2), Rounding);
  RemeshOptions options = WantingUniform(input, 0.001);
  options.MaximumNumberOfVertices = 1000;
  const RemeshRun run = RunRemesh(input, options);
  EXPECT_EQ(run.Problems.Count(ProblemCode::TooManyVertices), 1);
  EXPECT_TRUE(run.Result.Mesh.Points.empty());
}

/// Lines of 1e18 parts are not counted through.
TEST(Remeshing, AnAbsurdSpacingIsRefusedAtOnce)
{
  const RemeshInput input = RemeshInputOf(SquareMesh(0.2), Rounding);
  RemeshOptions options = WantingUniform(input, 1e-18);
  options.LimitByFeatureSize = false;
  EXPECT_TRUE(RunRemesh(input, options).Problems.Has(ProblemCode::TooManyVertices));
}

TEST(Remeshing, AMonitorThatStopsGetsNothing)
{
  const RemeshInput input = RemeshInputOf(SquareMesh(0.03), Rounding);
  for (int calls = 0; calls < 200; calls += 3)
  {
    StoppingMonitor monitor(calls);
    ProblemList problems;
    const RemeshResult result = Remesh(input, WantingUniform(input, 0.01), problems, monitor);
    EXPECT_EQ(result.Mesh.Points.empty(), monitor.HasStopped());
    EXPECT_EQ(problems.Has(ProblemCode::Aborted), monitor.HasStopped());
  }
}

TEST(Remeshing, TheSameInputGivesTheSameBytes)
{
  const RemeshInput input = RemeshInputOf(PlateMesh(0.05), Rounding);
  const RemeshRun one = RunRemesh(input, WantingLayer(input, 0.5));
  const RemeshRun two = RunRemesh(input, WantingLayer(input, 0.5));
  const std::vector<Point2>& points = one.Result.Mesh.Points;
  ASSERT_EQ(points.size(), two.Result.Mesh.Points.size());
  EXPECT_EQ(
    std::memcmp(points.data(), two.Result.Mesh.Points.data(), points.size() * sizeof(Point2)), 0);
  EXPECT_EQ(one.Result.Mesh.Corners, two.Result.Mesh.Corners);
}

/// A quarter of f is not taken once more. Not relaxed: no short edges cap f in the slit.
TEST(Remeshing, WhatWasCappedForFeaturesIsNotCappedByAQuarterAgain)
{
  BitingMeshOptions options;
  options.Spacing.Uniform = 0.1;
  options.Relaxation = false;
  const BitingMesh mesh = RunMesh(PolylineBuilder()
                                    .Box(0.0, 0.0, 1.0, 1.0)
                                    .Box(0.2, 0.3, 0.5, 0.7)
                                    .Box(0.501, 0.3, 0.8, 0.7)
                                    .Lines(),
    options)
                            .Mesh;
  const auto least = [](const BitingMesh& of)
  { return *std::min_element(of.Spacing.begin(), of.Spacing.end()); };
  const RemeshInput input = RemeshInputOf(mesh, Rounding);
  RemeshOptions wanted;
  wanted.Values = mesh.Spacing;
  const RemeshRun run = RunLawfully(input, wanted);
  EXPECT_TRUE(run.Result.IsUnchanged || least(run.Result.Mesh) > 0.9 * least(mesh));
}

TEST(Remeshing, RelaxAllMovesWhatFits)
{
  RemeshInput input = RemeshInputOf(PlateMesh(0.05), Rounding);
  input.IsFrozen.assign(input.Corners.size() / 3, 0);
  input.IsFrozen[17] = 1;
  RemeshOptions options = WantingUniform(input, 0.05);
  options.LimitByFeatureSize = false;
  options.RelaxAll = true;
  const RemeshRun run = RunLawfully(input, options);
  EXPECT_FALSE(run.Result.IsUnchanged);
  EXPECT_LT(run.ShareOfKept(), 0.5);
  EXPECT_GT(run.SmallestAngle(), 30.0);
}

TEST(Remeshing, MoreRingsLetMoreTrianglesChange)
{
  const RemeshInput input = RemeshInputOf(SquareMesh(0.02), Rounding);
  RemeshOptions options = WantingDisc(input, 0.02);
  const std::size_t all = input.Corners.size() / 3;
  std::vector<std::size_t> changed;
  for (const int rings : { 0, 2, std::numeric_limits<int>::max() })
  {
    options.Rings = rings;
    const RemeshRun run = RunLawfully(input, options);
    const std::vector<Id>& originals = run.Result.OriginalTriangles;
    changed.push_back(run.Result.ChangedTriangles.size());
    const auto isNew = std::count(originals.begin(), originals.end(), NoId);
    EXPECT_GE(originals.size() - static_cast<std::size_t>(isNew), all - changed.back());
  }
  EXPECT_LT(changed[0], changed[1]);
  EXPECT_LT(changed[1], changed[2]);
  EXPECT_EQ(changed[2], all);
}

TEST(Remeshing, ASteepSpacingIsLimitedToTheGradation)
{
  const RemeshInput input = RemeshInputOf(SquareMesh(0.03), Rounding);
  RemeshOptions options = Wanting(input, [](const Point2& p) { return p.X < 0.5 ? 0.008 : 0.1; });
  const RemeshRun run = RunLawfully(input, options);
  EXPECT_LT(run.Result.Mesh.UsedLipschitz, 0.35);
  EXPECT_GT(run.SmallestAngle(), 25.0);
}

} // namespace biting
