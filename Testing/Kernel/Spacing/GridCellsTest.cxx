// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Spacing/GridCells.h"

#include "SpacingSources.h"

#include <gtest/gtest.h>

namespace
{

using namespace biting;

bool IsSteep(const std::array<double, 4>& corners, double gradation = 0.3)
{
  const GridSource grid{ { 0.0, 1.0 }, { 0.0, 1.0 },
    { corners[0], corners[1], corners[2], corners[3] } };
  return GridCells(grid, gradation, { 1.0, 0.0, 1e9 }).IsSteep(0, 0);
}

} // namespace

TEST(GridCells, AreSteepAboveTheGradationWithAMargin)
{
  EXPECT_FALSE(IsSteep({ 1.0, 1.3, 1.0, 1.3 }));
  EXPECT_FALSE(IsSteep({ 1.0, 1.301, 1.0, 1.301 }));
  EXPECT_TRUE(IsSteep({ 1.0, 1.303, 1.0, 1.303 }));
  EXPECT_TRUE(IsSteep({ 1.0, 1.22, 1.22, 1.44 })) << "along the diagonal";
  EXPECT_FALSE(IsSteep({ 1.0, 1.21, 1.21, 1.42 }));
}

TEST(GridCells, AreSteepWhereTheirTwistAddsToF)
{
  EXPECT_TRUE(IsSteep({ 0.02, 0.31, 0.31, 0.02 }));
  EXPECT_FALSE(IsSteep({ 50.02, 50.31, 50.31, 50.02 }));
}

TEST(GridCells, CutOffWhatCannotRemain)
{
  const GridSource grid{ { 0.0, 1.0 }, { 0.0, 1.0 }, { 0.1, 1e20, 0.2, 0.3 } };
  const GridCells cells(grid, 0.3, { 1.0, 0.0, 1e300 });
  EXPECT_EQ(cells.Given(0), 0.1);
  EXPECT_GT(cells.Given(1), 0.1 + 0.3 * std::sqrt(2.0));
  EXPECT_LT(cells.Given(1), 1.0);
  EXPECT_TRUE(cells.IsSteep(0, 0));
}

TEST(GridCells, ScaleAndClampValues)
{
  const GridSource grid{ { 0.0, 1.0 }, { 0.0 }, { 1.0, 5.0 } };
  const GridCells cells(grid, 10.0, { 2.0, 3.0, 7.0 });
  EXPECT_EQ(cells.Given(0), 3.0);
  EXPECT_EQ(cells.Given(1), 7.0);
}
