// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

// Limits of grids whose cells are many times as long as wide.

#include "Spacing/EdgeBound.h"
#include "Spacing/GridLimit.h"

#include "SpacingSources.h"

#include <gtest/gtest.h>

namespace
{

using namespace biting;

constexpr double Gradation = 0.3;
constexpr ValueRange Range{ 1.0, 0.0, 1e9 };

GridLimit LimitOf(const GridSource& grid)
{
  const Box2 bounds{ { 0.0, 0.0 }, { grid.XNodes.back(), grid.YNodes.back() } };
  return GridLimit(Share(grid), Gradation, bounds, Range, NoMonitor());
}

/// From all sides along x.
double Exact(const GridSource& grid, const Point2& x)
{
  const EdgeBound bound(Range, Gradation);
  const std::size_t columns = grid.XNodes.size();
  double least = GridInterpolator(Share(grid))(x);
  for (std::size_t row = 0; row < grid.YNodes.size(); ++row)
  {
    for (std::size_t column = 0; column + 1 < columns; ++column)
    {
      const double* ends = &grid.Values[column + columns * row];
      const double start = grid.XNodes[column];
      least = std::min(least,
        bound(
          x.X - start, x.Y - grid.YNodes[row], grid.XNodes[column + 1] - start, ends[0], ends[1]));
    }
  }
  return least;
}

GridSource Transposed(const GridSource& grid)
{
  GridSource transposed{ grid.YNodes, grid.XNodes, {} };
  for (std::size_t node = 0; node < grid.Values.size(); ++node)
  {
    const std::size_t rows = grid.YNodes.size();
    transposed.Values.push_back(grid.Values[node / rows + node % rows * grid.XNodes.size()]);
  }
  return transposed;
}

} // namespace

/// From one node where rows are near each other, as in boundary layers: cells around it are up to a
/// hundred times as long as wide, and f is less than their length.
TEST(GridLimit, GrowsAlikeWithinLongCells)
{
  constexpr int Nodes = 300;
  for (const bool isTransposed : { false, true })
  {
    GridSource grid = MakeGrid(Nodes, Nodes, [](const Point2&) { return 1e3; });
    (isTransposed ? grid.XNodes : grid.YNodes) = UnitNodes(Nodes, 5.0);
    const std::size_t column = isTransposed ? 90 : 150;
    const std::size_t row = isTransposed ? 150 : 90;
    grid.Values[column + Nodes * row] = 1e-4;
    const GridLimit limit = LimitOf(grid);
    const Point2 node{ grid.XNodes[column], grid.YNodes[row] };
    Sampler sampler(43);
    for (int probe = 0; probe < 20000; ++probe)
    {
      const double reach = 0.5 * std::exp(-7.0 * sampler.Next());
      const double angle = 6.283185307179586 * sampler.Next();
      const Point2 x = node + reach * Point2{ std::cos(angle), std::sin(angle) };
      if (UnitBox().Contains(x))
      {
        const double exact = 1e-4 + Gradation * reach;
        ASSERT_NEAR(limit(x), exact, 0.015 * exact) << x.X << ' ' << x.Y;
      }
    }
  }
}

/// f .. 255 f at random at each node: far more rows have a say within a cell than are beside it,
/// and what they allow there is more than what is between the nodes' own.
TEST(GridLimit, IsWhatRowsOfNoiseAllowWithinLongCells)
{
  for (const double length : { 20.0, 100.0 })
  {
    Sampler sampler(44);
    GridSource grid{ {}, {}, {} };
    for (int column = 0; column < 12; ++column)
    {
      grid.XNodes.push_back(length * column);
    }
    for (int row = 0; row < 1500; ++row)
    {
      grid.YNodes.push_back(row);
    }
    while (grid.Values.size() < grid.XNodes.size() * grid.YNodes.size())
    {
      grid.Values.push_back(0.1 + 25.4 * sampler.Next());
    }
    const GridLimit limit = LimitOf(grid);
    const GridLimit transposed = LimitOf(Transposed(grid));
    for (int probe = 0; probe < 200; ++probe)
    {
      const Point2 x = sampler.NextIn({ { 0.0, 0.0 }, { 11.0 * length, 1499.0 } });
      const double exact = Exact(grid, x);
      ASSERT_NEAR(limit(x), exact, 0.05 * exact) << x.X << ' ' << x.Y;
      ASSERT_NEAR(transposed({ x.Y, x.X }), exact, 0.05 * exact) << x.X << ' ' << x.Y;
    }
  }
}

/// So many rows that they are left out in runs.
TEST(GridLimit, IsWhatOneOfVeryManyRowsAllowsWithinLongCells)
{
  Sampler sampler(45);
  GridSource grid{ { 0.0, 0.5, 1.0 }, UnitNodes(10000), {} };
  while (grid.Values.size() < 3 * grid.YNodes.size())
  {
    grid.Values.push_back(0.01 + 2.54 * sampler.Next());
  }
  const GridLimit limit = LimitOf(grid);
  const GridLimit transposed = LimitOf(Transposed(grid));
  for (int probe = 0; probe < 40; ++probe)
  {
    const Point2 x = sampler.NextIn(UnitBox());
    const double exact = Exact(grid, x);
    ASSERT_NEAR(limit(x), exact, 0.02 * exact) << x.X << ' ' << x.Y;
    ASSERT_NEAR(transposed({ x.Y, x.X }), exact, 0.02 * exact) << x.X << ' ' << x.Y;
  }
}
