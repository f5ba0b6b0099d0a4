// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Quality/QuadDiagonal.h"

#include <gtest/gtest.h>

#include <algorithm> // for rotate, reverse
#include <random>    // for quads

namespace biting
{

namespace
{

using Quad = std::array<std::array<double, 3>, 4>;

constexpr int NumberOfQuads = 20000;

double TwiceArea(const Quad& quad, const std::array<std::uint8_t, 3>& corners)
{
  const auto& a = quad[corners[0]];
  const auto& b = quad[corners[1]];
  const auto& c = quad[corners[2]];
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// Whole numbers, so that areas are exact.
Quad RandomQuad(std::mt19937& random, double z)
{
  Quad quad{};
  for (auto& corner : quad)
  {
    corner = { double(random() % 9), double(random() % 9), z };
  }
  return quad;
}

QuadDiagonal Other(QuadDiagonal diagonal)
{
  return diagonal == QuadDiagonal::None ? diagonal
    : diagonal == QuadDiagonal::First   ? QuadDiagonal::Second
                                        : QuadDiagonal::First;
}

} // namespace

TEST(QuadDiagonal, MakesTwoTrianglesOfOneOrientationWhereThatIsPossible)
{
  std::mt19937 random(1);
  int concave = 0;
  int crossing = 0;
  for (int k = 0; k < NumberOfQuads; ++k)
  {
    const Quad quad = RandomQuad(random, 3.0);
    const auto turnAlike = [&quad](QuadDiagonal diagonal)
    {
      const auto triangles = TrianglesOfQuad(diagonal);
      return TwiceArea(quad, triangles[0]) * TwiceArea(quad, triangles[1]) > 0.0;
    };
    const QuadDiagonal diagonal = FindQuadDiagonal(quad);
    const bool mayBeFirst = turnAlike(QuadDiagonal::First);
    const bool mayBeSecond = turnAlike(QuadDiagonal::Second);
    EXPECT_EQ(diagonal != QuadDiagonal::None, mayBeFirst || mayBeSecond);
    EXPECT_TRUE(diagonal == QuadDiagonal::None || turnAlike(diagonal));
    concave += mayBeFirst != mayBeSecond;
    crossing += !mayBeFirst && !mayBeSecond;
  }
  EXPECT_GT(concave, 1000);
  EXPECT_GT(crossing, 1000);
}

TEST(QuadDiagonal, HasTheLargerSmallestAngle)
{
  const Quad kite{ { { 0, 0, 0 }, { 4, -1, 0 }, { 8, 0, 0 }, { 4, 1, 0 } } };
  EXPECT_EQ(FindQuadDiagonal(kite), QuadDiagonal::Second);
  const Quad square{ { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } } };
  EXPECT_EQ(FindQuadDiagonal(square), QuadDiagonal::First);
}

TEST(QuadDiagonal, IsTheSameInOtherPlanesAndFromOtherCorners)
{
  std::mt19937 random(2);
  int compared = 0;
  for (int k = 0; k < NumberOfQuads; ++k)
  {
    const Quad quad = RandomQuad(random, 0.0);
    Quad turned = quad;
    std::rotate(turned.begin(), turned.begin() + 1, turned.end());
    const QuadDiagonal diagonal = FindQuadDiagonal(quad);
    Quad upright = quad;
    Quad scaled = quad;
    for (std::size_t corner = 0; corner < 4; ++corner)
    {
      upright[corner] = { quad[corner][1], 7.0, quad[corner][0] };
      scaled[corner] = { 0x1p-40 * quad[corner][0], 0x1p-40 * quad[corner][1], 0.0 };
    }
    EXPECT_EQ(FindQuadDiagonal(upright), diagonal);
    EXPECT_EQ(FindQuadDiagonal(scaled), diagonal);
    // Where both are as good the first one is taken, wherever it begins.
    const bool areAlike = FindQuadDiagonal(turned) == diagonal;
    EXPECT_TRUE(
      areAlike ? diagonal != QuadDiagonal::Second : FindQuadDiagonal(turned) == Other(diagonal));
    compared += !areAlike;
  }
  EXPECT_GT(compared, NumberOfQuads / 4);
}

TEST(QuadDiagonal, IsNoneWithoutArea)
{
  const Quad flat{ { { 0, 0, 0 }, { 1, 1, 1 }, { 2, 2, 2 }, { 3, 3, 3 } } };
  EXPECT_EQ(FindQuadDiagonal(flat), QuadDiagonal::None);
  EXPECT_EQ(FindQuadDiagonal(Quad{}), QuadDiagonal::None);
}

} // namespace biting
