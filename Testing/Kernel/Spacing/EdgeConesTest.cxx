// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Spacing/EdgeCones.h"

#include "Spacing/EdgeBound.h"
#include "SpacingSources.h"

#include <gtest/gtest.h>

namespace
{

using namespace biting;

constexpr double Gradation = 0.3;

double LowestOf(const std::vector<SegmentCone>& cones, const Point2& x)
{
  double least = std::numeric_limits<double>::infinity();
  for (const SegmentCone& cone : cones)
  {
    least = std::min(least, cone(x, Gradation));
  }
  return least;
}

} // namespace

/// With the points that begin where the edge is too steep for a cone, and up to the most.
TEST(EdgeCones, AllowWhatTheBoundOfTheEdgeAllows)
{
  Sampler sampler(51);
  for (int edge = 0; edge < 2000; ++edge)
  {
    const EdgeEnd start{ sampler.NextIn(UnitBox()), 2.0 * sampler.Next() };
    const EdgeEnd end{ start.Place + 3.0 * (sampler.NextIn(UnitBox()) - Point2{ 0.5, 0.5 }),
      edge % 5 == 0 ? start.Value : 2.0 * sampler.Next() };
    const ValueRange range{ 0.5 + sampler.Next(), edge % 2 == 0 ? 0.0 : 0.5, edge % 3 ? 9.0 : 0.9 };
    const EdgeBound bound(range, Gradation);
    std::vector<SegmentCone> cones;
    AddEdgeCones(start, end, range, Gradation, cones);
    const EdgeEnd& low = start.Value < end.Value ? start : end;
    cones.emplace_back(low.Place, low.Place, range(low.Value), range(low.Value), Gradation);
    const Point2 along = (1.0 / Distance(start.Place, end.Place)) * (end.Place - start.Place);
    for (int probe = 0; probe < 20; ++probe)
    {
      const Point2 offset = 4.0 * (sampler.NextIn(UnitBox()) - Point2{ 0.5, 0.5 });
      const double expected = std::min(range.Most,
        bound(Dot(offset, along), Cross(offset, along), Distance(start.Place, end.Place),
          start.Value, end.Value));
      const double found = std::min(LowestOf(cones, start.Place + offset), range.Most);
      ASSERT_NEAR(found, expected, 1e-9) << edge;
    }
  }
}

TEST(EdgeCones, AreNoneOfASteepEdge)
{
  std::vector<SegmentCone> cones;
  AddEdgeCones({ { 0.0, 0.0 }, 1.0 }, { { 1.0, 0.0 }, 2.0 }, { 1.0, 0.0, 9.0 }, Gradation, cones);
  EXPECT_TRUE(cones.empty());
}

TEST(EdgeCones, AreNoneOfAnEdgeAboveTheMost)
{
  std::vector<SegmentCone> cones;
  AddEdgeCones({ { 0.0, 0.0 }, 1.0 }, { { 1.0, 0.0 }, 1.1 }, { 1.0, 0.0, 0.5 }, Gradation, cones);
  EXPECT_TRUE(cones.empty());
}
