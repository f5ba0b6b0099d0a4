// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Spacing/GridSteps.h"

#include "SpacingSources.h"

#include <gtest/gtest.h>

namespace
{

using namespace biting;

constexpr std::size_t Size = 100;

/// Two lines so far apart, of great values but for one node of the first.
GridLines TwoLines(std::size_t low)
{
  GridLines lines(2, Size);
  for (const std::size_t line : { 0u, 1u })
  {
    std::fill_n(lines.At(line), Size, 1e6f);
    lines.SetEnds(line);
  }
  lines.At(0)[low] = 0.0f;
  return lines;
}

} // namespace

/// And no others, but where lines are far from each other: then all.
TEST(GridSteps, OffersTheDistanceToNodesWithinReach)
{
  const std::vector<double> nodes = UnitNodes(Size);
  for (const double distance : { 0.001, 0.01, 0.03, 1.0 })
  {
    const std::vector<double> places = { 0.0, distance };
    const GridAxes axes(nodes, places);
    const std::size_t beside = axes.Beside(distance, 1);
    EXPECT_GE(beside, 1u);
    EXPECT_LE(beside, MostBesideNode);
    const NodeRange far = axes.FarFrom(distance);
    EXPECT_EQ(far.Begin < far.End, distance == 1.0);
    for (const std::size_t low : { 0u, 50u, 99u })
    {
      GridLines lines = TwoLines(low);
      GridSteps(axes).Step(lines, 0, 1, 1);
      for (std::size_t node = 0; node < Size; ++node)
      {
        const bool isReached =
          distance == 1.0 || std::max(node, low) - std::min(node, low) <= beside;
        const double expected = std::hypot(nodes[node] - nodes[low], distance);
        EXPECT_EQ(lines.At(1)[node] < 1e5f, isReached) << node;
        EXPECT_NEAR(lines.At(1)[node], isReached ? expected : lines.At(1)[node], 1e-6) << node;
      }
    }
  }
}

/// Nodes are near each other at one end.
TEST(GridSteps, OffersAllWithinReachWhereCellsAreLong)
{
  const std::vector<double> nodes = UnitNodes(Size, 2.0);
  const std::vector<double> places = { 0.0, 0.02 };
  const GridAxes axes(nodes, places);
  const NodeRange far = axes.FarFrom(0.02);
  EXPECT_EQ(far.Begin, 0u);
  EXPECT_GT(far.End, 10u);
  EXPECT_LT(far.End, Size);
  for (const std::size_t low : { 0u, 20u, 99u })
  {
    GridLines lines = TwoLines(low);
    GridSteps(axes).Step(lines, 0, 1, 1);
    for (std::size_t node = 0; node < far.End; ++node)
    {
      const double along = std::abs(nodes[node] - nodes[low]);
      const bool isReached = along < 7.0 * 0.02;
      EXPECT_TRUE(!isReached || std::abs(lines.At(1)[node] - std::hypot(along, 0.02)) < 1e-6)
        << node;
    }
  }
}
