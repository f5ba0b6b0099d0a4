// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Spacing/SourceEdges.h"

#include "SpacingSources.h"

#include <gtest/gtest.h>

#include <set> // for neighbors

using namespace biting;

namespace
{

SourceEdges EdgesOf(const TriangulatedSource& source, const std::vector<bool>& isSteep)
{
  Pulse pulse(NoMonitor());
  return SourceEdges(source, isSteep, pulse);
}

} // namespace

TEST(SourceEdges, LeadFromEachPointToItsNeighborsOnce)
{
  const TriangulatedSource source =
    MakeTriangulation(6, [](const Point2& x) { return 1.0 + x.X + 7.0 * x.Y; });
  const SourceEdges edges = EdgesOf(source, std::vector<bool>(50, false));
  for (Id point = 0; point < 36; ++point)
  {
    std::set<Id> expected;
    for (std::size_t corner = 0; corner < source.Triangles.size(); ++corner)
    {
      const std::size_t first = corner - corner % 3;
      for (std::size_t other = first; source.Triangles[corner] == point && other < first + 3;
           ++other)
      {
        expected.insert(source.Triangles[other]);
      }
    }
    expected.erase(point);
    std::set<Id> found;
    for (const SourceEdges::Edge& edge : edges(point))
    {
      const auto to = static_cast<std::size_t>(edge.To);
      EXPECT_TRUE(found.insert(edge.To).second);
      EXPECT_EQ(edge.End, source.Values[to]);
      EXPECT_TRUE(edge.Along == source.Points[to] - source.Points[static_cast<std::size_t>(point)]);
    }
    EXPECT_EQ(found, expected);
  }
}

TEST(SourceEdges, AreSteepBesideASteepTriangle)
{
  const TriangulatedSource source{ { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } }, { 1, 1, 1, 1 },
    { 0, 1, 2, 0, 2, 3 } };
  const SourceEdges edges = EdgesOf(source, { false, true });
  for (const SourceEdges::Edge& edge : edges(0))
  {
    EXPECT_EQ(edge.IsSteep, edge.To != 1) << edge.To;
  }
}
