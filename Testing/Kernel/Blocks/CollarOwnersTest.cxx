// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "../Pieces/GridMesh.h"

#include "Blocks/WholeNumbers.h"

#include <gtest/gtest.h>

#include <vector> // for the owners

namespace biting
{

namespace
{

constexpr Id Side = 9;

// A grid whose upper end is open; around the rest are constraints.
Triangulation GridWithOpenEnd()
{
  const BitingMesh grid = GridMesh(Side);
  Triangulation mesh;
  mesh.Corners = grid.Corners;
  mesh.Neighbors = grid.Neighbors;
  mesh.Regions = grid.Regions;
  for (std::size_t slot = 0; slot < grid.Corners.size(); ++slot)
  {
    const Id start = grid.Corners[slot - slot % 3 + (slot + 1) % 3];
    const Id end = grid.Corners[slot - slot % 3 + (slot + 2) % 3];
    const bool isAtEnd = start / (Side + 1) == Side && end / (Side + 1) == Side;
    mesh.Constraints.push_back(grid.Neighbors[slot] == NoId && !isAtEnd ? 0 : NoId);
  }
  return mesh;
}

} // namespace

/// Triangles of different owners meet in the rows 3 and 6; the end is row 9.
TEST(CollarOwners, RingsAreThereUpToTheOpenEnd)
{
  const Triangulation mesh = GridWithOpenEnd();
  const std::size_t vertices = (Side + 1) * (Side + 1);
  const std::vector<Id> owners = OwnersByThirds(GridMesh(Side));
  for (const int rings : { 0, 1, 2, 3, 4 })
  {
    EXPECT_EQ(HasRingsAround(mesh, owners, vertices, rings), rings < 3) << rings;
  }
  EXPECT_TRUE(HasRingsAround(mesh, std::vector<Id>(owners.size(), 1), vertices, 5));
}

TEST(CollarOwners, TrianglesOfStripsAreOfTheFirstBlockAtThemOrElseOfOneNearby)
{
  const Triangulation mesh = GridWithOpenEnd();
  const std::size_t triangles = mesh.Regions.size();
  WholeNumbers numbers;
  numbers.VertexBlocks.assign((Side + 1) * (Side + 1), NoId);
  numbers.TriangleBlocks.assign(triangles, NoId);
  // The first row is of block 2; the vertices of the last of block 1, but for one of block 0.
  for (std::size_t triangle = 0; triangle < 2 * Side; ++triangle)
  {
    numbers.TriangleBlocks[triangle] = 2;
  }
  for (std::size_t column = 0; column <= Side; ++column)
  {
    numbers.VertexBlocks[Side * (Side + 1) + column] = column == 4 ? 0 : 1;
  }
  const std::vector<Id> owners = OwnersOfTriangles(mesh, numbers, { 5, 6, 7 });
  ASSERT_EQ(owners.size(), triangles);
  for (std::size_t triangle = 0; triangle < triangles; ++triangle)
  {
    const std::size_t row = triangle / (2 * Side);
    bool isOfFirst = false;
    for (std::size_t slot = 3 * triangle; slot < 3 * triangle + 3; ++slot)
    {
      isOfFirst = isOfFirst || mesh.Corners[slot] == Side * (Side + 1) + 4;
    }
    if (row == Side - 1)
    {
      EXPECT_EQ(owners[triangle], isOfFirst ? 5 : 6) << triangle;
    }
    else
    {
      EXPECT_TRUE(owners[triangle] >= 5 && owners[triangle] <= 7);
      EXPECT_TRUE(row > 2 || owners[triangle] == 7) << triangle;
    }
  }
}

} // namespace biting
