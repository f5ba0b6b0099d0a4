// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Spacing/Plateaus.h"

#include "Spacing/GridInterpolator.h"
#include "SpacingSources.h"

#include <gtest/gtest.h>

namespace
{

using namespace biting;

constexpr ValueRange Range{ 1.0, 0.1, 1e9 };

/// Half of the values, at random, are below the least one.
GridSource LowNoise(int columns, int rows)
{
  Sampler sampler(71);
  return MakeGrid(
    columns, rows, [&sampler](const Point2&) { return 0.2 * sampler.Next(); }, 1.5);
}

std::vector<float> Lowered(const GridSource& grid)
{
  std::vector<float> values(grid.Values.size(), 1.0f);
  Pulse pulse(NoMonitor());
  LowerBesidePlateaus(grid, Range, Gradation, values, pulse);
  return values;
}

/// At a node, of the plateaus of the sides along x on both sides of its column.
double Exact(const GridSource& grid, std::size_t column, std::size_t row)
{
  const std::size_t columns = grid.XNodes.size();
  double least = 1.0;
  for (std::size_t other = 0; other < grid.YNodes.size(); ++other)
  {
    for (std::size_t side = column > 0 ? column - 1 : 0; side < std::min(column + 1, columns - 1);
         ++side)
    {
      const double start = grid.Values[side + columns * other];
      const double end = grid.Values[side + 1 + columns * other];
      if ((start < Range.Least) != (end < Range.Least))
      {
        const double share = (Range.Least - start) / (end - start);
        const Point2 place{ Blend(grid.XNodes[side], grid.XNodes[side + 1], share),
          grid.YNodes[other] };
        // A plateau that has the node as an end is none to be reached.
        const bool isEnd = (side == column) == (start < Range.Least);
        least = isEnd
          ? least
          : std::min(least,
              Range.Least + Gradation * Distance(place, { grid.XNodes[column], grid.YNodes[row] }));
      }
    }
  }
  return least;
}

} // namespace

TEST(Plateaus, BoundNodesOnBothSidesOfLongSidesAlike)
{
  const GridSource grid = LowNoise(7, 400);
  const std::vector<float> values = Lowered(grid);
  const std::vector<float> transposed = Lowered(Transposed(grid));
  for (std::size_t node = 0; node < values.size(); ++node)
  {
    const std::size_t column = node % 7;
    const std::size_t row = node / 7;
    ASSERT_NEAR(values[node], Exact(grid, column, row), 1e-6) << column << ' ' << row;
    ASSERT_EQ(transposed[row + 400 * column], values[node]);
  }
}

TEST(Plateaus, AreNotLookedForWhereCellsAreAboutSquare)
{
  const GridSource grid = MakeGrid(30, 30, [](const Point2& x) { return 0.2 * x.X; });
  EXPECT_EQ(Lowered(grid), std::vector<float>(900, 1.0f));
}

TEST(Plateaus, AreOnBothSidesOfAJump)
{
  GridSource grid{ { 0.0, 1.0 }, UnitNodes(50), {} };
  grid.YNodes[25] = grid.YNodes[24];
  grid.Values.assign(100, 0.3);
  grid.Values[48] = 0.0;
  grid.Values[50] = 0.05;
  const std::vector<float> values = Lowered(grid);
  EXPECT_NEAR(values[49], 0.1 + Gradation * 0.66667, 1e-5);
  EXPECT_NEAR(values[51], 0.1 + Gradation * 0.66667, 1e-5);
}
