// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Spacing/GridBounds.h"

#include "SpacingSources.h"

#include <gtest/gtest.h>

namespace
{

using namespace biting;

constexpr double NoLimit = 1e9;

/// Three columns; values rise by 1 to the right, and by `rise` upwards.
GridBounds BoundsOf(double rise, double least = 0.0)
{
  return GridBounds(Share(GridSource{ { 0.0, 1.0, 2.0 }, { 0.0, 1.0 },
                      { 0.1, 1.1, 2.1, 0.1 + rise, 1.1 + rise, 2.1 + rise } }),
    Gradation, { 1.0, least, NoLimit });
}

} // namespace

TEST(GridBounds, GrowFromTheSidesOfANode)
{
  const GridBounds bounds = BoundsOf(0.0);
  for (const std::size_t row : { 0u, 1u })
  {
    EXPECT_NEAR(bounds.FromSides(0, row, { 0.5, 0.7 }, NoLimit), 0.1 + 0.5 * Gradation, 1e-12);
    EXPECT_NEAR(bounds.FromSides(1, row, { 1.5, 0.7 }, NoLimit), 1.1 + 0.5 * Gradation, 1e-12);
  }
}

TEST(GridBounds, DoNotGrowFromSidesThatAreAsSteepAsTheGradation)
{
  EXPECT_EQ(BoundsOf(5.0).FromSides(0, 0, { 0.5, 0.7 }, NoLimit), NoLimit);
}

TEST(GridBounds, AreNotAboveALimit)
{
  EXPECT_EQ(BoundsOf(0.0).FromSides(0, 0, { 0.5, 0.7 }, 0.2), 0.2);
  EXPECT_EQ(BoundsOf(0.0, 0.4).FromLine(0, 0, { 1.3, 0.5 }, 0.41), 0.41);
}

TEST(GridBounds, GrowFromWhereTheLeastValueIsReachedWithinACell)
{
  const GridBounds bounds = BoundsOf(0.0, 0.4);
  EXPECT_TRUE(bounds.HasLine(0, 0));
  EXPECT_FALSE(bounds.HasLine(1, 0));
  EXPECT_NEAR(bounds.FromLine(0, 0, { 0.8, 0.5 }, NoLimit), 0.4 + 0.5 * Gradation, 1e-9);
  EXPECT_NEAR(bounds.FromLine(0, 0, { 1.3, 0.5 }, NoLimit), 0.4 + Gradation, 1e-9);
  EXPECT_EQ(bounds.FromLine(1, 0, { 1.3, 0.5 }, NoLimit), NoLimit);
}
