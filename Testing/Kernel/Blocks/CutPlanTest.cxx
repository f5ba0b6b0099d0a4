// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "../Support/MeshShapes.h"
#include "../Support/PolylineShapes.h"

#include "Blocks/BlockDomains.h"
#include "Blocks/CutPlan.h"
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
    , Locator(Made, Unheard)
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
  Pulse Unheard{ NoMonitor() };
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

} // namespace

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

} // namespace biting
