// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Spacing/TriangleEdges.h"

#include "SpacingSources.h"

#include <gtest/gtest.h>

#include <set>     // for what is found
#include <utility> // for pair

namespace
{

using namespace biting;

using Edge = std::pair<Id, Id>;

struct Found
{
  std::set<Edge> All;
  std::set<Edge> Border;
};

Found EdgesOf(const std::vector<Id>& corners, std::size_t points)
{
  Pulse pulse(NoMonitor());
  const TriangleEdges edges(corners, points, pulse);
  Found found;
  for (std::size_t low = 0; low < points; ++low)
  {
    for (std::size_t edge = edges.FirstAt(low); edge < edges.FirstAt(low + 1); ++edge)
    {
      const Edge ends{ static_cast<Id>(low), edges.HighEnd(edge) };
      EXPECT_LT(ends.first, ends.second);
      EXPECT_TRUE(found.All.empty() || *found.All.rbegin() < ends);
      found.All.insert(ends);
      if (edges.IsBorder(edge))
      {
        found.Border.insert(ends);
      }
    }
  }
  return found;
}

/// All triangles counterclockwise.
TriangulatedSource SixBySix()
{
  TriangulatedSource source = MakeTriangulation(6, [](const Point2&) { return 1.0; });
  for (auto corner = source.Triangles.begin(); corner != source.Triangles.end(); corner += 3)
  {
    const auto placeOf = [&source](Id point)
    { return source.Points[static_cast<std::size_t>(point)]; };
    const Point2 origin = placeOf(corner[0]);
    if (Cross(placeOf(corner[1]) - origin, placeOf(corner[2]) - origin) < 0.0)
    {
      std::swap(corner[1], corner[2]);
    }
  }
  return source;
}

} // namespace

TEST(TriangleEdges, AreFoundOnceInTheOrderOfTheirEnds)
{
  const TriangulatedSource source = SixBySix();
  const Found found = EdgesOf(source.Triangles, source.Points.size());
  EXPECT_EQ(found.All.size(), 85u); // 30 along each axis, 25 diagonals
  for (std::size_t corner = 0; corner < source.Triangles.size(); ++corner)
  {
    const Id next = source.Triangles[corner % 3 == 2 ? corner - 2 : corner + 1];
    EXPECT_EQ(found.All.count(std::minmax(source.Triangles[corner], next)), 1u);
  }
}

TEST(TriangleEdges, OfOneTriangleOnlyAreTheBorder)
{
  const TriangulatedSource source = SixBySix();
  const Found found = EdgesOf(source.Triangles, source.Points.size());
  EXPECT_EQ(found.Border.size(), 20u);
  for (const auto& [low, high] : found.Border)
  {
    const Point2 middle = Midpoint(
      source.Points[static_cast<std::size_t>(low)], source.Points[static_cast<std::size_t>(high)]);
    EXPECT_EQ(std::min({ middle.X, middle.Y, 1.0 - middle.X, 1.0 - middle.Y }), 0.0);
  }
}

/// As where datasets that overlap were appended, and their equal points made one.
TEST(TriangleEdges, OfTrianglesOnOneSideAreTheBorderThoughTheseLieOnEachOther)
{
  const TriangulatedSource source = SixBySix();
  std::vector<Id> twice = source.Triangles;
  twice.insert(twice.end(), source.Triangles.begin(), source.Triangles.end());
  const Found found = EdgesOf(twice, source.Points.size());
  EXPECT_EQ(found.All.size(), 85u);
  EXPECT_EQ(found.Border, EdgesOf(source.Triangles, source.Points.size()).Border);
}

TEST(TriangleEdges, LeadUpFromTheirLowerEnd)
{
  Pulse pulse(NoMonitor());
  const std::vector<double> heights{ 2.0, 1.0, 1.0, 3.0 };
  const TriangleEdges edges({ 0, 1, 2, 0, 2, 3 }, 4, pulse, heights);
  std::set<Edge> found;
  for (std::size_t low = 0; low < 4; ++low)
  {
    for (std::size_t edge = edges.FirstAt(low); edge < edges.FirstAt(low + 1); ++edge)
    {
      found.emplace(static_cast<Id>(low), edges.HighEnd(edge));
      EXPECT_EQ(edges.IsBorder(edge), low != 2 || edges.HighEnd(edge) != 0);
    }
  }
  EXPECT_EQ(found, (std::set<Edge>{ { 1, 2 }, { 1, 0 }, { 2, 0 }, { 0, 3 }, { 2, 3 } }));
}

TEST(TriangleEdges, OfNoTrianglesAreNone)
{
  EXPECT_TRUE(EdgesOf({}, 5).All.empty());
}
