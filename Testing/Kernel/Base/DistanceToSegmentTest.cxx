// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Base/DistanceToSegment.h"

#include <gtest/gtest.h>

namespace biting
{

namespace
{

TEST(DistanceToSegment, IsThatToTheLineOrToAnEnd)
{
  const Point2 a{ 1.0, 1.0 };
  const Point2 b{ 4.0, 5.0 };
  EXPECT_DOUBLE_EQ(DistanceToSegment({ 2.5 - 4.0, 3.0 + 3.0 }, a, b), 5.0);
  EXPECT_DOUBLE_EQ(DistanceToSegment({ 1.0 - 3.0, 1.0 - 4.0 }, a, b), 5.0);
  EXPECT_DOUBLE_EQ(DistanceToSegment({ 4.0, 7.0 }, a, b), 2.0);
  EXPECT_EQ(DistanceToSegment(b, a, b), 0.0);
}

TEST(DistanceToSegment, IsThatToAPointWhereBothEndsAreEqual)
{
  EXPECT_EQ(DistanceToSegment({ 4.0, 5.0 }, { 1.0, 1.0 }, { 1.0, 1.0 }), 5.0);
}

} // namespace

} // namespace biting
