// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "../Pieces/GridBlock.h"

#include "Blocks/BlockCollar.h"

#include <gtest/gtest.h>

#include <algorithm> // for any_of, is_sorted, min
#include <vector>    // for steps

namespace biting
{

namespace
{

constexpr Id SideOfBlock = 12;

// Across edges from a triangle at the cut, found by going over all of them again and again.
std::vector<int> StepsFromCut(const GridBlock& block)
{
  const std::vector<Id>& corners = block.Grid.Corners;
  const std::vector<Id>& neighbors = block.Grid.Neighbors;
  std::vector<int> steps(block.Grid.Regions.size(), 1000);
  for (int round = 0; round < 100; ++round)
  {
    for (std::size_t slot = 0; slot < corners.size(); ++slot)
    {
      int& own = steps[slot / 3];
      own = block.IsShared(corners[slot]) ? 0 : own;
      const Id across = neighbors[slot];
      own = across == NoId ? own : std::min(own, steps[static_cast<std::size_t>(across)] + 1);
    }
  }
  return steps;
}

bool IsAtSegment(const GridBlock& block, std::size_t triangle)
{
  const Id* corners = block.Grid.Corners.data() + 3 * triangle;
  return std::any_of(
    corners, corners + 3, [&block](Id corner) { return block.IsOnSegment(corner); });
}

} // namespace

class BlockCollarSteps : public ::testing::TestWithParam<int>
{
};

TEST_P(BlockCollarSteps, HasWhatIsNearCutsOrAtSegmentsAndNothingElse)
{
  const GridBlock block(SideOfBlock);
  const BlockCollar collar = TakeCollar(block.Block, block.IsOnCut, block.Mesh, GetParam());
  const std::vector<int> steps = StepsFromCut(block);
  std::vector<Id> wanted;
  for (std::size_t triangle = 0; triangle < steps.size(); ++triangle)
  {
    if (steps[triangle] <= GetParam() || IsAtSegment(block, triangle))
    {
      wanted.push_back(static_cast<Id>(triangle));
    }
  }
  EXPECT_EQ(collar.Triangles, wanted);
  EXPECT_LT(wanted.size(), block.Grid.Regions.size());
}

TEST_P(BlockCollarSteps, IsAsInTheBlock)
{
  const GridBlock block(SideOfBlock);
  const BlockCollar collar = TakeCollar(block.Block, block.IsOnCut, block.Mesh, GetParam());
  const std::size_t shared = block.NumberOfShared();
  EXPECT_EQ(collar.NumberOfTriangles, static_cast<Id>(block.Grid.Regions.size()));
  EXPECT_EQ(collar.NumberOfVertices, static_cast<Id>(block.Grid.Points.size() - shared));
  EXPECT_TRUE(std::is_sorted(collar.Vertices.begin(), collar.Vertices.end()));
  ASSERT_EQ(collar.Mesh.Bites.Points.size(), shared + collar.Vertices.size());
  std::vector<Id> numbers(block.Grid.Regions.size(), NoId);
  for (std::size_t k = 0; k < collar.Triangles.size(); ++k)
  {
    numbers[static_cast<std::size_t>(collar.Triangles[k])] = static_cast<Id>(k);
  }
  for (std::size_t slot = 0; slot < collar.Mesh.Triangles.Corners.size(); ++slot)
  {
    const std::size_t own = 3 * static_cast<std::size_t>(collar.Triangles[slot / 3]) + slot % 3;
    const std::size_t corner = static_cast<std::size_t>(collar.Mesh.Triangles.Corners[slot]);
    const Id vertex = corner < shared ? static_cast<Id>(corner)
                                      : collar.Vertices[corner - shared] + static_cast<Id>(shared);
    const Id across = block.Grid.Neighbors[own];
    EXPECT_EQ(vertex, block.Grid.Corners[own]);
    EXPECT_EQ(
      collar.Mesh.Bites.Points[corner], block.Grid.Points[static_cast<std::size_t>(vertex)]);
    EXPECT_EQ(collar.Mesh.Triangles.Neighbors[slot],
      across == NoId ? NoId : numbers[static_cast<std::size_t>(across)]);
    EXPECT_EQ(collar.Mesh.Triangles.Constraints[slot], block.Mesh.Triangles.Constraints[own]);
  }
}

INSTANTIATE_TEST_SUITE_P(Steps, BlockCollarSteps, ::testing::Values(0, 1, 4, 9));

} // namespace biting
