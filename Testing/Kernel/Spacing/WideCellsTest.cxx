// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Spacing/WideCells.h"

#include "SpacingSources.h"

#include <gtest/gtest.h>

namespace
{

using namespace biting;

/// Nodes that bound themselves.
std::vector<NodeBound> OwnBounds(const GridSource& grid)
{
  std::vector<NodeBound> bounds;
  for (std::size_t node = 0; node < grid.Values.size(); ++node)
  {
    const auto value = static_cast<float>(grid.Values[node]);
    const std::size_t columns = grid.XNodes.size();
    bounds.push_back({ value, value,
      { static_cast<float>(grid.XNodes[node % columns]),
        static_cast<float>(grid.YNodes[node / columns]) } });
  }
  return bounds;
}

std::size_t NumberOfCones(const GridSource& grid)
{
  ConeCollector cones({ 1.0, 0.0, 1e9 });
  const GridCells cells(grid, 0.3, cones.Values());
  const std::vector<NodeBound> bounds = OwnBounds(grid);
  Pulse pulse(NoMonitor());
  EXPECT_TRUE(WideCells(cells, bounds, cones, pulse).AddCones());
  return cones.Segments().Segments.size() / 2;
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
      ASSERT_LE(std::abs(f(x) - f(y)), 0.3 * reach + 0.02 * std::min(f(x), f(y)))
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

TEST(WideCells, AreNoneWhereCellsAreSmall)
{
  EXPECT_EQ(NumberOfCones(MakeGrid(33, 33, [](const Point2& x) { return 0.5 + x.X; })), 0u);
}

TEST(WideCells, GrowFromTheSidesOfSteepOnes)
{
  EXPECT_GE(NumberOfCones({ { 0.0, 1.0 }, { 0.0, 1.0 }, { 0.1, 0.1, 0.9, 0.9 } }), 1u);
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
