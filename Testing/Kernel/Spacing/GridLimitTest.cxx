// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Spacing/GridLimit.h"

#include "SpacingSources.h"
#include "Support/TestThreads.h"

#include <gtest/gtest.h>

#include <numeric> // for nodes

namespace
{

using namespace biting;

/// Distances to seven by seven holes, as a field that is limited to `slope` already.
Field AroundHoles(double slope)
{
  return [slope](const Point2& x)
  {
    const Point2 inCell{ 7.0 * x.X - std::floor(7.0 * x.X), 7.0 * x.Y - std::floor(7.0 * x.Y) };
    const double away = std::max(Length(inCell - Point2{ 0.5, 0.5 }) / 7.0 - 0.02, 0.0);
    return 0.003 + slope * away;
  };
}

GridLimit LimitOf(const GridSource& grid, const Box2& bounds = UnitBox())
{
  return GridLimit(Share(grid), Gradation, bounds, { 1.0, 0.0, 1e9 }, NoMonitor());
}

/// Of a node, relative.
double LargestChange(const GridSource& grid)
{
  const GridLimit limit = LimitOf(grid);
  double largest = 0.0;
  for (std::size_t node = 0; limit.IsNeeded() && node < grid.Values.size(); ++node)
  {
    const std::size_t columns = grid.XNodes.size();
    const double limited = limit({ grid.XNodes[node % columns], grid.YNodes[node / columns] });
    largest = std::max(largest, 1.0 - limited / grid.Values[node]);
  }
  return largest;
}

/// Of a cell of unit size among many, so that it is no coarse one, which would be divided.
bool IsSteep(const std::array<double, 4>& corners)
{
  constexpr int Nodes = 200;
  GridSource grid = MakeGrid(Nodes, Nodes, [](const Point2&) { return 1.0; });
  for (std::vector<double>* nodes : { &grid.XNodes, &grid.YNodes })
  {
    std::iota(nodes->begin(), nodes->end(), 0.0);
  }
  for (std::size_t node = 0; node < grid.Values.size(); ++node)
  {
    grid.Values[node] = corners[(node % Nodes > 50 ? 1 : 0) + (node / Nodes > 50 ? 2 : 0)];
  }
  return LimitOf(grid).IsNeeded();
}

/// |f(x) - f(y)| <= g |x - y| + 2 % of f, over a box larger than the grid, and f nowhere above what
/// is given by more than that.
void ExpectLimited(const SpacingOptions& options, const Box2& bounds)
{
  const Spacing f = MakeGoodSpacing(options, bounds);
  SpacingOptions asGiven = options;
  asGiven.Gradation = 0.0;
  const Spacing given = MakeGoodSpacing(asGiven, bounds);
  Sampler sampler(41);
  for (int probe = 0; probe < 20000; ++probe)
  {
    const Point2 x = sampler.NextIn(bounds);
    const double reach = f(x) * std::exp(6.0 * sampler.Next() - 3.0);
    const double angle = 6.283185307179586 * sampler.Next();
    const Point2 y = x + reach * Point2{ std::cos(angle), std::sin(angle) };
    ASSERT_LE(f(x), 1.02 * given(x));
    ASSERT_GT(f(x), 0.0);
    if (bounds.Contains(y))
    {
      ASSERT_LE(std::abs(f(x) - f(y)), options.Gradation * reach + 0.02 * std::min(f(x), f(y)))
        << x.X << ' ' << x.Y << " and " << y.X << ' ' << y.Y;
    }
  }
}

SpacingOptions OfGrid(GridSource grid)
{
  SpacingOptions options;
  options.Grid = Share(std::move(grid));
  return options;
}

} // namespace

TEST(GridLimit, IsNeededAboveTheGradationWithAMargin)
{
  EXPECT_FALSE(IsSteep({ 1.0, 1.3, 1.0, 1.3 }));
  EXPECT_FALSE(IsSteep({ 1.0, 1.301, 1.0, 1.301 }));
  EXPECT_TRUE(IsSteep({ 1.0, 1.303, 1.0, 1.303 }));
  EXPECT_TRUE(IsSteep({ 1.0, 1.22, 1.22, 1.44 })) << "along the diagonal";
  EXPECT_FALSE(IsSteep({ 1.0, 1.21, 1.21, 1.42 }));
}

TEST(GridLimit, IsNeededWhereTheTwistOfACellAddsToF)
{
  EXPECT_TRUE(IsSteep({ 0.02, 0.31, 0.31, 0.02 }));
  EXPECT_FALSE(IsSteep({ 50.02, 50.31, 50.31, 50.02 }));
}

TEST(GridLimit, KeepsAFieldThatIsAsSteepAsTheGradation)
{
  for (int nodes : { 257, 513, 769 })
  {
    EXPECT_LE(LargestChange(MakeGrid(nodes, nodes, AroundHoles(Gradation))), 0.005) << nodes;
  }
}

TEST(GridLimit, KeepsAPlaneOfThatSlopeInAnyDirection)
{
  for (double angle = 0.0; angle < 6.3; angle += 0.1)
  {
    const Point2 slope{ Gradation * std::cos(angle), Gradation * std::sin(angle) };
    const GridSource grid =
      MakeGrid(65, 65, [&slope](const Point2& x) { return 0.5 + Dot(slope, x); });
    EXPECT_FALSE(LimitOf(grid).IsNeeded()) << angle;
  }
}

/// Also between the directions of the sides and diagonals of cells.
TEST(GridLimit, LowersAPlaneThatIsALittleSteeperInAnyDirection)
{
  for (double angle = 0.0; angle < 6.3; angle += 0.1)
  {
    const Point2 along{ std::cos(angle), std::sin(angle) };
    const double slope = 1.03 * Gradation;
    const double change = LargestChange(MakeGrid(65, 65,
      [&along, slope](const Point2& x) {
        return 0.7 + slope * Dot(along, x - Point2{ 0.5, 0.5 });
      }));
    EXPECT_GT(change, 0.005) << angle;
    EXPECT_LT(change, 0.03) << angle;
  }
}

/// Up to what floats round, from node to node of those that the cell is divided by.
TEST(GridLimit, GrowsFromTheSideOfACoarseCell)
{
  const GridLimit limit = LimitOf({ { 0.0, 1.0 }, { 0.0, 1.0 }, { 0.1, 0.9, 0.1, 0.9 } });
  for (double y : { 0.0, 0.2, 0.5, 0.9 })
  {
    for (double x : { 0.0, 0.1, 0.5, 1.0 })
    {
      EXPECT_NEAR(limit({ x, y }), 0.1 + Gradation * x, 1e-6);
    }
  }
}

TEST(GridLimit, GrowsFromASideWhoseValuesRise)
{
  const GridLimit limit =
    LimitOf({ { 0.0, 1.0, 2.0 }, { 0.0, 1.0 }, { 0.1, 0.9, 1.8, 0.28, 1.0, 1.8 } });
  const double across = Gradation * 0.8; // the cosine of the angle whose sine is .18 / g
  EXPECT_NEAR(limit({ 0.03, 0.9 }), 0.1 + 0.18 * 0.9 + across * 0.03, 1e-6);
  EXPECT_NEAR(limit({ 0.05, 0.95 }), 0.1 + 0.18 * 0.95 + across * 0.05, 1e-6);
}

/// From afar its nodes, of which this grid gets 91, are nearly as good: g w^2 / (8 d) at most.
TEST(GridLimit, GrowsFromTheNodesOfAFarSide)
{
  const GridLimit limit =
    LimitOf({ { 0.0, 1.0, 2.0 }, { 0.0, 1.0 }, { 0.1, 0.9, 1.8, 0.28, 1.0, 1.8 } });
  const double across = Gradation * 0.8;
  for (double x : { 0.3, 0.5, 0.8, 1.05 })
  {
    const double exact = 0.1 + 0.18 * 0.95 + across * x;
    const double error = limit({ x, 0.95 }) - exact;
    EXPECT_GE(error, -1e-6);
    EXPECT_LE(error, Gradation / (90.0 * 90.0) / (8.0 * x)) << x;
  }
}

TEST(GridLimit, LimitsTheNearestBorderValueAsFarAsTheBoundsReach)
{
  const auto steep = [](const Point2& x) { return 0.1 + 2.0 * x.Y; };
  const GridLimit limit = LimitOf(MakeGrid(5, 5, steep), { { -1.0, -0.5 }, { 3.0, 2.0 } });
  EXPECT_NEAR(limit({ 2.5, -0.5 }), 0.1, 1e-12);
  EXPECT_NEAR(limit({ 2.5, 0.5 }), 0.1 + 0.5 * Gradation, 1e-3);
  EXPECT_NEAR(limit({ -0.7, 1.5 }), 0.1 + 1.5 * Gradation, 1e-3);
}

TEST(GridLimit, ScalesAndClampsBeforeItLimits)
{
  const GridSource ramp{ { 0.0, 1.0 }, { 0.0, 1.0 }, { 0.1, 2.1, 0.1, 2.1 } };
  const GridLimit limit(Share(ramp), Gradation, UnitBox(), { 2.0, 0.6, 0.7 }, NoMonitor());
  EXPECT_EQ(limit({ 0.05, 0.5 }), 0.6);
  EXPECT_NEAR(limit({ 0.2, 0.5 }), 0.6 + 0.1 * Gradation, 0.005);
  EXPECT_EQ(limit({ 0.9, 0.5 }), 0.7);
}

TEST(GridLimit, HasNoMeaningOnceTheMonitorStops)
{
  class Stopping : public Monitor
  {
  public:
    bool Advance(double) override { return false; }
    void BeginStage(const char*) override {}
  };
  Stopping monitor;
  const GridSource steep = MakeGrid(100, 100, AroundHoles(1.0));
  EXPECT_FALSE(
    GridLimit(Share(steep), Gradation, UnitBox(), { 1.0, 0.0, 1.0 }, monitor).IsNeeded());
}

TEST(Spacing, IsLimitedOutsideOfAnImageOfHalfTheDomain)
{
  GridSource grid =
    MakeGrid(33, 65, [](const Point2& x) { return 0.01 + 0.75 * std::abs(x.Y - 0.5); });
  for (double& x : grid.XNodes)
  {
    x *= 0.5;
  }
  ExpectLimited(OfGrid(std::move(grid)), UnitBox());
}

TEST(Spacing, IsLimitedOutsideOfAnImageOfOneCell)
{
  ExpectLimited(OfGrid({ { 0.3, 0.7 }, { 0.3, 0.7 }, { 0.02, 2.0, 2.0, 0.02 } }), UnitBox());
  ExpectLimited(OfGrid({ { 0.3, 0.7 }, { 0.3, 0.7 }, { 0.02, 0.02, 2.0, 2.0 } }), UnitBox());
  ExpectLimited(OfGrid({ { 0.3 }, { 0.3, 0.7 }, { 0.02, 2.0 } }), UnitBox());
}

/// Between corners that are clamped f is as steep as what is given.
TEST(Spacing, IsLimitedWhereALargestValueClampsWithinCoarseCells)
{
  SpacingOptions options =
    OfGrid(MakeGrid(65, 65, [](const Point2& x) { return x.X < 0.5 ? 1e-4 : 0.5; }));
  options.Maximum = 0.0047;
  ExpectLimited(options, UnitBox());
}

TEST(Spacing, OfALimitedImageIsNowhereBelowTheLeastValue)
{
  SpacingOptions options =
    OfGrid(MakeGrid(201, 201, [](const Point2& x) { return x.X < 0.5 ? 0.01 : 0.2; }));
  for (const double minimum : { 0.02, 0.03 })
  {
    options.Minimum = minimum;
    const Spacing f = MakeGoodSpacing(options, UnitBox());
    Sampler sampler(7);
    for (int probe = 0; probe < 20000; ++probe)
    {
      EXPECT_GE(f(sampler.NextIn(UnitBox())), minimum);
    }
  }
}

/// From where what is given reaches the least value, within cells.
TEST(Spacing, IsLimitedWhereALeastValueRaisesNoiseOnCoarseCells)
{
  Sampler sampler(11);
  for (int image = 0; image < 12; ++image)
  {
    const int columns = 2 + image;
    SpacingOptions options = OfGrid(MakeGrid(
      columns, 13 - image, [&sampler](const Point2&) { return std::exp(-5.0 * sampler.Next()); }));
    options.Minimum = 0.03;
    options.Gradation = 0.1 + 0.9 * sampler.Next();
    ExpectLimited(options, UnitBox());
  }
}

/// From a circle within cells, near it and from afar, where cells are small, large and long.
TEST(Spacing, GrowsAllAroundWhereALeastValueCutsAHollow)
{
  constexpr double Radius = 0.06;
  for (const double power : { 1.0, 0.6, 2.0 })
  {
    SpacingOptions options = OfGrid(MakeGrid(
      300, 200,
      [](const Point2& x) {
        return 1e-6 + 5.0 * std::max(Length(x - Point2{ 0.45, 0.55 }) - 0.05, 0.0);
      },
      power));
    options.Minimum = 0.05;
    const Spacing f = MakeGoodSpacing(options);
    Sampler sampler(14);
    for (int probe = 0; probe < 5000; ++probe)
    {
      const Point2 x = sampler.NextIn(UnitBox());
      const double way = std::max(Length(x - Point2{ 0.45, 0.55 }) - Radius, 0.0);
      const double exact = options.Minimum + options.Gradation * way;
      ASSERT_NEAR(f(x), exact, 0.02 * exact) << x.X << ' ' << x.Y;
    }
  }
}

TEST(Spacing, IsLimitedWithinALongCellOfNoise)
{
  Sampler sampler(12);
  GridSource grid =
    MakeGrid(5, 30, [&sampler](const Point2&) { return std::exp(-6.0 * sampler.Next()); });
  ExpectLimited(OfGrid(std::move(grid)), UnitBox());
}

/// Floats hold no values above 3e38 nor, as precisely, below 1e-38.
TEST(Spacing, IsLimitedInDrawingsOfAnySize)
{
  const auto field = [](const Point2& x) { return 0.01 + std::abs(x.X - 0.5); };
  const Spacing f = MakeGoodSpacing(OfGrid(MakeGrid(33, 33, field)));
  for (const int power : { -300, -200, -140, 130, 200 })
  {
    const double size = std::ldexp(1.0, power);
    GridSource grid = MakeGrid(33, 33, field);
    for (std::vector<double>* numbers : { &grid.XNodes, &grid.YNodes, &grid.Values })
    {
      for (double& number : *numbers)
      {
        number *= size;
      }
    }
    const Spacing scaled = MakeGoodSpacing(OfGrid(std::move(grid)), { {}, { size, size } });
    Sampler sampler(13);
    for (int probe = 0; probe < 200; ++probe)
    {
      const Point2 x = sampler.NextIn(UnitBox());
      EXPECT_EQ(scaled(size * x), size * f(x)) << power;
    }
  }
}

/// Floats do not hold it and what f grows to.
TEST(Spacing, GrowsFromAValueThatIsNothingBesideTheDrawing)
{
  for (const double least : { 1e-20, 1e-100, 1e-300 })
  {
    const Spacing f = MakeGoodSpacing(
      OfGrid(MakeGrid(33, 33, [least](const Point2& x) { return x.X == 0.5 ? least : 1.0; })));
    EXPECT_NEAR(f({ 0.6, 0.5 }), 0.03, 1e-4) << least;
    EXPECT_LE(f({ 0.5, 0.5 }), 1e-20);
  }
}

TEST(Spacing, IsLimitedOutsideOfNoise)
{
  Sampler sampler(9);
  GridSource grid =
    MakeGrid(20, 20, [&sampler](const Point2&) { return 0.02 + 0.2 * sampler.Next(); });
  for (std::vector<double>* nodes : { &grid.XNodes, &grid.YNodes })
  {
    for (double& node : *nodes)
    {
      node = 0.3 + 0.4 * node;
    }
  }
  ExpectLimited(OfGrid(std::move(grid)), UnitBox());
}

TEST(Spacing, IsLimitedWithinCoarseCellsThatAreSteepOnlyInside)
{
  ExpectLimited(OfGrid({ { 0.0, 1.0 }, { 0.0, 1.0 }, { 0.02, 0.31, 0.31, 0.02 } }), UnitBox());
}

TEST(Spacing, IsThatOfTheDataBesideFillValues)
{
  for (double fill : { 1e20, 9.97e36, 1e300 })
  {
    for (double gradation : { 0.0, 0.3, 2.0 })
    {
      SpacingOptions options = OfGrid(
        { { 0.0, 0.5, 1.0 }, { 0.0, 0.5, 1.0 }, { 0.1, 0.1, 0.1, 0.1, fill, 0.1, 0.1, 0.1, 0.1 } });
      options.Gradation = gradation;
      const Spacing f = MakeGoodSpacing(options);
      Sampler sampler(43);
      for (int probe = 0; probe < 5000; ++probe)
      {
        const Point2 x = sampler.NextIn(UnitBox());
        ASSERT_GE(f(x), 0.1 * (1.0 - 1e-12)) << fill;
        const double border = std::min({ x.X, x.Y, 1.0 - x.X, 1.0 - x.Y });
        ASSERT_TRUE(gradation == 0.0 || f(x) <= 1.02 * (0.1 + gradation * border)) << fill;
      }
    }
  }
}

/// With lines of the least value, and cells that are not steep.
TEST(GridLimit, IsTheSameOnAnyNumberOfThreads)
{
  Sampler sampler(23);
  const auto source = std::make_shared<GridSource>(MakeGrid(601, 402,
    [&sampler](const Point2& x) { return x.X < 0.5 ? 0.5 : 0.01 + 0.1 * sampler.Next(); }));
  const auto limitOn = [&source](Monitor& monitor) {
    return GridLimit(source, 0.3, { { -0.2, 0.0 }, { 1.0, 1.1 } }, { 1.0, 0.02, 1.0 }, monitor);
  };
  const GridLimit expected = limitOn(NoMonitor());
  ASSERT_TRUE(expected.IsNeeded());
  for (const int threads : { 2, 3 })
  {
    MonitorWithThreads monitor(threads);
    const GridLimit limit = limitOn(monitor);
    for (int k = 0; k < 20000; ++k)
    {
      const Point2 x = sampler.NextIn(UnitBox());
      ASSERT_EQ(limit(x), expected(x));
    }
  }
}
