// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Spacing/GivenSources.h"

#include <gtest/gtest.h>

#include <limits> // for NaN, infinity
#include <memory> // for sources
#include <vector> // for values

namespace biting
{

namespace
{

SpacingOptions WithGrid(const std::vector<double>& values)
{
  SpacingOptions options;
  options.Grid =
    std::make_shared<const GridSource>(GridSource{ { 0.0, 1.0 }, { 0.0, 1.0 }, values });
  return options;
}

TEST(GivenSources, OfOneValueAreUniform)
{
  const double hole = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(HasGrid(SpacingOptions()));
  EXPECT_FALSE(HasGrid(WithGrid({ 2.0, 2.0, hole, 2.0 })));
  EXPECT_EQ(UniformOf(WithGrid({ 2.0, 2.0, hole, 2.0 })), 2.0);
  EXPECT_TRUE(HasGrid(WithGrid({ 2.0, 2.0, hole, 3.0 })));
  EXPECT_EQ(UniformOf(WithGrid({ 2.0, 2.0, hole, 3.0 })), std::numeric_limits<double>::infinity());
}

TEST(GivenSources, OfBoundaryValuesAreUniformOnlyWithoutGradation)
{
  SpacingOptions options;
  options.Uniform = 5.0;
  options.Segments = std::make_shared<const SegmentSource>(
    SegmentSource{ { { 0.0, 0.0 }, { 1.0, 0.0 } }, { 2.0, 2.0 }, { 0, 1 } });
  EXPECT_TRUE(HasSegments(options.Segments));
  EXPECT_TRUE(HasExtension(options));
  EXPECT_EQ(UniformOf(options), 5.0);
  options.Gradation = 0.0;
  EXPECT_FALSE(HasExtension(options));
  EXPECT_EQ(UniformOf(options), 2.0);
}

} // namespace

} // namespace biting
