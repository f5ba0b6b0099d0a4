// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Spacing/ExtendedGrid.h"

#include "Spacing/GridInterpolator.h"
#include "SpacingSources.h"

#include <gtest/gtest.h>

namespace
{

using namespace biting;

const Box2 Bounds{ { -0.7, -0.2 }, { 1.5, 3.0 } };

GridSource Noise(int columns, int rows)
{
  Sampler sampler(61);
  return MakeGrid(
    columns, rows, [&sampler](const Point2&) { return 0.1 + sampler.Next(); }, 1.4);
}

bool IsAscending(const std::vector<double>& nodes)
{
  return std::is_sorted(nodes.begin(), nodes.end());
}

} // namespace

TEST(ExtendedGrid, IsTheSameSpacingOutToTheBounds)
{
  for (const GridSource& source :
    { Noise(2, 2), Noise(5, 3), Noise(270, 280), GridSource{ { 0.3 }, { 0.3, 0.7 }, { 0.02, 2.0 } },
      GridSource{ { 0.3 }, { 0.4 }, { 0.1 } } })
  {
    const GridInterpolator given(Share(source));
    const auto extended = ExtendedGrid(Share(source), Bounds);
    const GridInterpolator found(extended);
    Sampler sampler(62);
    for (int probe = 0; probe < 2000; ++probe)
    {
      const Point2 x = sampler.NextIn(Bounds);
      ASSERT_NEAR(found(x), given(x), 1e-12);
    }
    for (const std::vector<double>* nodes : { &extended->XNodes, &extended->YNodes })
    {
      ASSERT_TRUE(IsAscending(*nodes));
    }
    ASSERT_NEAR(extended->XNodes.front(), Bounds.Low.X, 1e-15);
    ASSERT_NEAR(extended->YNodes.back(), Bounds.High.Y, 1e-15);
  }
}

TEST(ExtendedGrid, HasThousandsOfCellsNoneOfThemLong)
{
  for (const GridSource& source : { Noise(5, 3), Noise(3, 60), Noise(2, 2) })
  {
    const auto extended = ExtendedGrid(Share(source), {});
    EXPECT_GE(extended->Values.size(), 128 * 128);
    EXPECT_LE(extended->Values.size(), (128 + 60) * (128 + 60));
    EXPECT_EQ(extended->Values.size(), extended->XNodes.size() * extended->YNodes.size());
    for (const std::vector<double>* nodes : { &extended->XNodes, &extended->YNodes })
    {
      for (std::size_t node = 1; node < nodes->size(); ++node)
      {
        EXPECT_LE((*nodes)[node] - (*nodes)[node - 1], (1.0 + 1e-8) / 128.0);
      }
    }
  }
}

/// A hundred times as many nodes as the source would take its time, and nodes outside count, too.
TEST(ExtendedGrid, DividesLongCellsOfVeryManyColumnsLessOrNotAtAll)
{
  for (const int columns : { 3000, 30000, 100000 })
  {
    for (const double height : { 1.0, 64.0 })
    {
      GridSource source{ UnitNodes(columns), { 0.0, height }, {} };
      source.Values.assign(2 * source.XNodes.size(), 1.0);
      const std::size_t given = source.Values.size();
      const auto shared = Share(std::move(source));
      const auto inside = ExtendedGrid(shared, {});
      EXPECT_EQ(inside->XNodes.size(), static_cast<std::size_t>(columns));
      EXPECT_LE(inside->Values.size(), std::max<std::size_t>(1 << 17, given));
      EXPECT_EQ(inside == shared, columns > 50000) << columns;
      const auto beyond = ExtendedGrid(shared, { { -3.0, -3.0 }, { 4.0, 3.0 + height } });
      EXPECT_LE(beyond->Values.size(), std::max<std::size_t>(1 << 17, 6 * given));
    }
  }
}

TEST(ExtendedGrid, KeepsJumpsBetweenNodesAtOnePlace)
{
  const auto extended = ExtendedGrid(Share(GridSource{ { 0.0, 1.0, 1.0, 2.0 }, { 0.0, 1.0 },
                                       { 0.1, 0.1, 0.5, 0.5, 0.1, 0.1, 0.5, 0.5 } }),
    {});
  const GridInterpolator found(extended);
  EXPECT_NEAR(found({ 0.999, 0.5 }), 0.1, 1e-12);
  EXPECT_NEAR(found({ 1.001, 0.5 }), 0.5, 1e-12);
}

TEST(ExtendedGrid, IsTheSourceItselfWhereThatIsEnough)
{
  const auto source = Share(Noise(270, 280));
  EXPECT_EQ(ExtendedGrid(source, UnitBox()), source);
  EXPECT_EQ(ExtendedGrid(source, {}), source);
}
