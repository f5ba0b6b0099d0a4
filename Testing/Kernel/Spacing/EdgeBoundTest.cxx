// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Spacing/EdgeBound.h"

#include "SpacingSources.h"

#include <gtest/gtest.h>

namespace
{

using namespace biting;

constexpr double EdgeLength = 2.0;

/// By the definition, at many points of the edge.
double Sampled(const ValueRange& range, const Point2& x, double start, double end)
{
  constexpr int Parts = 4000;
  double least = std::numeric_limits<double>::infinity();
  for (int part = 0; part <= Parts; ++part)
  {
    const double t = EdgeLength * part / Parts;
    const double value = range(start + (end - start) * part / Parts);
    least = std::min(least, value + Gradation * Length({ x.X - t, x.Y }));
  }
  return std::min(least, range.Most);
}

} // namespace

TEST(EdgeBound, IsTheLeastOfWhatGrowsFromAllPointsOfTheEdge)
{
  Sampler sampler(51);
  for (const ValueRange& range :
    { ValueRange{ 1.0, 0.0, 1e9 }, ValueRange{ 2.0, 0.3, 1e9 }, ValueRange{ 1.0, 0.2, 0.5 } })
  {
    const EdgeBound bound(range, Gradation);
    for (int probe = 0; probe < 300; ++probe)
    {
      const Point2 x = sampler.NextIn({ { -3.0, -3.0 }, { 5.0, 3.0 } });
      const double start = 0.05 + 0.8 * sampler.Next();
      const double end = 0.05 + 0.8 * sampler.Next();
      const double found = bound(x.X, x.Y, EdgeLength, start, end);
      ASSERT_NEAR(found, Sampled(range, x, start, end), 3e-4) << start << ' ' << end;
    }
  }
}

TEST(EdgeBound, OfAnEdgeWithoutLengthGrowsFromItsLowerValue)
{
  const EdgeBound bound({ 1.0, 0.0, 1e9 }, Gradation);
  EXPECT_DOUBLE_EQ(bound(3.0, 4.0, 0.0, 0.5, 0.7), 0.5 + Gradation * 5.0);
  EXPECT_DOUBLE_EQ(bound(3.0, 4.0, 0.0, 0.7, 0.5), 0.5 + Gradation * 5.0);
  EXPECT_DOUBLE_EQ(bound(3.0, 4.0, 0.0, 0.5, 0.5), 0.5 + Gradation * 5.0);
}

TEST(EdgeBound, OfFillValuesGrowsFromTheLowerEnd)
{
  const EdgeBound bound({ 1.0, 0.0, std::numeric_limits<double>::max() }, Gradation);
  for (double fill : { 1e20, 1e300 })
  {
    EXPECT_DOUBLE_EQ(bound(0.5, 0.0, EdgeLength, 0.1, fill), 0.1 + 0.5 * Gradation);
    EXPECT_DOUBLE_EQ(bound(0.5, 0.0, EdgeLength, fill, 0.1), 0.1 + 1.5 * Gradation);
  }
}
