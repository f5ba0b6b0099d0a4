// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

// Meshes of several blocks, through the facade: it checks each of them as it does all meshes.

#include "../Support/MeshShapes.h"
#include "../Support/PolylineShapes.h"
#include "../Support/SameMesh.h"
#include "../Support/TestThreads.h"

#include "BitingMesh.h"

#include <gtest/gtest.h>

#include <algorithm> // for sort
#include <cmath>     // for sqrt, cos, sin
#include <ctime>     // for CPU time
#include <map>       // for sums
#include <numeric>   // for accumulate
#include <string>    // for names
#include <vector>    // for cases

namespace biting
{

namespace
{

struct Case
{
  std::string Name;
  Polylines Drawing;
  SpacingOptions Spacing;
};

/// A square with a hole, interfaces that meet, and an embedded point.
Polylines Plan()
{
  return PolylineBuilder()
    .Box(0.0, 0.0, 1.0, 1.0)
    .Loop(RegularPolygon({ 0.5, 0.5 }, 0.2, 40))
    .Chain({ { 0.0, 0.125 }, { 1.0, 0.125 } })
    .Chain({ { 0.25, 0.0 }, { 0.25, 1.0 } })
    .Chain({ { 0.75, 0.875 } }, ChainKind::EmbeddedPoint)
    .Lines();
}

/// Squares apart from each other, each with a hole.
Polylines Islands()
{
  PolylineBuilder builder;
  for (int k = 0; k < 9; ++k)
  {
    const double x = 1.5 * (k % 3);
    const double y = 1.5 * (k / 3);
    builder.Box(x, y, x + 1.0, y + 1.0).Box(x + 0.4, y + 0.4, x + 0.6, y + 0.6);
  }
  return builder.Lines();
}

/// As fine as f.
Polylines RoughDisc()
{
  std::vector<Point2> loop = RegularPolygon({ 0.0, 0.0 }, 1.0, 300);
  for (std::size_t k = 0; k < loop.size(); ++k)
  {
    loop[k] = (1.0 + 0.008 * static_cast<double>(37 * k % 11)) * loop[k];
  }
  return PolylineBuilder().Loop(loop).Lines();
}

SpacingOptions Section6Scaled(double scale)
{
  SpacingOptions spacing = SectionSixSpacing();
  spacing.Scale = scale;
  return spacing;
}

std::vector<Case> Cases()
{
  return { { "square", PolylineBuilder().Box(0.0, 0.0, 1.0, 1.0).Lines(), UniformSpacing(0.012) },
    { "plan", Plan(), UniformSpacing(0.012) },
    { "disc", PolylineBuilder().Loop(RegularPolygon({ 0.0, 0.0 }, 1.0, 90)).Lines(),
      UniformSpacing(0.02) },
    { "rough disc", RoughDisc(), UniformSpacing(0.02) },
    { "ell", PolylineBuilder().Loop(EllShape(1.0)).Lines(), UniformSpacing(0.011) },
    { "comb", PolylineBuilder().Loop(Comb(12, 0.5)).Lines(), UniformSpacing(0.05) },
    { "islands", Islands(), UniformSpacing(0.03) },
    { "section 6", PolylineBuilder().Box(0.0, 0.0, 9.0, 9.0).Lines(), Section6Scaled(1.2) },
    { "radial", PolylineBuilder().Box(-1.0, -1.0, 1.0, 1.0).Lines(),
      RadialSpacing({ 0.1, 0.2 }, 0.002, 0.1) } };
}

BitingMesh MeshOf(const Case& input, std::int64_t verticesPerBlock, int numberOfThreads = 1)
{
  BitingMeshOptions options;
  options.Spacing = input.Spacing;
  options.VerticesPerBlock = verticesPerBlock;
  ProblemList problems;
  MonitorWithThreads monitor(numberOfThreads);
  BitingMesh mesh = MakeBitingMesh(input.Drawing, options, problems, monitor);
  EXPECT_FALSE(problems.HasErrors()) << input.Name;
  return mesh;
}

Case TurnedSquare(double turn, double f)
{
  const Point2 side{ std::cos(turn), std::sin(turn) };
  return { "square turned by " + std::to_string(turn),
    PolylineBuilder()
      .Loop({ { 0.0, 0.0 }, side, side + Perpendicular(side), Perpendicular(side) })
      .Lines(),
    UniformSpacing(f) };
}

double SecondsOfProcess()
{
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

double MeanAngle(const BitingMesh& mesh)
{
  const std::vector<double>& angles = mesh.Quality.MinimumAngle;
  return std::accumulate(angles.begin(), angles.end(), 0.0) / static_cast<double>(angles.size());
}

/// Of the triangles, the smallest but one in a hundred.
double OnePercentAngle(const BitingMesh& mesh)
{
  std::vector<double> angles = mesh.Quality.MinimumAngle;
  std::sort(angles.begin(), angles.end());
  return angles[angles.size() / 100];
}

/// Of each region.
std::map<Id, double> Areas(const BitingMesh& mesh)
{
  std::map<Id, double> areas;
  for (std::size_t t = 0; t < mesh.Regions.size(); ++t)
  {
    const Point2& a = mesh.Points[mesh.Corners[3 * t]];
    areas[mesh.Regions[t]] += 0.5 *
      Cross(mesh.Points[mesh.Corners[3 * t + 1]] - a, mesh.Points[mesh.Corners[3 * t + 2]] - a);
  }
  return areas;
}

/// Of the edges of each cell of the input.
std::map<Id, double> Lengths(const BitingMesh& mesh)
{
  std::map<Id, double> lengths;
  for (std::size_t e = 0; e < mesh.EdgeStarts.size(); ++e)
  {
    lengths[mesh.EdgeCells[e]] +=
      Distance(mesh.Points[mesh.EdgeStarts[e]], mesh.Points[mesh.EdgeEnds[e]]);
  }
  return lengths;
}

void ExpectNear(const std::map<Id, double>& sums, const std::map<Id, double>& others)
{
  ASSERT_EQ(sums.size(), others.size());
  for (const auto& [id, sum] : sums)
  {
    EXPECT_NEAR(sum, others.at(id), 1e-9 * sum) << id;
  }
}

} // namespace

TEST(BlockMesher, MeshesAreTheSameToTheLastByteForAnyNumberOfThreads)
{
  for (const Case& input : Cases())
  {
    SCOPED_TRACE(input.Name);
    const BitingMesh alone = MeshOf(input, 500);
    for (const int numberOfThreads : { 2, 3, 8 })
    {
      ExpectSame(MeshOf(input, 500, numberOfThreads), alone);
    }
  }
}

/// Cuts are so long that what lies along them is relaxed part by part.
TEST(BlockMesher, LongStripsAreTheSameToTheLastByteForAnyNumberOfThreads)
{
  const Case input{ "plan", Plan(), UniformSpacing(0.0045) };
  const BitingMesh alone = MeshOf(input, 4000);
  EXPECT_GT(alone.NumberOfBlocks, 8);
  for (const int numberOfThreads : { 2, 3, 8 })
  {
    ExpectSame(MeshOf(input, 4000, numberOfThreads), alone);
  }
}

TEST(BlockMesher, BlocksDifferFromOneBlockInTheMeshOnly)
{
  constexpr std::int64_t VerticesPerBlock = 800;
  for (const Case& input : Cases())
  {
    SCOPED_TRACE(input.Name);
    const BitingMesh whole = MeshOf(input, 0);
    const BitingMesh blocks = MeshOf(input, VerticesPerBlock);
    EXPECT_NE(whole.Corners, blocks.Corners) << "no cut";
    ExpectNear(Areas(blocks), Areas(whole));
    ExpectNear(Lengths(blocks), Lengths(whole));
    EXPECT_NEAR(static_cast<double>(blocks.Points.size()), static_cast<double>(whole.Points.size()),
      0.025 * static_cast<double>(whole.Points.size()));
    for (std::size_t vertex = 0; vertex < whole.OriginalPoints.size(); ++vertex)
    {
      if (whole.OriginalPoints[vertex] != NoId)
      {
        EXPECT_EQ(blocks.OriginalPoints[vertex], whole.OriginalPoints[vertex]);
        EXPECT_TRUE(blocks.Points[vertex] == whole.Points[vertex]);
      }
    }
  }
}

/// Defects of a lattice lie on lines: what a cut costs falls with the diameter of the blocks. So a
/// block of 128 000 vertices may cost 0.15 degrees and .002, and one of 2 000 eight times as much.
/// Relaxation works on angles below 40 degrees.
TEST(BlockMesher, CutsAreHardlySeenInFigures)
{
  constexpr std::int64_t VerticesPerBlock = 2000;
  const double diameters = std::sqrt(128000.0 / static_cast<double>(VerticesPerBlock));
  for (const Case& input : Cases())
  {
    SCOPED_TRACE(input.Name);
    const BitingMesh whole = MeshOf(input, 0);
    const BitingMesh blocks = MeshOf(input, VerticesPerBlock);
    EXPECT_GT(MeanAngle(blocks), MeanAngle(whole) - 0.15 * diameters);
    EXPECT_GT(blocks.Quality.MeanConformity, whole.Quality.MeanConformity - 0.002 * diameters);
    EXPECT_GT(blocks.Quality.SmallestAngle, std::min(40.0, whole.Quality.SmallestAngle - 1.0));
    EXPECT_NEAR(blocks.Quality.MeanRelativeLength, whole.Quality.MeanRelativeLength, 0.01);
  }
}

TEST(BlockMesher, LargeBlocksAreAsGoodAsOneBlock)
{
  constexpr std::int64_t VerticesPerBlock = 64000;
  for (const Case& input :
    { Case{ "square", PolylineBuilder().Box(0.0, 0.0, 1.0, 1.0).Lines(), UniformSpacing(0.00196) },
      Case{
        "section 6", PolylineBuilder().Box(0.0, 0.0, 9.0, 9.0).Lines(), Section6Scaled(0.094) } })
  {
    SCOPED_TRACE(input.Name);
    const BitingMesh whole = MeshOf(input, 0);
    const BitingMesh blocks = MeshOf(input, VerticesPerBlock, 2);
    EXPECT_NE(whole.Corners, blocks.Corners) << "no cut";
    EXPECT_GT(MeanAngle(blocks), MeanAngle(whole) - 0.15);
    EXPECT_GT(OnePercentAngle(blocks), OnePercentAngle(whole) - 0.5);
    EXPECT_GT(blocks.Quality.MeanConformity, whole.Quality.MeanConformity - 0.002);
    EXPECT_GT(blocks.Quality.SmallestAngle, whole.Quality.SmallestAngle - 1.0);
  }
}

/// Fronts of all cuts make one lattice where f is level: blocks of 5,000 vertices do not show.
TEST(BlockMesher, WhereTheSpacingIsLevelManyBlocksAreAsGoodAsOne)
{
  const Case square{ "", PolylineBuilder().Box(0.0, 0.0, 1.0, 1.0).Lines(),
    UniformSpacing(0.00315) };
  const BitingMesh whole = MeshOf(square, 0);
  const BitingMesh blocks = MeshOf(square, 5000, 2);
  EXPECT_GE(blocks.NumberOfBlocks, 16);
  EXPECT_GT(MeanAngle(blocks), MeanAngle(whole) - 0.15);
  EXPECT_GT(OnePercentAngle(blocks), OnePercentAngle(whole) - 1.0);
  EXPECT_GT(blocks.Quality.MeanConformity, whole.Quality.MeanConformity - 0.002);
  EXPECT_GT(blocks.Quality.SmallestAngle, whole.Quality.SmallestAngle - 1.0);
}

/// Cuts are parallel to the sides; rows of the hexagon's lattice are, too.
TEST(BlockMesher, HoweverADrawingIsTurnedManyBlocksAreAsGoodAsOne)
{
  for (const Case& input : { TurnedSquare(0.3, 0.0028), TurnedSquare(0.785, 0.0028),
         Case{ "hexagon", PolylineBuilder().Loop(RegularPolygon({ 0.0, 0.0 }, 1.0, 6)).Lines(),
           UniformSpacing(0.0045) } })
  {
    SCOPED_TRACE(input.Name);
    const BitingMesh whole = MeshOf(input, 0);
    const BitingMesh blocks = MeshOf(input, 16000);
    EXPECT_GE(blocks.NumberOfBlocks, 8);
    EXPECT_GT(MeanAngle(blocks), MeanAngle(whole) - 0.15);
    EXPECT_GT(OnePercentAngle(blocks), OnePercentAngle(whole) - 0.5);
    EXPECT_GT(blocks.Quality.MeanConformity, whole.Quality.MeanConformity - 0.002);
    EXPECT_GT(blocks.Quality.SmallestAngle, whole.Quality.SmallestAngle - 1.0);
  }
}

/// Fronts of the sides and of the cuts make one lattice, however many sides fit into the width.
TEST(BlockMesher, HexagonsInBlocksAreAsGoodAsOneBlock)
{
  for (const double f : { 0.0061, 0.00612, 0.0071 })
  {
    const Case input{ "hexagon",
      PolylineBuilder().Loop(RegularPolygon({ 0.0, 0.0 }, 1.0, 6)).Lines(), UniformSpacing(f) };
    const BitingMesh whole = MeshOf(input, 0);
    const BitingMesh blocks = MeshOf(input, 5000);
    EXPECT_GE(blocks.NumberOfBlocks, 8);
    EXPECT_GT(blocks.Quality.SmallestAngle, whole.Quality.SmallestAngle - 1.0) << f;
    EXPECT_GT(MeanAngle(blocks), MeanAngle(whole) - 0.15) << f;
  }
}

/// Vertices of the boundary near the ends of cuts slide, and go, as all others do. Relaxation works
/// on angles below 44 degrees there.
TEST(BlockMesher, WhereCutsMeetTheBoundaryAtASlantAnglesAreAsInOneBlock)
{
  for (const Case& input :
    { Case{ "triangle",
        PolylineBuilder().Loop({ { 0.0, 0.0 }, { 1.0, 0.1 }, { 0.35, 0.9 } }).Lines(),
        UniformSpacing(0.002885) },
      Case{ "octagon", PolylineBuilder().Loop(RegularPolygon({ 0.0, 0.0 }, 1.0, 8)).Lines(),
        UniformSpacing(0.0074) },
      Case{ "pentagon", PolylineBuilder().Loop(RegularPolygon({ 0.0, 0.0 }, 1.0, 5)).Lines(),
        UniformSpacing(0.0068) } })
  {
    SCOPED_TRACE(input.Name);
    const BitingMesh whole = MeshOf(input, 0);
    const BitingMesh blocks = MeshOf(input, 8000);
    EXPECT_GE(blocks.NumberOfBlocks, 7);
    EXPECT_GT(blocks.Quality.SmallestAngle, std::min(43.0, whole.Quality.SmallestAngle - 1.0));
  }
}

TEST(BlockMesher, BelowTwoBlocksTheMeshIsThatOfOne)
{
  const Case square = Cases().front();
  const BitingMesh whole = MeshOf(square, 0);
  const auto size = static_cast<std::int64_t>(whole.Points.size());
  ExpectSame(MeshOf(square, size), whole);
}

TEST(BlockMesher, WhatHasAnOrderKeepsOneBlock)
{
  const Case square = Cases().front();
  BitingMeshOptions options;
  options.Spacing = square.Spacing;
  std::vector<BitingMeshOptions> all(5, options);
  all[0].Order = FrontOrder::LargestY;
  all[1].MaximumNumberOfBites = 1000000;
  all[2].KeepBites = true;
  all[3].Relaxation = false;
  all[4].PreserveBoundary = true;
  for (BitingMeshOptions& one : all)
  {
    ProblemList problems;
    SilentMonitor monitor;
    one.VerticesPerBlock = 0;
    const BitingMesh whole = MakeBitingMesh(square.Drawing, one, problems, monitor);
    one.VerticesPerBlock = 500;
    ExpectSame(MakeBitingMesh(square.Drawing, one, problems, monitor), whole);
  }
}

TEST(BlockMesher, StopsWhereverTheMonitorWantsToOnAnyNumberOfThreads)
{
  class Stopping : public MonitorWithThreads
  {
  public:
    Stopping(int numberOfThreads, int calls)
      : MonitorWithThreads(numberOfThreads)
      , CallsUntilStop(calls)
    {
    }
    bool Advance(double) override { return this->CallsUntilStop-- > 0; }

  private:
    int CallsUntilStop;
  };

  const Case plan = Cases()[1];
  BitingMeshOptions options;
  options.Spacing = plan.Spacing;
  options.VerticesPerBlock = 800;
  for (const int numberOfThreads : { 1, 3 })
  {
    for (int calls = 0; calls < 400; calls = 2 * calls + 1)
    {
      ProblemList problems;
      Stopping monitor(numberOfThreads, calls);
      const BitingMesh mesh = MakeBitingMesh(plan.Drawing, options, problems, monitor);
      EXPECT_EQ(mesh.Points.empty(), problems.Has(ProblemCode::Aborted));
      EXPECT_FALSE(problems.Has(ProblemCode::CheckFailed));
    }
  }
}

/// Of CPU time, which other programs do not make longer.
TEST(BlockMesher, StopsWithinHalfASecondFromAnyStep)
{
  class StoppingByTime : public MonitorWithThreads
  {
  public:
    explicit StoppingByTime(double seconds)
      : MonitorWithThreads(2)
      , End(SecondsOfProcess() + seconds)
    {
    }
    bool Advance(double) override { return SecondsOfProcess() < this->End; }

    const double End;
  };

  const Polylines square = PolylineBuilder().Box(0.0, 0.0, 1.0, 1.0).Lines();
  BitingMeshOptions options;
  options.Spacing = UniformSpacing(0.00196);
  bool wasStopped = true;
  for (double seconds = 0.05; wasStopped; seconds *= 1.7)
  {
    ProblemList problems;
    StoppingByTime monitor(seconds);
    const BitingMesh mesh = MakeBitingMesh(square, options, problems, monitor);
    wasStopped = problems.Has(ProblemCode::Aborted);
    EXPECT_EQ(mesh.Points.empty(), wasStopped);
    EXPECT_TRUE(!wasStopped || SecondsOfProcess() - monitor.End < 0.5) << seconds;
    EXPECT_TRUE(wasStopped || mesh.NumberOfBlocks > 1);
  }
}

TEST(BlockMesher, RefusesTooManyVertices)
{
  BitingMeshOptions options;
  options.Spacing = UniformSpacing(0.01);
  options.VerticesPerBlock = 500;
  options.MaximumNumberOfVertices = 5000;
  ProblemList problems;
  SilentMonitor monitor;
  const BitingMesh mesh =
    MakeBitingMesh(PolylineBuilder().Box(0.0, 0.0, 1.0, 1.0).Lines(), options, problems, monitor);
  EXPECT_TRUE(mesh.Points.empty());
  EXPECT_EQ(problems.Count(ProblemCode::TooManyVertices), 1);
}

} // namespace biting
