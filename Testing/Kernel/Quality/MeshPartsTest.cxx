// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Quality/MeshParts.h"
#include "Base/TriangleSlots.h"
#include "TestMesh.h"

#include "Base/Monitor.h"

#include <gtest/gtest.h>

namespace biting
{

namespace
{

/// Lines 0 .. n.
std::vector<double> Lines(int n)
{
  std::vector<double> lines;
  for (int k = 0; k <= n; ++k)
  {
    lines.push_back(k);
  }
  return lines;
}

std::vector<std::size_t> BoundaryOf(const TestMesh& mesh)
{
  std::vector<std::size_t> slots;
  for (std::size_t slot = 0; slot < mesh.Neighbors.size(); ++slot)
  {
    if (mesh.Neighbors[slot] == NoId)
    {
      slots.push_back(slot);
    }
  }
  return slots;
}

void Expect(const TestMesh& mesh, std::int64_t components, std::int64_t loops)
{
  SilentMonitor monitor;
  Pulse pulse(monitor);
  EXPECT_EQ(CountComponents(mesh.Neighbors, pulse), components);
  EXPECT_EQ(CountBoundaryLoops(mesh.Corners, mesh.Neighbors, BoundaryOf(mesh), pulse), loops);
}

} // namespace

TEST(TriangleSlots, LeadAcrossAnEdgeAndBack)
{
  const TestMesh mesh = TestMesh::Random(200, 3);
  for (std::size_t slot = 0; slot < mesh.Corners.size(); ++slot)
  {
    EXPECT_EQ(NextSlotOf(NextSlotOf(slot)), PreviousSlotOf(slot));
    EXPECT_EQ(NextSlotOf(PreviousSlotOf(slot)), slot);
    if (mesh.Neighbors[slot] != NoId)
    {
      const std::size_t across = SlotAcross(mesh.Corners, slot, mesh.Neighbors[slot]);
      EXPECT_EQ(across / 3, static_cast<std::size_t>(mesh.Neighbors[slot]));
      EXPECT_EQ(static_cast<std::size_t>(mesh.Neighbors[across]), slot / 3);
      EXPECT_EQ(SlotAcross(mesh.Corners, across, mesh.Neighbors[across]), slot);
    }
  }
}

TEST(MeshParts, AreCounted)
{
  const auto all = [](std::size_t, std::size_t) { return true; };
  Expect(TestMesh::Grid(Lines(6), Lines(5), all), 1, 1);
  const auto ring = [](std::size_t column, std::size_t row)
  { return column % 6 != 2 || row % 5 != 2; };
  Expect(TestMesh::Grid(Lines(6), Lines(5), ring), 1, 2);
  const auto stripes = [](std::size_t column, std::size_t) { return column % 2 == 0; };
  Expect(TestMesh::Grid(Lines(9), Lines(4), stripes), 5, 5);
}

// Squares of a board touch at corners: each is a part with a loop of its own.
TEST(MeshParts, ThatTouchAtAVertexAreSeveral)
{
  const auto board = [](std::size_t column, std::size_t row) { return (column + row) % 2 == 0; };
  Expect(TestMesh::Grid(Lines(4), Lines(4), board), 8, 8);
}

TEST(MeshParts, AreTheSameForMeshesOfSeveralTasks)
{
  const auto holes = [](std::size_t column, std::size_t row)
  { return column % 10 != 5 || row % 10 != 5; };
  Expect(TestMesh::Grid(Lines(200), Lines(200), holes), 1, 401);
}

} // namespace biting
