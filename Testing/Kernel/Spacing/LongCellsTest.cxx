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

constexpr ValueRange FromOne{ 1.0, 0.0, 1e9 };

GridLimit LimitAbove(const GridSource& grid)
{
  const Box2 bounds{ { 0.0, 0.0 }, { grid.XNodes.back(), grid.YNodes.back() } };
  return GridLimit(Share(grid), Gradation, bounds, FromOne, NoMonitor());
}

/// From all sides along x.
double Exact(const GridSource& grid, const Point2& x)
{
  const EdgeBound bound(FromOne, Gradation);
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

/// Rows that are a fifth, or a fiftieth, of the others apart, and columns as far as these; f is
/// smaller than their width.
GridSource WithFineRows(double share)
{
  constexpr int Coarse = 60;
  constexpr int Fine = 300;
  GridSource grid{ UnitNodes(161), { 0.0 }, {} };
  for (int row = 0; row < Coarse + Fine + Coarse; ++row)
  {
    const bool isFine = row >= Coarse && row < Coarse + Fine;
    grid.YNodes.push_back(grid.YNodes.back() + grid.XNodes[1] * (isFine ? share : 1.0));
  }
  return grid;
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
    const GridLimit limit = LimitAbove(grid);
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
    const GridLimit limit = LimitAbove(grid);
    const GridLimit transposed = LimitAbove(Transposed(grid));
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
  const GridLimit limit = LimitAbove(grid);
  const GridLimit transposed = LimitAbove(Transposed(grid));
  for (int probe = 0; probe < 40; ++probe)
  {
    const Point2 x = sampler.NextIn(UnitBox());
    const double exact = Exact(grid, x);
    ASSERT_NEAR(limit(x), exact, 0.02 * exact) << x.X << ' ' << x.Y;
    ASSERT_NEAR(transposed({ x.Y, x.X }), exact, 0.02 * exact) << x.X << ' ' << x.Y;
  }
}

/// Along a row from a node that is nearly 0 on, up to where the sides beside it exceed the least
/// value, which they do as steeply as f may not. What the next columns allow is far above.
TEST(GridLimit, GrowsFromAPlateauWithinLongCells)
{
  constexpr std::size_t Column = 80;
  constexpr std::size_t Row = 200;
  for (const double share : { 0.2, 0.02 })
  {
    GridSource grid = WithFineRows(share);
    const double width = grid.XNodes[1];
    const double least = 0.3 * Gradation * width;
    grid.Values.assign(grid.XNodes.size() * grid.YNodes.size(), 4.0 * least);
    grid.Values[Column + grid.XNodes.size() * Row] = 1e-6 * least;
    const Point2 node{ grid.XNodes[Column], grid.YNodes[Row] };
    const ValueRange range{ 1.0, least, 1e9 };
    const GridSource transposed = Transposed(grid);
    const GridLimit limit(
      Share(grid), Gradation, { {}, { 1.0, grid.YNodes.back() } }, range, NoMonitor());
    const GridLimit other(
      Share(transposed), Gradation, { {}, { grid.YNodes.back(), 1.0 } }, range, NoMonitor());
    Sampler sampler(46);
    for (int probe = 0; probe < 5000; ++probe)
    {
      const Point2 away = sampler.NextIn({ { -2.0 * width, -width }, { 2.0 * width, width } });
      const double beyond = std::max(std::abs(away.X) - 0.25 * width, 0.0);
      const double exact = std::min(least + Gradation * Length({ beyond, away.Y }), 4.0 * least);
      const Point2 x = node + away;
      // The plateau is as high as a row, about.
      const double inside = Gradation * width * share;
      ASSERT_LE(limit(x), 1.02 * exact) << away.X / width << ' ' << away.Y / width;
      ASSERT_GE(limit(x), 0.98 * exact - inside) << away.X / width << ' ' << away.Y / width;
      ASSERT_LE(other({ x.Y, x.X }), 1.02 * exact);
    }
  }
}

/// That is among the fine rows, or above or below in cells that are squares.
TEST(Spacing, IsLimitedWithinAndBesideLongCellsWithALeastValue)
{
  Sampler sampler(47);
  for (const double share : { 0.1, 0.03, 0.005 })
  {
    SpacingOptions options;
    GridSource grid = WithFineRows(share);
    options.Minimum = Gradation * grid.XNodes[1] * std::exp(-2.0 * sampler.Next());
    for (std::size_t node = 0; node < grid.XNodes.size() * grid.YNodes.size(); ++node)
    {
      grid.Values.push_back((sampler.Next() < 0.002 ? 1e-4 : 3.0) * options.Minimum);
    }
    const Box2 fine{ { 0.0, grid.YNodes[50] }, { 1.0, grid.YNodes[370] } };
    options.Grid = Share(std::move(grid));
    const Spacing f = MakeGoodSpacing(options, fine);
    for (int probe = 0; probe < 20000; ++probe)
    {
      const Point2 x = sampler.NextIn(fine);
      const double reach = f(x) * std::exp(5.0 * sampler.Next() - 2.0);
      const double angle = 6.283185307179586 * sampler.Next();
      const Point2 y = x + reach * Point2{ std::cos(angle), std::sin(angle) };
      if (fine.Contains(y))
      {
        ASSERT_LE(std::abs(f(x) - f(y)), Gradation * reach + 0.02 * std::min(f(x), f(y)))
          << x.X << ' ' << x.Y << " and " << y.X << ' ' << y.Y;
      }
    }
  }
}
