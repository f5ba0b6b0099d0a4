// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Spacing/GridBounds.h"
#include "Spacing/GridInterpolator.h"

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

namespace
{

/// Values in a cell as distances to a disc that it reaches into, times twice the gradation.
GridSource BesideDisc(const Point2& center, double depth)
{
  GridSource cell{ { 0.0, 1.0 }, { 0.0, 1.0 }, {} };
  for (const Point2& node :
    { Point2{ 0.0, 0.0 }, Point2{ 1.0, 0.0 }, Point2{ 0.0, 1.0 }, Point2{ 1.0, 1.0 } })
  {
    const double away = Distance(node, center) - Length(center) - depth;
    cell.Values.push_back(0.02 + 2.0 * Gradation * std::max(away, 0.0));
  }
  return cell;
}

/// The least of what is given at so many places in the unit square, and grows from there.
double LeastOfMany(const GridSource& cell, const Point2& x)
{
  constexpr int Steps = 100;
  const GridInterpolator given(Share(cell));
  double least = NoLimit;
  for (int k = 0; k < (Steps + 1) * (Steps + 1); ++k)
  {
    const Point2 place = (1.0 / Steps) * Point2{ double(k % (Steps + 1)), double(k / (Steps + 1)) };
    least = std::min(least, given(place) + Gradation * Distance(x, place));
  }
  return least;
}

double LeastAtCorners(const GridSource& cell, const Point2& x)
{
  double least = NoLimit;
  for (std::size_t node = 0; node < 4; ++node)
  {
    const Point2 place{ cell.XNodes[node % 2], cell.YNodes[node / 2] };
    least = std::min(least, cell.Values[node] + Gradation * Distance(x, place));
  }
  return least;
}

} // namespace

/// The corners, the sides and the inside of a cell are all there is.
TEST(GridBounds, GrowFromWithinATwistedCell)
{
  constexpr double BetweenPlaces = 0.003; // of the many
  Sampler sampler(1);
  int beyondSides = 0;
  for (int sample = 0; sample < 1000; ++sample)
  {
    const GridSource cell = BesideDisc(-3.0 * sampler.NextIn(UnitBox()), 0.8 * sampler.Next());
    const GridBounds bounds(Share(cell), Gradation, { 1.0, 0.0, NoLimit });
    const Point2 x = 1.4 * sampler.NextIn(UnitBox()) - Point2{ 0.2, 0.2 };
    const double ofCorners = LeastAtCorners(cell, x);
    const double ofSides = bounds.FromSides(0, 0, x, bounds.FromSides(1, 1, x, ofCorners));
    const bool isInside = UnitBox().Contains(x);
    const double own = isInside ? GridInterpolator(Share(cell))(x) : NoLimit;
    const double found = bounds.FromWithin(0, 0, x, std::min(own, ofSides));
    const double least = LeastOfMany(cell, x);
    EXPECT_GE(found, least - BetweenPlaces);
    EXPECT_LE(found, 1.02 * least);
    beyondSides += found < 0.98 * std::min(own, ofSides) ? 1 : 0;
  }
  EXPECT_GT(beyondSides, 5);
}

TEST(GridBounds, DoNotLookIntoACellThatIsLinear)
{
  EXPECT_EQ(BoundsOf(0.0).FromWithin(0, 0, { 0.9, 0.5 }, NoLimit), NoLimit);
}
