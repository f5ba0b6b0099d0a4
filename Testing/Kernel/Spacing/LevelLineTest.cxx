// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Spacing/LevelLine.h"

#include "SpacingSources.h"

#include <gtest/gtest.h>

#include <algorithm> // for min, max
#include <cmath>     // for abs, isfinite

namespace
{

using namespace biting;

constexpr double Slope = 0.3;
const Box2 Cell{ { 1.0, 2.0 }, { 3.0, 3.0 } };

double Bilinear(const std::array<double, 4>& values, double u, double v)
{
  return (1.0 - v) * ((1.0 - u) * values[0] + u * values[1]) +
    v * ((1.0 - u) * values[3] + u * values[2]);
}

/// The least of what is given and the slope times the distance, over the line or the cell.
double LeastOf(const std::array<double, 4>& values, const Point2& x, bool isOfLine)
{
  constexpr int Steps = 400;
  double least = std::numeric_limits<double>::infinity();
  for (int row = 0; row < Steps; ++row)
  {
    for (int column = 0; column < Steps; ++column)
    {
      const double u = (column + 0.5) / Steps;
      const double v = (row + 0.5) / Steps;
      const double given = Bilinear(values, u, v);
      const double left = std::max(u - 1.0 / Steps, 0.0);
      const double right = std::min(u + 1.0 / Steps, 1.0);
      const double low = std::max(v - 1.0 / Steps, 0.0);
      const double high = std::min(v + 1.0 / Steps, 1.0);
      if (!isOfLine ||
        (given < 0.0 &&
          (Bilinear(values, left, v) >= 0.0 || Bilinear(values, right, v) >= 0.0 ||
            Bilinear(values, u, low) >= 0.0 || Bilinear(values, u, high) >= 0.0)))
      {
        const Point2 place{ Cell.Low.X + u * Cell.Width(), Cell.Low.Y + v * Cell.Height() };
        least = std::min(least, std::max(given, 0.0) + Slope * Distance(x, place));
      }
    }
  }
  return least;
}

/// Nobody asks there.
bool IsBelow(const std::array<double, 4>& values, const Point2& x)
{
  const Point2 offset = x - Cell.Low;
  return Cell.Contains(x) &&
    Bilinear(values, offset.X / Cell.Width(), offset.Y / Cell.Height()) < 0.0;
}

} // namespace

TEST(LevelLine, IsStraightWhereValuesAreLinear)
{
  const LevelLine line(Cell, { -1.0, -1.0, 3.0, 3.0 }, Slope);
  EXPECT_NEAR(line.Bound({ 2.0, 2.25 }), 0.0, 1e-12);
  EXPECT_NEAR(line.Bound({ 2.3, 2.75 }), 0.5 * Slope, 1e-12);
  EXPECT_NEAR(line.Bound({ 6.0, 6.25 }), 5.0 * Slope, 1e-12);
}

/// As outside of a grid, where cells have the values of its border on both sides: rounding must not
/// lead away along the line.
TEST(LevelLine, IsFoundWhereItIsParallelToASideAnywhereInTheCell)
{
  Sampler sampler(9);
  for (int probe = 0; probe < 20000; ++probe)
  {
    const Point2 low{ sampler.Next(), sampler.Next() };
    const Box2 cell{ low, low + Point2{ 0.005, 0.006 } };
    const double below = -sampler.Next();
    const double above = 4.0 * sampler.Next();
    const double share = below / (below - above);
    const Point2 x = sampler.NextIn(cell);
    const LevelLine upright(cell, { below, above, above, below }, Slope);
    ASSERT_NEAR(upright.Bound(x), Slope * std::abs(x.X - low.X - share * cell.Width()), 1e-8);
    const LevelLine level(cell, { below, below, above, above }, Slope);
    ASSERT_NEAR(level.Bound(x), Slope * std::abs(x.Y - low.Y - share * cell.Height()), 1e-8);
  }
}

TEST(LevelLine, IsNowhereWhereNoValueIsBelow)
{
  EXPECT_EQ(LevelLine(Cell, { 1.0, 2.0, 3.0, 0.0 }, Slope).Bound({ 2.0, 2.5 }),
    std::numeric_limits<double>::infinity());
}

TEST(LevelLine, IsAHyperbolaOrTwo)
{
  Sampler sampler(5);
  for (const std::array<double, 4>& values :
    { std::array<double, 4>{ -1.0, 2.0, 3.0, 1.0 }, { -1.0, -0.1, -0.2, 20.0 },
      { -1.0, 1.0, -1.0, 2.0 }, { 1.0, -0.3, 1.0, -2.0 }, { -0.1, 1.0, -2.0, -3.0 } })
  {
    const LevelLine line(Cell, values, Slope);
    for (int probe = 0; probe < 50; ++probe)
    {
      const Point2 x = sampler.NextIn({ { 0.0, 1.0 }, { 4.0, 4.0 } });
      if (IsBelow(values, x))
      {
        continue;
      }
      const double exact = LeastOf(values, x, true);
      EXPECT_GE(line.Bound(x), LeastOf(values, x, false) - 0.01 * Slope);
      EXPECT_LE(line.Bound(x), exact + 0.01 * Slope)
        << x.X << ' ' << x.Y << ' ' << values[1] << ' ' << values[2];
    }
  }
}

/// Where corners are on the line, its ends are: no step from there may leave the cell.
TEST(LevelLine, IsFoundWhereCornersAreOnIt)
{
  Sampler sampler(7);
  for (int probe = 0; probe < 300; ++probe)
  {
    std::array<double, 4> values;
    for (double& value : values)
    {
      value = sampler.Next() < 0.4 ? 0.0 : 2.0 * sampler.Next() - 1.0;
    }
    const Point2 x = sampler.NextIn({ { 0.0, 1.0 }, { 4.0, 4.0 } });
    const double bound = LevelLine(Cell, values, Slope).Bound(x);
    if (std::isfinite(bound) && !IsBelow(values, x))
    {
      EXPECT_GE(bound, LeastOf(values, x, false) - 0.01 * Slope);
      EXPECT_LE(bound, LeastOf(values, x, true) + 0.01 * Slope)
        << values[0] << ' ' << values[1] << ' ' << values[2] << ' ' << values[3];
    }
  }
}

/// Fill values beside the line leave it where it is.
TEST(LevelLine, IsBesideTheLowCornersOfAFillValue)
{
  const LevelLine line(Cell, { -0.1, -0.1, -0.1, 9.97e36 }, Slope);
  EXPECT_NEAR(line.Bound({ 1.5, 2.3 }), 0.3 * Slope, 0.001);
  EXPECT_NEAR(line.Bound({ 2.7, 2.5 }), 0.3 * Slope, 0.001);
}

TEST(LevelLine, IsBetweenTheEndsOfACellWithoutWidth)
{
  const LevelLine line({ { 1.0, 2.0 }, { 1.0, 4.0 } }, { -1.0, 1.0, 1.0, -1.0 }, Slope);
  EXPECT_NEAR(line.Bound({ 1.5, 3.0 }), 0.5 * Slope, 1e-12);
}
