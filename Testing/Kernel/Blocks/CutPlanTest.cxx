// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "../Support/MeshShapes.h"
#include "../Support/PolylineShapes.h"

#include "Blocks/BlockDomains.h"
#include "Blocks/CutPlan.h"
#include "Blocks/CutRows.h"
#include "Blocks/DensitySamples.h"
#include "Domain/DomainLocator.h"

#include <gtest/gtest.h>

#include <algorithm> // for any_of, all_of, count_if, find_if
#include <numeric>   // for accumulate

namespace biting
{

namespace
{

struct Scene
{
  Scene(const Polylines& drawing, double length)
    : Made(Make(drawing).Domain)
    , Locator(Made)
  {
    ProblemList problems;
    SilentMonitor monitor;
    this->F = MakeSpacing(UniformSpacing(length), this->Made.Bounds, problems, monitor);
  }

  CutPlan PlanOf(double vertices, double verticesPerBlock)
  {
    SilentMonitor monitor;
    Pulse pulse(monitor);
    return PlanCuts(this->Made, this->Locator, this->F, { vertices, verticesPerBlock, 1.0 }, pulse);
  }

  BlockDomains Divide(const CutPlan& plan) const
  {
    return MakeBlockDomains(this->Made, this->F, plan, { 0.824, 1.0, 100000 }, NoMonitor());
  }

  Domain Made;
  DomainLocator Locator;
  Spacing F;
};

/// Whether the piece is all of its segment.
bool IsUncut(const BlockDomains& parts, Id piece)
{
  const Id segment = parts.Graph.Pieces[piece].Segment;
  return std::count_if(parts.Graph.Pieces.begin(), parts.Graph.Pieces.end(),
           [segment](const CutGraph::Piece& other) { return other.Segment == segment; }) == 1;
}

/// Whether of each pair both segments, uncut, are of the same block.
bool TouchesAreWithinBlocks(const CutPlan& plan, const BlockDomains& parts)
{
  const auto hasAll = [&parts](const BlockDomain& block, Id segment)
  {
    return std::any_of(block.Pieces.begin(), block.Pieces.end(),
      [&parts, segment](Id piece)
      { return parts.Graph.Pieces[piece].Segment == segment && IsUncut(parts, piece); });
  };
  return std::all_of(plan.Touches.Pairs.begin(), plan.Touches.Pairs.end(),
    [&parts, &hasAll](const NearTouches::Pair& pair)
    {
      return std::any_of(parts.Blocks.begin(), parts.Blocks.end(),
        [&hasAll, &pair](const BlockDomain& block)
        { return hasAll(block, pair.First) && hasAll(block, pair.Second); });
    });
}

/// Of Koch: each side is replaced by four of a third of its length, again and again.
std::vector<Point2> Snowflake(int depth)
{
  std::vector<Point2> points = RegularPolygon({ 0.0, 0.0 }, 1.0, 3);
  for (int step = 0; step < depth; ++step)
  {
    std::vector<Point2> finer;
    for (std::size_t k = 0; k < points.size(); ++k)
    {
      const Point2& start = points[k];
      const Point2 third = 1.0 / 3.0 * (points[(k + 1) % points.size()] - start);
      const Point2 top = start + 1.5 * third - 0.5 * CutRows::Pair * Perpendicular(third);
      finer.insert(finer.end(), { start, start + third, top, start + 2.0 * third });
    }
    points = finer;
  }
  return points;
}

Polylines Square()
{
  return PolylineBuilder().Box(0.0, 0.0, 1.0, 1.0).Lines();
}

} // namespace

TEST(DensitySamples, AddUpToTheIntegral)
{
  const Polylines drawing =
    PolylineBuilder().Box(0.0, 0.0, 1.0, 1.0).Loop(RegularPolygon({ 0.5, 0.5 }, 0.2, 40)).Lines();
  const Scene scene(drawing, 0.01);
  SilentMonitor monitor;
  Pulse pulse(monitor);
  double sum = 0.0;
  for (const DensitySample& sample :
    SampleDensity(scene.Made, scene.Locator, scene.F, 100.0, 100000, pulse))
  {
    EXPECT_LE(sample.Density, 100.0);
    sum += sample.Density;
  }
  EXPECT_NEAR(sum, scene.Made.Area * 1e4, 0.01 * scene.Made.Area * 1e4);
}

TEST(CutPlan, BlocksHaveAboutTheSize)
{
  Scene scene(Square(), 0.005);
  const CutPlan plan = scene.PlanOf(46000.0, 3000.0);
  double sum = 0.0;
  for (const CutTree::Node& node : plan.Tree.Nodes)
  {
    if (node.Children == NoId)
    {
      EXPECT_LT(node.Vertices, 1.5 * 3000.0);
      EXPECT_GT(node.Vertices, 0.3 * 1.5 * 3000.0); // the smaller side of the last cut
      sum += node.Vertices;
    }
  }
  EXPECT_NEAR(sum, 46000.0, 1e-6 * 46000.0);
}

/// Along the lines between fine and coarse there are more vertices than across.
TEST(CutPlan, IsCutWhereFewVerticesLieOnTheCut)
{
  Scene scene(PolylineBuilder().Box(0.0, 0.0, 9.0, 9.0).Lines(), 1.0);
  ProblemList problems;
  scene.F = MakeSpacing(SectionSixSpacing(), scene.Made.Bounds, problems, NoMonitor());
  const CutPlan plan = scene.PlanOf(300000.0, 140000.0);
  ASSERT_EQ(plan.Tree.NumberOfLeaves, 2);
  EXPECT_TRUE(plan.Tree.Nodes[0].IsVertical);
}

/// The integral is nearly all in one place, so that no line near its median divides it: each side
/// of a line has a quarter at least.
TEST(CutPlan, BothSidesOfALineHaveAFairShareWhereverTheVerticesAre)
{
  for (const double finest : { 1e-2, 1e-3, 1e-4, 1e-5 })
  {
    Scene scene(Square(), 1.0);
    ProblemList problems;
    scene.F = MakeSpacing(
      RadialSpacing({ 0.3, 0.45 }, finest, 1.0), scene.Made.Bounds, problems, NoMonitor());
    const CutPlan plan = scene.PlanOf(20000.0, 500.0);
    for (const CutTree::Node& node : plan.Tree.Nodes)
    {
      for (Id child = 0; node.Children != NoId && child < 2; ++child)
      {
        EXPECT_GE(plan.Tree.Nodes[node.Children + child].Vertices, 0.2499 * node.Vertices);
      }
    }
  }
}

TEST(CutPlan, BelowTwoBlocksNothingIsCut)
{
  Scene scene(Square(), 0.005);
  const CutPlan plan = scene.PlanOf(46000.0, 23001.0);
  EXPECT_EQ(plan.Tree.NumberOfLeaves, 1);
  EXPECT_EQ(plan.Graph.NumberOfPieces(), 4);
}

/// A snowflake of segments as long as f. Only six blocks are had where ends of cuts stay in place.
TEST(CutPlan, DrawingsAsFineAsTheSpacingAreCut)
{
  const std::vector<Point2> loop = Snowflake(3);
  const double length = Distance(loop[0], loop[1]);
  Scene scene(PolylineBuilder().Loop(loop).Lines(), length);
  const CutPlan plan = scene.PlanOf(586.0, 58.6);
  const BlockDomains parts = scene.Divide(plan);
  EXPECT_GE(parts.Blocks.size(), 8u);
  double area = 0.0;
  for (const BlockDomain& block : parts.Blocks)
  {
    EXPECT_EQ(CheckDomain(block.Geometry), "");
    area += block.Geometry.Area;
  }
  EXPECT_NEAR(area, scene.Made.Area, 1e-12);
}

TEST(CutPlan, NothingIsCutWhereEveryLineMeetsSomethingNarrow)
{
  PolylineBuilder builder;
  builder.Box(0.0, 0.0, 1.0, 1.0);
  for (int k = 0; k < 40; ++k)
  {
    const double at = (k + 0.5) / 40.0;
    builder.Chain({ { at, 0.01 }, { at, 0.3 } });
    builder.Chain({ { at, 0.31 }, { at, 0.6 } });
    builder.Chain({ { at, 0.61 }, { at, 0.99 } });
  }
  Scene scene(builder.Lines(), 0.02);
  EXPECT_EQ(scene.PlanOf(3000.0, 1000.0).Tree.NumberOfLeaves, 1);
}

/// Two holes side by side in the middle, as near as rounding: lines through the middle would be the
/// first choice.
TEST(CutPlan, LinesAvoidSegmentsThatNearlyTouch)
{
  const double gap =
    3.0 * Scene(PolylineBuilder().Box(-3.0, -3.0, 3.0, 3.0).Lines(), 1.0).Made.Resolution;
  Scene scene(PolylineBuilder()
                .Box(-3.0, -3.0, 3.0, 3.0)
                .Box(-0.4, -0.3, 0.0, 0.1)
                .Box(gap, -0.1, 0.4, 0.3)
                .Lines(),
    0.02);
  const CutPlan plan = scene.PlanOf(100000.0, 10000.0);
  EXPECT_FALSE(plan.Touches.IsEmpty());
  const BlockDomains parts = scene.Divide(plan);
  EXPECT_GE(parts.Blocks.size(), 7u);
  EXPECT_TRUE(TouchesAreWithinBlocks(plan, parts));
}

/// As land on both sides of a strait, where a line leaves out what is narrow.
TEST(BlockDomains, LeavesWithSegmentsThatNearlyTouchAreOneBlock)
{
  Scene scene(PolylineBuilder().Loop(RegularPolygon({ 0.0, 0.0 }, 1.0, 200)).Lines(), 0.02);
  CutPlan plan = scene.PlanOf(9000.0, 1000.0);
  const BlockDomains apart = scene.Divide(plan);
  ASSERT_GE(apart.Blocks.size(), 6u);
  const auto segmentOf = [&apart](const BlockDomain& block)
  {
    return apart.Graph
      .Pieces[*std::find_if(block.Pieces.begin(), block.Pieces.end(),
        [&apart](Id piece) { return !apart.Graph.IsCut(piece) && IsUncut(apart, piece); })]
      .Segment;
  };
  plan.Touches.Pairs = { { segmentOf(apart.Blocks.front()), segmentOf(apart.Blocks.back()) } };
  EXPECT_FALSE(TouchesAreWithinBlocks(plan, apart));
  const BlockDomains united = scene.Divide(plan);
  EXPECT_EQ(united.Blocks.size() + 1, apart.Blocks.size());
  EXPECT_TRUE(TouchesAreWithinBlocks(plan, united));
  const auto expected = [](double sum, const BlockDomain& block)
  { return sum + block.ExpectedVertices - static_cast<double>(block.Vertices.size()); };
  EXPECT_NEAR(std::accumulate(united.Blocks.begin(), united.Blocks.end(), 0.0, expected),
    std::accumulate(apart.Blocks.begin(), apart.Blocks.end(), 0.0, expected), 1e-6);
}

TEST(BlockDomains, AreValidAndCoverTheDomainOnce)
{
  const Polylines drawing = PolylineBuilder()
                              .Box(0.0, 0.0, 1.0, 1.0)
                              .Loop(RegularPolygon({ 0.5, 0.5 }, 0.2, 40))
                              .Chain({ { 0.0, 0.125 }, { 1.0, 0.125 } })
                              .Chain({ { 0.75, 0.875 } }, ChainKind::EmbeddedPoint)
                              .Lines();
  Scene scene(drawing, 0.01);
  const CutPlan plan = scene.PlanOf(10000.0, 1000.0);
  ASSERT_GT(plan.Tree.NumberOfLeaves, 5);
  const BlockDomains parts = scene.Divide(plan);
  ASSERT_GT(parts.Blocks.size(), 5u);
  double area = 0.0;
  double embedded = 0.0;
  for (const BlockDomain& block : parts.Blocks)
  {
    EXPECT_EQ(CheckDomain(block.Geometry), "");
    EXPECT_GT(block.Geometry.Area, 0.0);
    area += block.Geometry.Area;
    embedded +=
      std::accumulate(block.Geometry.IsEmbedded.begin(), block.Geometry.IsEmbedded.end(), 0.0);
  }
  EXPECT_NEAR(area, scene.Made.Area, 1e-12);
  EXPECT_EQ(embedded, 1.0);
}

} // namespace biting
