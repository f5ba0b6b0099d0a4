// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Spacing/ValueRange.h"

#include <gtest/gtest.h>

#include <limits> // for fill values

using namespace biting;

TEST(ValueRange, ScalesFirstAndClampsThen)
{
  const ValueRange range{ 2.0, 0.3, 0.9 };
  EXPECT_EQ(range(0.2), 0.4);
  EXPECT_EQ(range(0.1), 0.3);
  EXPECT_EQ(range(0.5), 0.9);
}

TEST(ValueRange, KeepsItsEnds)
{
  const ValueRange range{ 1.0, 0.3, 0.9 };
  EXPECT_EQ(range(0.3), 0.3);
  EXPECT_EQ(range(0.9), 0.9);
}

TEST(ValueRange, ClampsWhatOverflowsWhereItIsScaled)
{
  const ValueRange range{ 4.0, 0.3, 0.9 };
  EXPECT_EQ(range(std::numeric_limits<double>::max()), 0.9);
  EXPECT_EQ(range(std::numeric_limits<double>::denorm_min()), 0.3);
}

/// Should the least be above it.
TEST(ValueRange, IsNowhereAboveTheMost)
{
  const ValueRange range{ 1.0, 0.9, 0.3 };
  for (const double value : { 0.1, 0.5, 1.0 })
  {
    EXPECT_EQ(range(value), 0.3);
  }
}
