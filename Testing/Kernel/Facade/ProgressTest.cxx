// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "../Support/MeshRun.h"
#include "../Support/MeshShapes.h"
#include "../Support/Monitors.h"

#include "Stages/MeshingStages.h"

#include <gtest/gtest.h>

#include <algorithm> // for max_element
#include <cmath>     // for sqrt
#include <cstddef>   // for differences
#include <memory>    // for sources

namespace biting
{

namespace
{

enum StageId
{
  DomainStage,
  SimplificationStage,
  SpacingStage,
  BitingStage,
  TriangulationStage,
  RelaxationStage,
  QualityStage
};

/// A square with a hole, an interface, an embedded point, and input to repair.
Polylines Drawing(int cornersOfHole)
{
  return PolylineBuilder()
    .Box(0.0, 0.0, 1.0, 1.0)
    .Loop(RegularPolygon({ 0.5, 0.5 }, 0.2, cornersOfHole))
    .Chain({ { 0.0, 0.125 }, { 1.0, 0.125 } })
    .Chain({ { 0.25, 0.0 }, { 0.25, 1.0 } })
    .Chain({ { 0.75, 0.875 } }, ChainKind::EmbeddedPoint)
    .Lines();
}

BitingMeshOptions UniformOptions(double vertices)
{
  BitingMeshOptions options;
  options.Spacing = UniformSpacing(std::sqrt(1.25 / vertices));
  return options;
}

/// Values along the loop, as a boundary array gives them.
std::shared_ptr<SegmentSource> BoundaryValues(const Polylines& loop)
{
  auto source = std::make_shared<SegmentSource>();
  source->Points = loop.Points;
  source->Values.assign(loop.Points.size(), 0.05);
  for (std::size_t k = 0; k + 1 < loop.Connectivity.size(); ++k)
  {
    source->Segments.push_back(loop.Connectivity[k]);
    source->Segments.push_back(loop.Connectivity[k + 1]);
  }
  return source;
}

RecordingMonitor Watch(const Polylines& input, const BitingMeshOptions& options)
{
  RecordingMonitor monitor;
  ProblemList problems;
  EXPECT_FALSE(MakeBitingMesh(input, options, problems, monitor).Points.empty());
  return monitor;
}

/// Whether the stage asks more often where there is much more to do.
void ExpectGrowth(StageId stage, const RecordingMonitor& few, const RecordingMonitor& many)
{
  EXPECT_GT(many.CallsOfStages[stage], few.CallsOfStages[stage]) << few.Stages[stage];
  EXPECT_GE(many.CallsOfStages[stage], 8) << few.Stages[stage];
}

void ExpectAbortEverywhere(const Polylines& input, const BitingMeshOptions& options)
{
  for (int calls = 0;; ++calls)
  {
    StoppingMonitor monitor(calls);
    ProblemList problems;
    const BitingMesh mesh = MakeBitingMesh(input, options, problems, monitor);
    ASSERT_EQ(problems.Has(ProblemCode::Aborted), monitor.HasStopped()) << calls;
    ASSERT_EQ(mesh.Points.empty(), monitor.HasStopped()) << calls;
    if (!monitor.HasStopped())
    {
      EXPECT_GT(calls, 20);
      return;
    }
    ASSERT_TRUE(mesh.Corners.empty() && mesh.EdgeStarts.empty() && mesh.Front.empty());
    ASSERT_EQ(monitor.Calls, calls + 1) << "asked again after it wanted to stop";
  }
}

TEST(Progress, AbortAtAnyCallLeavesNoMesh)
{
  ExpectAbortEverywhere(Drawing(24), UniformOptions(600.0));
}

TEST(Progress, AbortAtAnyCallLeavesNoMeshWhereBitingEndsEarly)
{
  BitingMeshOptions options = UniformOptions(600.0);
  options.KeepBites = true;
  options.MaximumNumberOfBites = 300;
  options.Phi = 0.5;
  ExpectAbortEverywhere(Drawing(24), options);
}

TEST(Progress, AbortAtAnyCallLeavesNoMeshWhereTheBoundaryIsPreserved)
{
  BitingMeshOptions options = UniformOptions(150.0);
  options.PreserveBoundary = true;
  ExpectAbortEverywhere(Drawing(20), options);
}

TEST(Progress, AbortAtAnyCallLeavesNoMeshWhereTheDrawingIsSimplified)
{
  BitingMeshOptions options = UniformOptions(300.0);
  options.Simplification.Tolerance = 0.2;
  options.Simplification.MinimumLoopSize = 1.0;
  ExpectAbortEverywhere(Drawing(400), options);
}

TEST(Progress, AbortAtAnyCallLeavesNoMeshWithBoundaryValues)
{
  const Polylines loop = PolylineBuilder().Loop(RegularPolygon({ 0.0, 0.0 }, 1.0, 60)).Lines();
  BitingMeshOptions options;
  options.Spacing.Sources.emplace_back(BoundaryValues(loop));
  ExpectAbortEverywhere(loop, options);
}

/// Values that are fine enough for the question how many vertices there will be.
TEST(Progress, AbortAtAnyCallLeavesNoMeshWhereTheForecastIsAsked)
{
  const Polylines loop = PolylineBuilder().Loop(RegularPolygon({ 0.0, 0.0 }, 1.0, 40)).Lines();
  BitingMeshOptions options;
  auto values = BoundaryValues(loop);
  for (std::size_t k = 0; k < values->Values.size(); k += 2)
  {
    values->Values[k] = 1e-6;
  }
  options.Spacing.Sources.emplace_back(values);
  options.MaximumNumberOfVertices = 1000;
  for (int calls = 0;; calls += 7)
  {
    StoppingMonitor monitor(calls);
    ProblemList problems;
    EXPECT_TRUE(MakeBitingMesh(loop, options, problems, monitor).Points.empty());
    ASSERT_EQ(problems.Has(ProblemCode::Aborted), monitor.HasStopped()) << calls;
    ASSERT_NE(problems.Has(ProblemCode::TooManyVertices), monitor.HasStopped()) << calls;
    ASSERT_LE(monitor.Calls, calls + 1) << "asked again after it wanted to stop";
    if (!monitor.HasStopped())
    {
      EXPECT_GT(calls, 20);
      return;
    }
  }
}

/// Two interfaces from one point, far from the origin, hardly wide enough not to be one: rounded
/// points of the one are beyond the other.
Polylines NarrowWedge()
{
  const double away = 1 << 27;
  const double ulp = 1.0 / (1 << 25);
  return PolylineBuilder()
    .Box(away, away, away + 1.0, away + 1.0)
    .Chain({ { away, away }, { away + 0.875, away + 0.875 } })
    .Chain({ { away, away }, { away + 0.875, away + 0.875 + 6.0 * ulp } })
    .Lines();
}

TEST(Progress, AbortAtAnyCallLeavesNoMeshWhereDivisionsAreUndone)
{
  BitingMeshOptions options;
  options.Spacing = UniformSpacing(0.06);
  options.Domain.EndTolerance = 0.0; // the wedge stays open
  options.LimitByFeatureSize = false;
  options.Relaxation = false;
  const RecordingMonitor monitor = Watch(NarrowWedge(), options);
  const auto begin = monitor.Fractions.begin();
  const auto first = begin + static_cast<std::ptrdiff_t>(monitor.Begins[TriangulationStage]);
  const auto last = begin + static_cast<std::ptrdiff_t>(monitor.Begins[RelaxationStage]);
  ASSERT_GT(*std::max_element(first, last), 0.901) << "one attempt was enough";
  ExpectAbortEverywhere(NarrowWedge(), options);
}

TEST(Progress, NamesTheStagesInTheirOrder)
{
  const RecordingMonitor monitor = Watch(Drawing(24), UniformOptions(1000.0));
  ASSERT_EQ(monitor.Stages.size(), MeshingStages::InOrder.size());
  double shares = 0.0;
  for (std::size_t stage = 0; stage < monitor.Stages.size(); ++stage)
  {
    EXPECT_EQ(monitor.Stages[stage], MeshingStages::InOrder[stage].Text);
    shares += MeshingStages::InOrder[stage].Share;
  }
  EXPECT_NEAR(shares, 1.0, 1e-12);
}

TEST(Progress, DoesNotFallWithinAStage)
{
  BitingMeshOptions early = UniformOptions(10000.0);
  early.KeepBites = true;
  early.MaximumNumberOfBites = 3000;
  for (const BitingMeshOptions& options : { UniformOptions(500.0), UniformOptions(30000.0), early })
  {
    const RecordingMonitor monitor = Watch(Drawing(1000), options);
    std::vector<std::size_t> ends(monitor.Begins.begin() + 1, monitor.Begins.end());
    ends.push_back(monitor.Fractions.size());
    for (std::size_t stage = 0; stage < ends.size(); ++stage)
    {
      double last = 0.0;
      for (std::size_t call = monitor.Begins[stage]; call < ends[stage]; ++call)
      {
        ASSERT_GE(monitor.Fractions[call], last) << monitor.Stages[stage];
        ASSERT_LE(monitor.Fractions[call], 1.0) << monitor.Stages[stage];
        last = monitor.Fractions[call];
      }
    }
  }
}

TEST(Progress, MovesThroughTheWholeOfLongStages)
{
  const RecordingMonitor monitor = Watch(Drawing(24), UniformOptions(50000.0));
  for (const StageId stage : { BitingStage, TriangulationStage, RelaxationStage, QualityStage })
  {
    const std::size_t begin = monitor.Begins[stage];
    const std::size_t end =
      stage == QualityStage ? monitor.Fractions.size() : monitor.Begins[stage + 1];
    for (std::size_t call = begin + 1; call < end; ++call)
    {
      EXPECT_LT(monitor.Fractions[call] - monitor.Fractions[call - 1], 0.25)
        << monitor.Stages[stage];
    }
    EXPECT_GT(monitor.Fractions[end - 1], 0.75) << monitor.Stages[stage];
  }
}

TEST(Progress, IsToldMoreOftenTheMoreVerticesThereAre)
{
  const RecordingMonitor few = Watch(Drawing(24), UniformOptions(10000.0));
  const RecordingMonitor many = Watch(Drawing(24), UniformOptions(80000.0));
  for (const StageId stage : { BitingStage, TriangulationStage, RelaxationStage, QualityStage })
  {
    ExpectGrowth(stage, few, many);
  }
}

TEST(Progress, IsToldMoreOftenTheMoreSegmentsThereAre)
{
  const RecordingMonitor few = Watch(Drawing(1000), UniformOptions(1000.0));
  const RecordingMonitor many = Watch(Drawing(8000), UniformOptions(1000.0));
  for (const StageId stage : { DomainStage, TriangulationStage, RelaxationStage, QualityStage })
  {
    ExpectGrowth(stage, few, many);
  }
}

TEST(Progress, IsToldMoreOftenTheMoreNodesAGridHas)
{
  std::vector<RecordingMonitor> monitors;
  for (const std::size_t count : { 50u, 400u })
  {
    auto grid = std::make_shared<GridSource>();
    for (std::size_t k = 0; k < count; ++k)
    {
      grid->XNodes.push_back(static_cast<double>(k) / static_cast<double>(count - 1));
    }
    grid->YNodes = grid->XNodes;
    grid->Values.assign(count * count, 0.1);
    grid->Values[count] = 0.05;
    BitingMeshOptions options;
    options.Spacing.Sources.emplace_back(grid);
    monitors.push_back(Watch(Drawing(24), options));
  }
  ExpectGrowth(SpacingStage, monitors[0], monitors[1]);
}

TEST(Progress, IsToldMoreOftenTheMoreTrianglesASourceHas)
{
  std::vector<RecordingMonitor> monitors;
  for (const double vertices : { 500.0, 30000.0 })
  {
    const MeshRun run =
      RunMesh(PolylineBuilder().Box(0.0, 0.0, 1.0, 1.0).Lines(), UniformOptions(vertices));
    auto source = std::make_shared<TriangulatedSource>();
    source->Points = run.Mesh.Points;
    source->Triangles = run.Mesh.Corners;
    source->Values.assign(source->Points.size(), 0.1);
    source->Values.back() = 0.05;
    BitingMeshOptions options;
    options.Spacing.Sources.emplace_back(source);
    monitors.push_back(Watch(Drawing(24), options));
  }
  ExpectGrowth(SpacingStage, monitors[0], monitors[1]);
}

TEST(Progress, IsToldMoreOftenTheMoreBoundaryValuesThereAre)
{
  std::vector<RecordingMonitor> monitors;
  for (const int count : { 500, 16000 })
  {
    const Polylines loop = PolylineBuilder().Loop(RegularPolygon({ 0.0, 0.0 }, 1.0, count)).Lines();
    BitingMeshOptions options;
    options.Spacing.Sources.emplace_back(BoundaryValues(loop));
    monitors.push_back(Watch(loop, options));
  }
  ExpectGrowth(SpacingStage, monitors[0], monitors[1]);
}

} // namespace

} // namespace biting
