// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Base/CellIndex.h"

#include <gtest/gtest.h>

#include <algorithm> // for sort
#include <utility>   // for pairs
#include <vector>    // for what was visited

namespace biting
{

namespace
{

using Visited = std::vector<std::pair<Id, Id>>;

Visited CellsAt(const CellBox& box, Id columns, Id rows)
{
  Visited visited;
  VisitCellsAt(box, columns, rows,
    [&visited](Id column, Id row)
    {
      visited.emplace_back(column, row);
      return false;
    });
  return visited;
}

} // namespace

TEST(CellIndex, IsThatOfTheNearestCellBeyondTheEnds)
{
  EXPECT_EQ(ClampedIndex(-1e300, 4), 0);
  EXPECT_EQ(ClampedIndex(-0.5, 4), 0);
  EXPECT_EQ(ClampedIndex(0.0, 4), 0);
  EXPECT_EQ(ClampedIndex(0.999, 4), 0);
  EXPECT_EQ(ClampedIndex(1.0, 4), 1);
  EXPECT_EQ(ClampedIndex(3.5, 4), 3);
  EXPECT_EQ(ClampedIndex(4.0, 4), 3);
  EXPECT_EQ(ClampedIndex(1e300, 4), 3);
}

TEST(CellBox, MeetsCellsRowByRow)
{
  EXPECT_EQ(
    CellsAt({ 0.5, 1.5, 1.5, 2.5 }, 4, 4), (Visited{ { 0, 1 }, { 1, 1 }, { 0, 2 }, { 1, 2 } }));
  EXPECT_EQ(CellsAt({ 2.25, 0.25, 2.75, 0.75 }, 4, 4), (Visited{ { 2, 0 } }));
  EXPECT_EQ(CellsAt({ 7.0, -3.0, 9.0, -2.0 }, 4, 4), (Visited{ { 3, 0 } })) << "beyond the grid";
}

TEST(CellBox, IsVisitedUntilTrue)
{
  int count = 0;
  const auto third = [&count](Id, Id) { return ++count == 3; };
  EXPECT_TRUE(VisitCellsAt({ 0.0, 0.0, 4.0, 4.0 }, 4, 4, third));
  EXPECT_EQ(count, 3);
  EXPECT_FALSE(VisitCellsAt({ 0.5, 0.5, 0.5, 0.5 }, 4, 4, [](Id, Id) { return false; }));
}

TEST(CellBox, OfPartsMeetsThePartsOfTheCellsThatTheWholeMeets)
{
  const CellBox box{ 1.3, 0.6, 2.2, 1.4 };
  Visited ofWhole;
  for (const auto& [column, row] : CellsAt(box, 4, 4))
  {
    const CellBox inParts = box.From(column, row).Divided(4, 2);
    for (const auto& [partColumn, partRow] : CellsAt(inParts, 4, 2))
    {
      ofWhole.emplace_back(4 * column + partColumn, 2 * row + partRow);
    }
  }
  Visited ofParts = CellsAt(box.Divided(4, 2), 16, 8);
  std::sort(ofWhole.begin(), ofWhole.end());
  std::sort(ofParts.begin(), ofParts.end());
  EXPECT_EQ(ofWhole, ofParts);
}

} // namespace biting
