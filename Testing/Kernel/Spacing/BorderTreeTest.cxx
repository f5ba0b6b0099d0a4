// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Spacing/BorderTree.h"

#include "SpacingSources.h"

#include <gtest/gtest.h>

namespace
{

using namespace biting;

std::vector<BorderEdge> Scattered(int count)
{
  Sampler sampler(1);
  std::vector<BorderEdge> edges;
  for (int edge = 0; edge < count; ++edge)
  {
    const Point2 start = sampler.NextIn(UnitBox());
    edges.push_back({ start, start + 0.1 * sampler.NextIn(UnitBox()), sampler.Next(),
      sampler.Next(), 2 * edge, 2 * edge + 1 });
  }
  return edges;
}

} // namespace

TEST(BorderTree, FindsTheNearestOfAllEdges)
{
  Pulse pulse(NoMonitor());
  const std::vector<BorderEdge> edges = Scattered(200);
  const BorderTree tree(edges, pulse);
  Sampler sampler(2);
  for (int probe = 0; probe < 1000; ++probe)
  {
    const Point2 x = sampler.NextIn({ { -1.0, -1.0 }, { 2.0, 2.0 } });
    NearestValue nearest{ std::numeric_limits<double>::infinity(), 0.0 };
    for (const BorderEdge& edge : edges)
    {
      const NearestValue found = NearestOnEdge(edge, x);
      nearest = found.Distance < nearest.Distance ? found : nearest;
    }
    const NearestValue found = tree.Nearest(x, { std::numeric_limits<double>::infinity(), 0.0 });
    EXPECT_EQ(found.Distance, nearest.Distance);
    EXPECT_EQ(found.Value, nearest.Value);
    EXPECT_EQ(found.StartId, nearest.StartId);
  }
}

TEST(BorderTree, LeavesWhatIsKnownWhereNothingIsNearer)
{
  Pulse pulse(NoMonitor());
  const BorderTree tree(Scattered(20), pulse);
  const NearestValue known{ 1.0, 7.0, { 9.0, 9.0 } };
  EXPECT_EQ(tree.Nearest({ 10.0, 9.0 }, known).Value, 7.0);
  EXPECT_EQ(BorderTree().Nearest({ 10.0, 9.0 }, known).Value, 7.0);
}

TEST(BorderTree, HasTheValueOfThePlaceOnAnEdge)
{
  const BorderEdge edge{ { 0.0, 0.0 }, { 2.0, 0.0 }, 1.0, 3.0 };
  EXPECT_DOUBLE_EQ(NearestOnEdge(edge, { 0.5, 4.0 }).Value, 1.5);
  EXPECT_DOUBLE_EQ(NearestOnEdge(edge, { 0.5, 4.0 }).Distance, 4.0);
  EXPECT_DOUBLE_EQ(NearestOnEdge(edge, { 5.0, 4.0 }).Value, 3.0);
  EXPECT_DOUBLE_EQ(NearestOnEdge(edge, { 5.0, 4.0 }).Distance, 5.0);
  EXPECT_DOUBLE_EQ(
    NearestOnEdge({ { 1.0, 1.0 }, { 1.0, 1.0 }, 2.0, 2.0 }, { 4.0, 5.0 }).Value, 2.0);
}
