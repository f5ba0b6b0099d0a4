// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Spacing/GridStrip.h"

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
TEST(GridStrip, OffersTheDistanceToNodesWithinReach)
{
  const std::vector<double> nodes = UnitNodes(Size);
  for (const double distance : { 0.001, 0.01, 0.03, 1.0 })
  {
    const std::vector<double> places = { 0.0, distance };
    const GridAxes axes(nodes, places);
    const std::size_t beside = axes.Beside(distance, 1);
    EXPECT_GE(beside, 1u);
    EXPECT_LE(beside, MostBesideNode);
    EXPECT_EQ(axes.AreFar(distance), distance == 1.0);
    EXPECT_EQ(axes.HasFarLines(), distance == 1.0);
    for (const std::size_t low : { 0u, 50u, 99u })
    {
      GridLines lines = TwoLines(low);
      GridStrip(axes, { 0, Size }).Step(lines, 0, 1, 1, { 0, Size });
      for (std::size_t node = 0; node < Size; ++node)
      {
        const bool isReached =
          axes.AreFar(distance) || std::max(node, low) - std::min(node, low) <= beside;
        const double expected = std::hypot(nodes[node] - nodes[low], distance);
        EXPECT_EQ(lines.At(1)[node] < 1e5f, isReached) << node;
        EXPECT_NEAR(lines.At(1)[node], isReached ? expected : lines.At(1)[node], 1e-6) << node;
      }
    }
  }
}

TEST(GridStrip, WritesTheNodesOfARangeAsThatOfAllDoes)
{
  const std::vector<double> nodes = UnitNodes(Size, 1.5);
  const std::vector<double> places = { 0.0, 0.02 };
  const GridAxes axes(nodes, places);
  GridLines whole = TwoLines(40);
  GridStrip(axes, { 0, Size }).Step(whole, 0, 1, 1, { 0, Size });
  GridLines part = TwoLines(40);
  GridStrip(axes, { 30, 60 }).Step(part, 0, 1, 1, { 35, 50 });
  for (std::size_t node = 0; node < Size; ++node)
  {
    EXPECT_EQ(part.At(1)[node], node < 35 || node >= 50 ? 1e6f : whole.At(1)[node]) << node;
  }
}
