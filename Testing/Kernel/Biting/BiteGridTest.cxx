// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Biting/BiteGrid.h"
#include "../Support/MeshShapes.h"

#include <gtest/gtest.h>

#include <cstdint> // for counts

namespace biting
{

namespace
{

void AddBite(const Point2& center, const Point2& axis, double halfWidth, Bites& bites)
{
  bites.Centers.push_back(center);
  bites.Axes.push_back(axis);
  bites.HalfWidths.push_back(halfWidth);
  bites.Orders.push_back(bites.Size() - 1);
  bites.Phases.push_back(BitePhase::Interior);
}

/// Squares, each third one turned, with half-widths from .2 to .3 in the unit square.
Bites LargeBites(int count, std::uint64_t seed)
{
  TestNumbers numbers(seed);
  Bites bites;
  for (int k = 0; k < count; ++k)
  {
    const Point2 axis = k % 3 == 0 ? UnitVector(90.0 * numbers.Unit()) : Point2{ 1.0, 0.0 };
    const double x = numbers.Unit();
    AddBite({ x, numbers.Unit() }, axis, 0.2 + 0.1 * numbers.Unit(), bites);
  }
  return bites;
}

/// In how many leaves the bites stand, each counted as often as it is filed.
std::int64_t CountEntries(const Bites& bites)
{
  BiteGrid grid(bites, { { 0.0, 0.0 }, { 1.0, 1.0 } }, bites.Size());
  for (Id bite = 0; bite < bites.Size(); ++bite)
  {
    grid.File(bite);
  }
  std::int64_t filed = 0;
  grid.VisitSquare({ 0.5, 0.5 }, 1.0,
    [&filed](Id)
    {
      ++filed;
      return false;
    });
  return filed;
}

TEST(BiteGrid, FilesABiteInFewLeavesWhereTheyCrowd)
{
  const Bites bites = LargeBites(20000, 21);
  EXPECT_LT(CountEntries(bites), 40 * bites.Size());
}

// Remeshing, fuzz seed 8011040: gigabytes.
TEST(BiteGrid, DoesNotCopyACrowdOfLargeBitesToEachOfTheTinyOnesAmongThem)
{
  TestNumbers numbers(22);
  Bites bites = LargeBites(1000, 23);
  for (int k = 0; k < 1000; ++k)
  {
    AddBite({ numbers.Unit(), numbers.Unit() }, { 1.0, 0.0 }, 1e-10, bites);
  }
  EXPECT_LT(CountEntries(bites), 40 * bites.Size());
}

} // namespace

} // namespace biting
