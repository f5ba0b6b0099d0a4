// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Spacing/GridSweeps.h"

#include "SpacingSources.h"

#include <gtest/gtest.h>

#include <set>

namespace
{

using namespace biting;

constexpr std::size_t Columns = 23;
constexpr std::size_t Rows = 17;

} // namespace

/// Each node takes the least number of steps to one that has it.
TEST(GridSweeps, HandOnToAllNodesOfAGrid)
{
  SilentMonitor monitor;
  Pulse pulse(monitor);
  for (const auto& [column, row] :
    { std::pair<std::size_t, std::size_t>{ 0, 0 }, { 22, 16 }, { 11, 5 }, { 0, 16 }, { 22, 0 } })
  {
    GridSweeps sweeps(Columns, Rows);
    std::vector<int> steps(Columns * Rows, 1000);
    steps[column + Columns * row] = 0;
    sweeps.Add(column, row);
    sweeps.Run(pulse,
      [&steps](std::size_t from, std::size_t to, std::size_t ofColumn, std::size_t ofRow)
      {
        EXPECT_EQ(to, ofColumn + Columns * ofRow);
        const bool isLess = steps[from] + 1 < steps[to];
        steps[to] = isLess ? steps[from] + 1 : steps[to];
        return isLess;
      });
    for (std::size_t node = 0; node < steps.size(); ++node)
    {
      const auto across = static_cast<int>(node % Columns) - static_cast<int>(column);
      const auto up = static_cast<int>(node / Columns) - static_cast<int>(row);
      ASSERT_EQ(steps[node], std::max(std::abs(across), std::abs(up)))
        << node << " from " << column << ", " << row;
      ASSERT_LT(sweeps.OfRows(node / Columns, node / Columns).First, Columns);
    }
  }
}

TEST(GridSweeps, AskNeighborsOfStretchesOnly)
{
  SilentMonitor monitor;
  Pulse pulse(monitor);
  GridSweeps sweeps(Columns, Rows);
  sweeps.Add(5, 3);
  sweeps.Add(8, 3);
  std::set<std::size_t> asked;
  sweeps.Run(pulse,
    [&asked](std::size_t, std::size_t to, std::size_t, std::size_t)
    {
      asked.insert(to);
      return false;
    });
  for (const std::size_t node : asked)
  {
    EXPECT_GE(node % Columns, 4);
    EXPECT_LE(node % Columns, 9);
    EXPECT_GE(node / Columns, 2);
    EXPECT_LE(node / Columns, 4);
  }
  EXPECT_EQ(asked.size(), 18);
}
