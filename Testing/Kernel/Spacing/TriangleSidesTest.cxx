// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Spacing/TriangleSides.h"

#include "SpacingSources.h"

#include <gtest/gtest.h>

#include <map>     // for counts
#include <numeric> // for iota
#include <utility> // for pair

namespace
{

using namespace biting;

using Edge = std::pair<Id, Id>;

/// How many sides each edge has; each edge is visited once.
std::map<Edge, std::ptrdiff_t> EdgesOf(
  const TriangulatedSource& source, const std::vector<Id>& triangles)
{
  Pulse pulse(NoMonitor());
  const TriangleSides sides(source, triangles, pulse);
  std::map<Edge, std::ptrdiff_t> edges;
  sides.ForEachEdge(pulse,
    [&](const Id* first, const Id* last)
    {
      const Edge edge{ sides.LowEnd(*first), sides.HighEnd(*first) };
      EXPECT_TRUE(edges.emplace(edge, last - first).second);
      for (const Id* side = first; side < last; ++side)
      {
        EXPECT_EQ(edge, Edge(std::minmax({ sides.StartOf(*side), sides.EndOf(*side) })));
        EXPECT_NE(sides.OppositeOf(*side), edge.first);
        EXPECT_NE(sides.OppositeOf(*side), edge.second);
      }
    });
  return edges;
}

TriangulatedSource SixBySix()
{
  return MakeTriangulation(6, [](const Point2&) { return 1.0; });
}

} // namespace

TEST(TriangleSides, OfOneEdgeAreVisitedTogether)
{
  const TriangulatedSource source = SixBySix();
  std::vector<Id> all(source.Triangles.size() / 3);
  std::iota(all.begin(), all.end(), 0);
  const std::map<Edge, std::ptrdiff_t> edges = EdgesOf(source, all);
  EXPECT_EQ(edges.size(), 85u); // 30 along each axis, 25 diagonals
  std::ptrdiff_t border = 0;
  for (const auto& [edge, count] : edges)
  {
    border += count == 1 ? 1 : 0;
    EXPECT_LE(count, 2);
  }
  EXPECT_EQ(border, 20);
}

TEST(TriangleSides, AreThoseOfTheTrianglesThatAreAskedFor)
{
  const std::map<Edge, std::ptrdiff_t> edges = EdgesOf(SixBySix(), { 7, 8 });
  std::ptrdiff_t sides = 0;
  for (const auto& [edge, count] : edges)
  {
    sides += count;
  }
  EXPECT_EQ(sides, 6);
  EXPECT_TRUE(EdgesOf(SixBySix(), {}).empty());
}
