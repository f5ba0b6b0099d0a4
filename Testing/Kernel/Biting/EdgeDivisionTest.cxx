// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Biting/EdgeDivision.h"
#include "../Support/MeshShapes.h"
#include "../Support/Monitors.h"

#include <gtest/gtest.h>

#include <algorithm> // for is_sorted
#include <cmath>     // for log, exp
#include <memory>    // for sources

namespace biting
{

namespace
{

constexpr Id NoLimit = 1000000;

DivisionPoints Divide(const SpacingOptions& options, double bitingConstant, double targetLength,
  const Point2& a, const Point2& b, double leastPart = EdgeDivider::LeastPart)
{
  const Spacing spacing = SpacingAroundUnitSquare(options);
  Pulse pulse(NoMonitor());
  EdgeDivider divider(spacing, bitingConstant, targetLength, pulse, leastPart);
  DivisionPoints points;
  EXPECT_TRUE(divider.Divide(a, b, NoLimit, points));
  EXPECT_EQ(points.Parameters.size(), points.Spacings.size());
  return points;
}

/// One value below y = 0.5, the other above.
SpacingOptions Jump(double first, double last)
{
  auto grid = std::make_shared<GridSource>();
  grid->XNodes = { 0.0 };
  grid->YNodes = { 0.5, std::nextafter(0.5, 1.0) };
  grid->Values = { first, last };
  SpacingOptions options;
  options.Gradation = 0.0;
  options.Sources.emplace_back(grid);
  return options;
}

/// Whether the bites of neighbours on the edge from (0, 0) to (0, 1) meet.
bool AreCovering(
  const DivisionPoints& points, double bitingConstant, double firstSpacing, double lastSpacing)
{
  double place = 0.0;
  double spacing = firstSpacing;
  bool isCovering = true;
  for (std::size_t k = 0; k <= points.Parameters.size(); ++k)
  {
    const bool isLast = k == points.Parameters.size();
    const double next = isLast ? 1.0 : points.Parameters[k];
    const double nextSpacing = isLast ? lastSpacing : points.Spacings[k];
    isCovering = isCovering && next - place <= bitingConstant * (spacing + nextSpacing);
    place = next;
    spacing = nextSpacing;
  }
  return isCovering;
}

TEST(EdgeDivider, PartsHaveEqualIntegrals)
{
  for (double slope : { 0.02, 0.1, 0.3 })
  {
    const double low = 0.02;
    const DivisionPoints points =
      Divide(LinearSpacing(low, slope, 1.0), 0.5, 0.7, { 0.3, 0.0 }, { 0.3, 1.0 });
    const double integral = std::log((low + slope) / low) / slope;
    const auto parts = static_cast<double>(points.Parameters.size() + 1);
    for (std::size_t k = 0; k < points.Parameters.size(); ++k)
    {
      const double place =
        low * std::expm1(slope * integral * static_cast<double>(k + 1) / parts) / slope;
      EXPECT_NEAR(points.Parameters[k], place, 1e-6) << slope;
      EXPECT_NEAR(points.Spacings[k], low + slope * points.Parameters[k], 1e-15);
    }
  }
}

TEST(EdgeDivider, NoOtherNumberOfPartsIsNearerToTheWantedLengthAsARatio)
{
  const auto ratio = [](double part) { return std::max(part, 1.0 / part); };
  for (double length = 0.01; length < 40.0; length *= 1.013)
  {
    for (const double bitingConstant : { 0.824, 0.995 })
    {
      const DivisionPoints points = Divide(UniformSpacing(0.1), bitingConstant, 1.0, { 0.0, 0.0 },
        { 0.1 * length, 0.0 }, EdgeDivider::BalancedPart / bitingConstant);
      const auto parts = static_cast<double>(points.Parameters.size() + 1);
      const double found = ratio(length / parts);
      EXPECT_LE(found, ratio(length / (parts + 1.0)) * (1.0 + 1e-9)) << length;
      EXPECT_TRUE(parts == 1.0 || found <= ratio(length / (parts - 1.0)) * (1.0 + 1e-9)) << length;
      EXPECT_TRUE(length < 0.7072 || found <= std::sqrt(2.0) * (1.0 + 1e-9)) << length;
    }
  }
}

TEST(EdgeDivider, ReversedEdgeHasMirroredPoints)
{
  const Point2 a{ 0.1, 0.05 };
  const Point2 b{ 0.7, 0.95 };
  for (double slope : { 0.05, 0.2 })
  {
    const SpacingOptions spacing = LinearSpacing(0.02, slope, 1.0);
    const DivisionPoints there = Divide(spacing, 0.5, 0.65, a, b);
    const DivisionPoints back = Divide(spacing, 0.5, 0.65, b, a);
    ASSERT_EQ(there.Parameters.size(), back.Parameters.size());
    for (std::size_t k = 0; k < there.Parameters.size(); ++k)
    {
      EXPECT_NEAR(there.Parameters[k], 1.0 - back.Parameters[back.Parameters.size() - 1 - k], 1e-15)
        << slope;
    }
  }
}

TEST(EdgeDivider, BitesMeetWhereSpacingJumps)
{
  for (double bitingConstant : { 0.25, 0.5, 0.8 })
  {
    for (double ratio : { 2.0, 10.0, 50.0 })
    {
      const double low = 0.005;
      const DivisionPoints up =
        Divide(Jump(low, ratio * low), bitingConstant, 1.3 * bitingConstant, {}, { 0.0, 1.0 });
      EXPECT_TRUE(AreCovering(up, bitingConstant, low, ratio * low)) << ratio;
      const DivisionPoints down =
        Divide(Jump(ratio * low, low), bitingConstant, 1.3 * bitingConstant, {}, { 0.0, 1.0 });
      EXPECT_TRUE(AreCovering(down, bitingConstant, ratio * low, low)) << ratio;
    }
  }
}

/// A value but on a line across the edge, and at its end, where it is far smaller.
TEST(EdgeDivider, TakesFewStepsWhereTheSpacingFallsToNearlyNothing)
{
  for (const double least : { 1e-4, 1e-9, 1e-12, 1e-15, 1e-200 })
  {
    auto grid = std::make_shared<GridSource>();
    grid->XNodes = { 0.0 };
    grid->YNodes = { 0.5 - 1e-9, 0.5, 0.5 + 1e-9, 1.0 - 1e-9, 1.0 };
    grid->Values = { 0.1, least, 0.1, 0.1, least };
    SpacingOptions options;
    options.Gradation = 0.0;
    options.Sources.emplace_back(grid);
    const Spacing spacing = SpacingAroundUnitSquare(options);
    StoppingMonitor monitor(100);
    Pulse pulse(monitor);
    EdgeDivider divider(spacing, 0.5, 1.0, pulse);
    DivisionPoints points;
    divider.Divide({ 0.0, 0.0 }, { 0.0, 1.0 }, 100000, points);
    EXPECT_TRUE(std::is_sorted(points.Parameters.begin(), points.Parameters.end()));
    EXPECT_FALSE(pulse.HasStopped()) << least;
  }
}

TEST(EdgeDivider, RefusesMorePointsThanTheLimit)
{
  const Spacing spacing = SpacingAroundUnitSquare(UniformSpacing(0.01));
  Pulse pulse(NoMonitor());
  EdgeDivider divider(spacing, 0.8, 1.0, pulse);
  DivisionPoints points;
  EXPECT_TRUE(divider.Divide({ 0.0, 0.0 }, { 1.0, 0.0 }, 120, points));
  EXPECT_EQ(points.Parameters.size(), 99u);
  EXPECT_FALSE(divider.Divide({ 0.0, 0.0 }, { 1.0, 0.0 }, 80, points));
  EXPECT_FALSE(divider.Divide({ 0.0, 0.0 }, { 1e18, 0.0 }, 1000, points));
}

} // namespace

} // namespace biting
