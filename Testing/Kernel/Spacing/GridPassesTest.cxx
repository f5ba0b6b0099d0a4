// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Spacing/GridPasses.h"

#include "SpacingSources.h"
#include "Support/TestThreads.h"

#include <gtest/gtest.h>

namespace
{

using namespace biting;

/// After the passes.
GridSource Limited(GridSource grid, Monitor& monitor = NoMonitor())
{
  std::vector<float> values(grid.Values.begin(), grid.Values.end());
  Pulse pulse(monitor);
  EXPECT_TRUE(RunGridPasses(grid.XNodes, grid.YNodes, Gradation, values, pulse));
  grid.Values.assign(values.begin(), values.end());
  return grid;
}

Point2 PlaceOf(const GridSource& grid, std::size_t node)
{
  return { grid.XNodes[node % grid.XNodes.size()], grid.YNodes[node / grid.XNodes.size()] };
}

/// The unit square, with cells so many times as wide as high, and 0 in the middle.
GridSource OnePoint(int columns, int rows)
{
  GridSource grid = MakeGrid(columns, rows, [](const Point2&) { return 1e6; });
  grid.Values[grid.Values.size() / 2] = 0.0;
  return grid;
}

/// Of values above the distance to that point, relative; none is below, but for rounding.
double LargestDetour(const GridSource& grid, std::size_t middle)
{
  const GridSource limited = Limited(grid);
  double largest = 0.0;
  for (std::size_t node = 0; node < grid.Values.size(); ++node)
  {
    const double exact = Gradation * Distance(PlaceOf(grid, node), PlaceOf(grid, middle));
    EXPECT_GE(limited.Values[node], exact * (1.0 - 1e-5));
    largest = node != middle ? std::max(largest, limited.Values[node] / exact - 1.0) : largest;
  }
  return largest;
}

double LargestDetour(const GridSource& grid)
{
  return LargestDetour(grid, grid.Values.size() / 2);
}

} // namespace

TEST(GridPasses, GrowFromOneNodeInAllDirectionsAlike)
{
  EXPECT_LE(LargestDetour(OnePoint(101, 101)), 0.0034);
  EXPECT_LE(LargestDetour(OnePoint(101, 201)), 0.005);
  EXPECT_LE(LargestDetour(OnePoint(41, 201)), 0.01);
  EXPECT_LE(LargestDetour(OnePoint(201, 41)), 0.01);
  EXPECT_LE(LargestDetour(OnePoint(21, 401)), 0.005);
  EXPECT_LE(LargestDetour(OnePoint(801, 11)), 0.005);
}

/// Rows are near each other below, as in boundary layers: cells are up to 2000 times as long.
TEST(GridPasses, GrowAlikeWhereCellsAreLongSomewhere)
{
  GridSource grid = MakeGrid(101, 200, [](const Point2&) { return 1e6; });
  grid.YNodes = UnitNodes(200, 3.0);
  for (const std::size_t row : { 0, 40, 120 })
  {
    GridSource one = grid;
    one.Values[50 + 101 * row] = 0.0;
    EXPECT_LE(LargestDetour(one, 50 + 101 * row), 0.005);
  }
}

TEST(GridPasses, KeepAPlaneOfThatSlopeInAnyDirection)
{
  for (double angle = 0.0; angle < 6.3; angle += 0.1)
  {
    const Point2 slope{ Gradation * std::cos(angle), Gradation * std::sin(angle) };
    const GridSource grid = MakeGrid(
      40, 60, [&slope](const Point2& x) { return 0.5 + Dot(slope, x); }, 1.4);
    const GridSource limited = Limited(grid);
    for (std::size_t node = 0; node < grid.Values.size(); ++node)
    {
      EXPECT_NEAR(limited.Values[node], grid.Values[node], 1e-6);
    }
  }
}

/// From a row, along which values rise by the sine of an angle.
TEST(GridPasses, GrowFromBetweenTheNodesOfALine)
{
  for (const double sine : { 0.0, 0.3, 0.7, -0.5 })
  {
    const GridSource limited = Limited(MakeGrid(50, 50,
      [sine](const Point2& x) { return x.Y > 0.0 ? 1.0 : 0.5 + sine * Gradation * (x.X - 0.5); }));
    for (const std::size_t row : { 1u, 5u, 10u })
    {
      const double up = limited.YNodes[row] * std::sqrt(1.0 - sine * sine);
      const double exact = 0.5 + Gradation * (sine * (limited.XNodes[25] - 0.5) + up);
      EXPECT_NEAR(limited.Values[25 + 50 * row], exact, 1e-6) << sine;
    }
  }
}

TEST(GridPasses, LimitNoise)
{
  Sampler sampler(21);
  for (const double power : { 1.0, 1.5, 3.0 })
  {
    const GridSource grid = MakeGrid(
      30, 25, [&sampler](const Point2&) { return 0.01 + sampler.Next(); }, power);
    const GridSource limited = Limited(grid);
    for (std::size_t node = 0; node < grid.Values.size(); ++node)
    {
      double exact = grid.Values[node];
      for (std::size_t other = 0; other < grid.Values.size(); ++other)
      {
        exact = std::min(exact,
          grid.Values[other] + Gradation * Distance(PlaceOf(grid, node), PlaceOf(grid, other)));
      }
      EXPECT_LE(limited.Values[node], 1.01 * exact);
      EXPECT_GE(limited.Values[node], 0.95 * exact) << "along sides that are gentle";
    }
  }
}

/// Jumps between nodes at one place.
TEST(GridPasses, MayHaveCellsWithoutAnArea)
{
  const GridSource limited =
    Limited({ { 0.0, 1.0, 1.0, 2.0 }, { 0.0, 0.0, 1.0 }, { 5, 5, 5, 5, 5, 1, 5, 5, 5, 5, 5, 5 } });
  const std::vector<float> expected = { 1.3f, 1.0f, 1.0f, 1.3f };
  for (std::size_t node = 0; node < 8; ++node)
  {
    EXPECT_EQ(static_cast<float>(limited.Values[node]), expected[node % 4]) << node;
  }
}

TEST(GridPasses, AreTheSameOnAnyNumberOfThreads)
{
  Sampler sampler(22);
  const auto noise = [&sampler](const Point2&) { return 1e-4 + sampler.Next(); };
  for (const GridSource& grid : { MakeGrid(601, 520, noise), MakeGrid(40, 900, noise, 1.3) })
  {
    const std::vector<double> expected = Limited(grid).Values;
    for (const int threads : { 2, 3 })
    {
      MonitorWithThreads monitor(threads);
      EXPECT_TRUE(Limited(grid, monitor).Values == expected)
        << grid.XNodes.size() << " x " << grid.YNodes.size();
    }
  }
}

namespace
{

/// From the look on of that number.
class Stopping : public MonitorWithThreads
{
public:
  Stopping(int threads, int looks)
    : MonitorWithThreads(threads, std::chrono::milliseconds(0))
    , Looks(looks)
  {
  }

  bool Advance(double) override { return --this->Looks > 0; }

private:
  int Looks;
};

} // namespace

TEST(GridPasses, EndOnceTheMonitorStopsOnAnyNumberOfThreads)
{
  const std::vector<double> nodes = UnitNodes(1025);
  for (const int threads : { 1, 3 })
  {
    for (const int looks : { 1, 2, 3, 5, 10, 20 })
    {
      Stopping monitor(threads, looks);
      Pulse pulse(monitor);
      std::vector<float> values(nodes.size() * nodes.size(), 1.0f);
      EXPECT_FALSE(RunGridPasses(nodes, nodes, Gradation, values, pulse)) << looks;
    }
  }
}
