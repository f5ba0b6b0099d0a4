// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Spacing/ConeCollector.h"

#include <gtest/gtest.h>

using namespace biting;

TEST(ConeCollector, HasEachSegmentWithTheValuesAtItsEndsInTheOrderOfTheCalls)
{
  ConeCollector cones({ 2.0, 0.3, 0.9 });
  EXPECT_TRUE(cones.Segments().Segments.empty());
  cones.AddSegment({ 0.0, 1.0 }, { 2.0, 3.0 }, 0.4, 0.5);
  cones.AddSegment({ 2.0, 3.0 }, { 2.0, 3.0 }, 0.6, 0.7);
  const SegmentSource& source = cones.Segments();
  EXPECT_EQ(source.Segments, (std::vector<Id>{ 0, 1, 2, 3 }));
  EXPECT_EQ(source.Values, (std::vector<double>{ 0.4, 0.5, 0.6, 0.7 }));
  EXPECT_TRUE(source.Points[0] == (Point2{ 0.0, 1.0 }) && source.Points[1] == source.Points[2]);
  EXPECT_EQ(cones.Values()(0.2), 0.4);
}
