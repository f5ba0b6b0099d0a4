// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "StripMeshes.h"

#include "Base/DisjointSets.h"
#include "Blocks/StripParts.h"

#include <gtest/gtest.h>

#include <algorithm> // for includes, is_sorted
#include <set>       // for lists without an order

namespace biting
{

namespace
{

void ExpectNoVertexInCommon(const Triangulation& mesh, const std::vector<TriangleList>& parts)
{
  std::set<Id> all;
  for (const TriangleList& part : parts)
  {
    EXPECT_TRUE(std::is_sorted(part.begin(), part.end()));
    for (const Id vertex : VerticesOf(mesh, part))
    {
      EXPECT_TRUE(all.insert(vertex).second) << vertex;
    }
  }
}

} // namespace

TEST(DisjointSets, AreCalledByTheirFirstItems)
{
  DisjointSets sets(7);
  sets.Unite(5, 3);
  sets.Unite(6, 5);
  sets.Unite(2, 1);
  EXPECT_EQ(sets.SetOf(6), 3);
  EXPECT_EQ(sets.SetOf(3), 3);
  EXPECT_EQ(sets.SetOf(2), 1);
  EXPECT_EQ(sets.SetOf(4), 4);
  sets.Unite(1, 6);
  EXPECT_EQ(sets.SetOf(5), 1);
  EXPECT_EQ(sets.Size(), 7u);
}

TEST(StripParts, TrianglesAroundVerticesAreThoseWithinTheSteps)
{
  Pulse pulse(NoMonitor());
  for (const RawMesh& raw : AllRawMeshes())
  {
    const Triangulation& mesh = raw.Mesh.Triangles;
    const std::vector<Id> seeds{ 0, static_cast<Id>(raw.Mesh.Points.size()) - 1 };
    std::set<Id> expected;
    for (std::size_t slot = 0; slot < mesh.Corners.size(); ++slot)
    {
      if (mesh.Corners[slot] == seeds[0] || mesh.Corners[slot] == seeds[1])
      {
        expected.insert(static_cast<Id>(slot / 3));
      }
    }
    for (int step = 0; step < StripSteps; ++step)
    {
      for (const Id triangle : std::vector<Id>(expected.begin(), expected.end()))
      {
        const Id* neighbors = mesh.Neighbors.data() + 3 * static_cast<std::size_t>(triangle);
        expected.insert(neighbors, neighbors + 3);
      }
      expected.erase(NoId);
    }
    EXPECT_EQ(TrianglesAround(mesh, raw.Mesh.Points.size(), seeds, pulse),
      TriangleList(expected.begin(), expected.end()));
  }
}

TEST(StripParts, PartsHaveNoVertexInCommonAndAreNotTooLarge)
{
  Pulse pulse(NoMonitor());
  for (const RawMesh& raw : AllRawMeshes())
  {
    const Triangulation& mesh = raw.Mesh.Triangles;
    const std::vector<TriangleList> parts =
      DivideIntoParts(mesh, raw.Mesh.Points.size(), 90, pulse);
    std::size_t all = 0;
    for (const TriangleList& part : parts)
    {
      EXPECT_LE(part.size(), 90u);
      all += part.size();
    }
    EXPECT_GT(parts.size(), 1u);
    EXPECT_GT(2 * all, mesh.Regions.size());
    ExpectNoVertexInCommon(mesh, parts);
  }
}

TEST(StripParts, OneLargeEnoughIsAllThatIsConnected)
{
  Pulse pulse(NoMonitor());
  const RawMesh raw = Plate();
  const std::vector<TriangleList> parts =
    DivideIntoParts(raw.Mesh.Triangles, raw.Mesh.Points.size(), 1u << 20, pulse);
  ASSERT_EQ(parts.size(), 1u);
  EXPECT_EQ(parts[0].size(), raw.Mesh.Triangles.Regions.size());
}

TEST(StripParts, ConnectedPartsAreAllTrianglesAndHaveNoVertexInCommon)
{
  Pulse pulse(NoMonitor());
  for (const RawMesh& raw : AllRawMeshes())
  {
    const Triangulation& mesh = raw.Mesh.Triangles;
    TriangleList some;
    for (Id triangle = 0; triangle < mesh.NumberOfTriangles(); triangle += 5)
    {
      some.push_back(triangle);
    }
    const std::vector<TriangleList> parts =
      ConnectedParts(mesh, raw.Mesh.Points.size(), some, pulse);
    std::set<Id> all;
    for (const TriangleList& part : parts)
    {
      all.insert(part.begin(), part.end());
    }
    EXPECT_EQ(TriangleList(all.begin(), all.end()), some);
    EXPECT_GT(parts.size(), 1u);
    ExpectNoVertexInCommon(mesh, parts);
  }
}

} // namespace biting
