// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Spacing/GridBounds.h"

#include "SpacingSources.h"

#include <gtest/gtest.h>

namespace
{

using namespace biting;

constexpr double Gradation = 0.3;
constexpr double NoLimit = 1e9;

/// Three columns; values rise by 1 to the right, and by `rise` upwards.
GridBounds BoundsOf(double rise, double least = 0.0)
{
  return GridBounds(Share(GridSource{ { 0.0, 1.0, 2.0 }, { 0.0, 1.0 },
                      { 0.1, 1.1, 2.1, 0.1 + rise, 1.1 + rise, 2.1 + rise } }),
    Gradation, { 1.0, least, NoLimit });
}

} // namespace

TEST(GridBounds, GrowFromANode)
{
  const GridBounds bounds = BoundsOf(5.0);
  GridBounds::Node node = bounds.Itself(0, 0);
  EXPECT_FALSE(node.From.HasSides());
  EXPECT_NEAR(bounds.From(node, { 3.0, 4.0 }, NoLimit), 0.1 + 5.0 * Gradation, 1e-6);
}

TEST(GridBounds, GrowFromTheSidesOfANodeWhereTheseAreGentle)
{
  const GridBounds bounds = BoundsOf(0.0);
  GridBounds::Node node = bounds.Itself(0, 0);
  EXPECT_TRUE(node.From.HasSides());
  EXPECT_NEAR(bounds.From(node, { 0.5, 0.7 }, NoLimit), 0.1 + 0.5 * Gradation, 1e-6);
  EXPECT_EQ(node.From.Column(), 0u);
  EXPECT_EQ(node.From.Row(), 1u) << "which is nearer";
}

TEST(GridBounds, AreNotBelowALimitThatIsLower)
{
  const GridBounds bounds = BoundsOf(5.0);
  GridBounds::Node node = bounds.Itself(0, 0);
  EXPECT_GE(bounds.From(node, { 3.0, 4.0 }, 0.5), 0.5);
}

TEST(GridBounds, GrowFromWhereTheLeastValueIsReachedWithinACell)
{
  const GridBounds bounds = BoundsOf(0.0, 0.4);
  EXPECT_TRUE(bounds.HasLine(0, 0));
  EXPECT_FALSE(bounds.HasLine(1, 0));
  EXPECT_NEAR(bounds.FromLine(0, 0, { 0.8, 0.5 }, NoLimit), 0.4 + 0.5 * Gradation, 1e-9);
  GridBounds::Node node{ 1.0f, 0.4f, { 0, 0, GridBounds::Kind::LineOfCell } };
  EXPECT_NEAR(bounds.From(node, { 1.3, 0.5 }, NoLimit), 0.4 + Gradation, 1e-9);
  EXPECT_GE(bounds.From(node, { 1.3, 0.5 }, 0.41), 0.41);
}

TEST(GridBounds, HaveOriginsInOneWord)
{
  const GridBounds::Origin origin(4000000000u, 1000000000u, GridBounds::Kind::LineOfCell);
  EXPECT_EQ(origin.Column(), 4000000000u);
  EXPECT_EQ(origin.Row(), 1000000000u);
  EXPECT_TRUE(origin.IsLine());
  EXPECT_FALSE(origin.HasSides());
}
