// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Quality/TriangleLinks.h"

#include "Base/TriangleSlots.h"
#include "TestMesh.h"

#include <gtest/gtest.h>

#include <algorithm> // for minmax, swap
#include <map>       // for edges

namespace
{

using biting::Dice;
using biting::Id;
using biting::LinkTriangles;
using biting::NoId;
using biting::TestMesh;
using biting::TriangleLinks;

Id CountPoints(const std::vector<Id>& corners)
{
  return corners.empty() ? 0 : *std::max_element(corners.begin(), corners.end()) + 1;
}

// How often each edge is counted by who counts it where its triangle's id is above the neighbor's.
std::map<std::pair<Id, Id>, int> CountEdges(
  const std::vector<Id>& corners, const TriangleLinks& links)
{
  std::map<std::pair<Id, Id>, int> counts;
  for (std::size_t slot = 0; slot < corners.size(); ++slot)
  {
    const Id a = corners[biting::NextSlot(slot)];
    const Id b = corners[biting::NextSlot(biting::NextSlot(slot))];
    counts[std::minmax(a, b)] += links.Neighbors[slot] < static_cast<Id>(slot / 3) ? 1 : 0;
  }
  return counts;
}

void ExpectEachEdgeOnce(const std::vector<Id>& corners)
{
  for (const auto& [ends, count] :
    CountEdges(corners, LinkTriangles(corners, CountPoints(corners))))
  {
    EXPECT_EQ(count, 1) << ends.first << ' ' << ends.second;
  }
}

TEST(LinkTriangles, FindsTheNeighborsOfAMesh)
{
  const TestMesh mesh = TestMesh::Random(300, 5);
  const TriangleLinks links = LinkTriangles(mesh.Corners, static_cast<Id>(mesh.Points.size()));
  EXPECT_EQ(links.Neighbors, mesh.Neighbors);
  EXPECT_TRUE(links.Crowded.empty());
}

TEST(LinkTriangles, DoesNotDependOnOrientation)
{
  TestMesh mesh = TestMesh::Random(100, 7);
  for (std::size_t slot = 0; slot < mesh.Corners.size(); slot += 9)
  {
    std::swap(mesh.Corners[slot + 1], mesh.Corners[slot + 2]);
    std::swap(mesh.Neighbors[slot + 1], mesh.Neighbors[slot + 2]);
  }
  EXPECT_EQ(LinkTriangles(mesh.Corners, 100).Neighbors, mesh.Neighbors);
}

TEST(LinkTriangles, LetsEachEdgeBeCountedOnceWhateverTheTriangles)
{
  ExpectEachEdgeOnce({ 0, 1, 2, 0, 1, 3, 1, 0, 4 });
  ExpectEachEdgeOnce({ 0, 1, 2, 0, 1, 2, 2, 1, 0, 0, 1, 2 });
  ExpectEachEdgeOnce({ 0, 0, 1, 0, 1, 2 });
  ExpectEachEdgeOnce({ 0, 1, 2, 1, 1, 0 });
  ExpectEachEdgeOnce({ 0, 0, 0 });
  Dice dice(3);
  for (int round = 0; round < 200; ++round)
  {
    std::vector<Id> corners;
    while (corners.size() < 24)
    {
      corners.push_back(static_cast<Id>(dice.Roll() % 6));
    }
    ExpectEachEdgeOnce(corners);
  }
}

TEST(LinkTriangles, NamesATriangleOfEachCrowdedEdge)
{
  EXPECT_EQ(
    LinkTriangles({ 4, 2, 3, 0, 1, 2, 0, 1, 3, 1, 0, 4 }, 5).Crowded, (std::vector<Id>{ 1 }));
}

TEST(LinkTriangles, FindsNothingInNothing)
{
  EXPECT_TRUE(LinkTriangles({}, 0).Neighbors.empty());
}

} // namespace

TEST(TriangleSlots, LeadAcrossAnEdgeAndBack)
{
  const TestMesh mesh = TestMesh::Random(200, 3);
  for (std::size_t slot = 0; slot < mesh.Corners.size(); ++slot)
  {
    EXPECT_EQ(biting::NextSlotOf(biting::NextSlotOf(slot)), biting::PreviousSlotOf(slot));
    EXPECT_EQ(biting::NextSlotOf(biting::PreviousSlotOf(slot)), slot);
    if (mesh.Neighbors[slot] != NoId)
    {
      const std::size_t across = biting::SlotAcross(mesh.Corners, slot, mesh.Neighbors[slot]);
      EXPECT_EQ(across / 3, static_cast<std::size_t>(mesh.Neighbors[slot]));
      EXPECT_EQ(static_cast<std::size_t>(mesh.Neighbors[across]), slot / 3);
      EXPECT_EQ(biting::SlotAcross(mesh.Corners, across, mesh.Neighbors[across]), slot);
    }
  }
}
