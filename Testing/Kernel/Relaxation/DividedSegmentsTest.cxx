// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Relaxation/DividedSegments.h"
#include "../Support/MeshShapes.h"

#include <gtest/gtest.h>

#include <algorithm> // for count

namespace biting
{

namespace
{

using Flags = std::vector<std::uint8_t>;

Flags DividedSegmentsOf(const PolylineBuilder& builder)
{
  const MadeDomain made = Make(builder);
  const std::vector<double> spacings(made.Domain.NumberOfVertices(), 0.1);
  SilentMonitor monitor;
  Pulse pulse(monitor);
  return FindDividedSegments(made.Domain, spacings, pulse);
}

} // namespace

TEST(FindDividedSegments, AllowsAllOfASquare)
{
  EXPECT_EQ(DividedSegmentsOf(PolylineBuilder().Box(0.0, 0.0, 1.0, 1.0)), Flags(4, 1));
}

TEST(FindDividedSegments, ForbidsTheSidesOfASlitAsNarrowAsRounding)
{
  const double gap = 1e-15;
  const Flags flags =
    DividedSegmentsOf(PolylineBuilder().Box(0.0, 0.0, 0.5, 1.0).Box(0.5 + gap, 0.0, 1.0, 1.0));
  ASSERT_EQ(flags.size(), 8u);
  EXPECT_LE(std::count(flags.begin(), flags.end(), 1), 2);
}

TEST(FindDividedSegments, AllowsTheSidesOfAWiderSlit)
{
  const Flags flags =
    DividedSegmentsOf(PolylineBuilder().Box(0.0, 0.0, 0.5, 1.0).Box(0.5 + 1e-12, 0.0, 1.0, 1.0));
  EXPECT_EQ(flags, Flags(8, 1));
}

TEST(FindDividedSegments, ForbidsASpikeAsThinAsRounding)
{
  const Flags flags = DividedSegmentsOf(
    PolylineBuilder().Loop({ { 0.0, 0.0 }, { 1.0, 0.0 }, { 1.0, 1e-14 }, { 0.0, 1.0 } }));
  ASSERT_EQ(flags.size(), 4u);
  EXPECT_EQ(flags[1], 0);
  EXPECT_EQ(flags[3], 1);
}

TEST(FindDividedSegments, ForbidsSegmentsOfAFewRoundings)
{
  const Flags flags = DividedSegmentsOf(
    PolylineBuilder().Loop({ { 0.0, 0.0 }, { 1.0, 0.0 }, { 1.0, 1.0 }, { 1.0 - 1e-13, 1.0 } }));
  ASSERT_EQ(flags.size(), 4u);
  EXPECT_EQ(flags, Flags({ 1, 1, 0, 1 }));
}

} // namespace biting
