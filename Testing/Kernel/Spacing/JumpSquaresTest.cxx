// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Spacing/JumpSquares.h"

#include "SpacingSources.h"

#include <gtest/gtest.h>

#include <algorithm> // for fill, count_if

namespace
{

using namespace biting;

constexpr double Gradation = 0.3;

SegmentSource JumpsOf(const TriangulatedSource& source)
{
  const TriangleInterpolator field(source);
  ConeCollector cones({ 1.0, 0.0, 1e9 });
  Pulse pulse(NoMonitor());
  AddJumpSquares(field, UnitBox(), Gradation, cones, pulse);
  return cones.Segments();
}

/// The corners of a square, at which f is low and high in turns: what is nearest to most places.
TriangulatedSource Corners(double low, double high)
{
  TriangulatedSource source;
  for (const Point2& corner :
    { Point2{ 0.0, 0.0 }, Point2{ 1.0, 0.0 }, Point2{ 1.0, 1.0 }, Point2{ 0.0, 1.0 } })
  {
    const auto first = static_cast<Id>(source.Points.size());
    const Point2 inwards = 0.02 * (Point2{ 0.5, 0.5 } - corner);
    source.Points.insert(
      source.Points.end(), { corner, corner + inwards, corner + Point2{ inwards.X, 0.0 } });
    source.Values.insert(source.Values.end(), 3, first % 2 == 0 ? low : high);
    source.Triangles.insert(source.Triangles.end(), { first, first + 1, first + 2 });
  }
  return source;
}

} // namespace

/// In squares of half f / g: some ten segments for each f / g of the jump, in place of a hundred
/// points, whatever f is.
TEST(JumpSquares, AreFewSegmentsForTheirLength)
{
  for (const double low : { 0.05, 0.005, 0.0005 })
  {
    const SegmentSource cones = JumpsOf(Corners(low, 1.0));
    const double unitsOfJump = 4.0 * 0.5 * Gradation / low; // a cross, as wide as the bounds
    EXPECT_LT(static_cast<double>(cones.Segments.size()) / 2.0, 100.0 + 10.0 * unitsOfJump) << low;
  }
}

TEST(JumpSquares, AreNearTheLineBetweenPartsWhateverItsDirection)
{
  TriangulatedSource source = Corners(0.005, 1.0);
  source.Values.assign(12, 1.0);
  std::fill(source.Values.begin(), source.Values.begin() + 3, 0.005);
  // The first corner is nearest below and left of the lines in the middle between it and others.
  const SegmentSource cones = JumpsOf(source);
  double length = 0.0;
  for (std::size_t k = 0; k < cones.Segments.size(); k += 2)
  {
    const Point2& start = cones.Points[static_cast<std::size_t>(cones.Segments[k])];
    const Point2& end = cones.Points[static_cast<std::size_t>(cones.Segments[k + 1])];
    length += Distance(start, end);
    for (const Point2& place : { start, end, Midpoint(start, end) })
    {
      const double away = std::min(std::abs(place.X - 0.5), std::abs(place.Y - 0.5));
      EXPECT_LT(away, 0.03 * 0.005 / Gradation + 0.02);
    }
  }
  EXPECT_GT(length, 0.9);
}

/// There is no room for small squares all along such jumps; but at a few places they meet or bend.
TEST(JumpSquares, HaveTheValueOfTheLowerSideHoweverLongTheJumpsAre)
{
  for (const double low : { 1e-3, 1e-5 })
  {
    const SegmentSource cones = JumpsOf(Corners(low, 1.0));
    EXPECT_LT(cones.Segments.size(), 400000u);
    const auto lowered = std::count_if(
      cones.Values.begin(), cones.Values.end(), [low](double value) { return value < 0.99 * low; });
    EXPECT_LT(100 * lowered, static_cast<int>(cones.Values.size())) << low;
  }
}

/// Found by fuzzing: halving a square's side down to a share of f, which rounding does not allow.
TEST(JumpSquares, EndWhereFIsFarBelowRounding)
{
  EXPECT_LT(JumpsOf(Corners(1e-200, 1.0)).Segments.size(), 400000u);
}
