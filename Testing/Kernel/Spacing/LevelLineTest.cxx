// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Spacing/LevelLine.h"

#include "SpacingSources.h"

#include <gtest/gtest.h>

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

/// Times the slope; of places where the sign changes to the right or above, or of all below it.
double DistanceToLine(const std::array<double, 4>& values, const Point2& x, bool isAnyBelow)
{
  constexpr int Steps = 400;
  double least = std::numeric_limits<double>::infinity();
  for (int row = 0; row < Steps; ++row)
  {
    for (int column = 0; column < Steps; ++column)
    {
      const double u = (column + 0.5) / Steps;
      const double v = (row + 0.5) / Steps;
      const bool isBelow = Bilinear(values, u, v) < 0.0;
      if ((isBelow && isAnyBelow) || isBelow != (Bilinear(values, u + 1.0 / Steps, v) < 0.0) ||
        isBelow != (Bilinear(values, u, v + 1.0 / Steps) < 0.0))
      {
        const Point2 place{ Cell.Low.X + u * Cell.Width(), Cell.Low.Y + v * Cell.Height() };
        least = std::min(least, Slope * Distance(x, place));
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
      { -1.0, 1.0, -1.0, 2.0 }, { 1.0, -0.3, 1.0, -2.0 }, { -0.1, 1.0, -2.0, -3.0 },
      { 1.0005, -0.9996, 0.9997, -1.0003 }, { -1.0005, 0.9996, -0.9997, 1.0003 } })
  {
    const LevelLine line(Cell, values, Slope);
    for (int probe = 0; probe < 50; ++probe)
    {
      const Point2 x = sampler.NextIn({ { 0.0, 1.0 }, { 4.0, 4.0 } });
      if (IsBelow(values, x))
      {
        continue;
      }
      const double exact = DistanceToLine(values, x, false);
      EXPECT_GE(line.Bound(x), DistanceToLine(values, x, true) - 0.01 * Slope);
      EXPECT_LE(line.Bound(x), 1.02 * exact + 0.02 * Slope)
        << x.X << ' ' << x.Y << ' ' << values[1] << ' ' << values[2];
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
