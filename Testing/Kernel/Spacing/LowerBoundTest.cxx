// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Spacing/LowerBound.h"

#include "SpacingSources.h"

#include <gtest/gtest.h>

namespace
{

using namespace biting;

SegmentSource OneSegment()
{
  return { { { 0.2, 0.5 }, { 0.6, 0.5 } }, { 0.1, 0.2 }, { 0, 1 } };
}

} // namespace

TEST(LowerBound, FallsFromItsSegmentsWithTheGradation)
{
  const LowerBound bound(OneSegment(), 0.5);
  EXPECT_NEAR(bound.Raise({ 0.2, 0.5 }, 0.01), 0.1, 1e-12);
  EXPECT_NEAR(bound.Raise({ 0.4, 0.5 }, 0.01), 0.15, 1e-12);
  EXPECT_NEAR(bound.Raise({ 0.8, 0.5 }, 0.01), 0.1, 1e-12);
  EXPECT_EQ(bound.Raise({ 0.4, 0.5 }, 0.3), 0.3);
  EXPECT_EQ(bound.Raise({ 9.0, 9.0 }, 0.01), 0.01);
}

TEST(LowerBound, IsNeverBelowWhatIsAskedAndIsLipschitz)
{
  const LowerBound bound(MakeScatter(100, 0.1, 3), 0.3);
  Sampler sampler(4);
  for (int probe = 0; probe < 5000; ++probe)
  {
    const Point2 x = sampler.NextIn(UnitBox());
    const Point2 y = sampler.NextIn(UnitBox());
    ASSERT_GE(bound.Raise(x, 0.02), 0.02);
    ASSERT_LE(
      std::abs(bound.Raise(x, 0.02) - bound.Raise(y, 0.02)), 0.3 * Distance(x, y) * (1.0 + 1e-12));
  }
}

TEST(Spacing, IsRaisedByItsFloorLastOfAll)
{
  SpacingOptions options;
  options.Uniform = 0.02;
  options.Scale = 2.0;
  options.Maximum = 0.03;
  options.Floor = Share(OneSegment());
  const Spacing f = MakeGoodSpacing(options);
  EXPECT_FALSE(f.IsUniform());
  EXPECT_NEAR(f({ 0.6, 0.5 }), 0.2, 1e-12);
  EXPECT_NEAR(f({ 0.6, 0.6 }), 0.17, 1e-12);
  EXPECT_NEAR(f({ 0.9, 0.0 }), 0.03, 1e-12);
  options.Gradation = 0.0;
  EXPECT_NEAR(MakeGoodSpacing(options)({ 0.6, 0.6 }), 0.17, 1e-12);
}

TEST(Spacing, RefusesAFloorThatIsNoSpacing)
{
  SegmentSource floor = OneSegment();
  floor.Values[1] = -1.0;
  SpacingOptions options;
  options.Floor = Share(floor);
  ProblemList problems;
  SilentMonitor monitor;
  MakeSpacing(options, UnitBox(), problems, monitor);
  EXPECT_TRUE(problems.Has(ProblemCode::BadSpacing));
}
