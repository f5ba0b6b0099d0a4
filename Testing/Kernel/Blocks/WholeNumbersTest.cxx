// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Blocks/WholeNumbers.h"

#include <gtest/gtest.h>

#include <vector> // for the numbers

namespace biting
{

namespace
{

using Ids = std::vector<Id>;
using WholeIds = std::vector<WholeId>;

// Two blocks that share three vertices: of these and of their collars one each is gone, and one of
// the shared is used no more. Two vertices and three triangles are new.
struct Numbered
{
  Numbered()
    : Collars(2)
  {
    this->Collars[0].NumberOfVertices = 10;
    this->Collars[0].Vertices = { 2, 5, 9 };
    this->Collars[0].NumberOfTriangles = 20;
    this->Collars[0].Triangles = { 0, 7, 8 };
    this->Collars[1].NumberOfVertices = 4;
    this->Collars[1].Vertices = { 0, 3 };
    this->Collars[1].NumberOfTriangles = 5;
    this->Collars[1].Triangles = { 1, 2 };
    this->Joined.Places = { { 3, 0, 0, 0 }, { 6, 40, 3, 2 }, { 8, 50, 5, 3 } };
    this->Joined.FaceRegions = { 4, 6, 4 };
    this->Joined.Bites.Points.resize(8);
    this->Joined.Triangles.Corners = { 0, 2, 3, 2, 4, 3, 4, 5, 6, 0, 6, 7, 6, 5, 7, 0, 7, 2 };
    this->Joined.Triangles.Regions.resize(6);
    this->Change.GoneVertices = { 1, 4 };
    this->Change.Triangles = { 1, 3 };
  }

  std::vector<BlockCollar> Collars;
  JoinedMesh Joined;
  StripChange Change;
};

} // namespace

TEST(WholeNumbers, VerticesAreThoseThatStayInTheirOrderThenTheNewOnes)
{
  const Numbered input;
  const WholeNumbers numbers = NumberWhole(input.Collars, input.Joined, input.Change);
  EXPECT_EQ(numbers.Vertices, (WholeIds{ 0, NoId, 3, 9, 10, 13, 14, 15 }));
  EXPECT_EQ(numbers.VertexBlocks, (Ids{ NoId, NoId, 0, 0, 1, 1, NoId, NoId }));
  EXPECT_EQ(numbers.NumberOfVertices, 16);
  EXPECT_EQ(numbers.Blocks[0].FirstVertex, 1);
  EXPECT_EQ(numbers.Blocks[0].GoneVertices, Ids{ 5 });
  EXPECT_EQ(numbers.Blocks[1].FirstVertex, 10);
  EXPECT_TRUE(numbers.Blocks[1].GoneVertices.empty());
}

TEST(WholeNumbers, TrianglesOfStripsComeLast)
{
  const Numbered input;
  const WholeNumbers numbers = NumberWhole(input.Collars, input.Joined, input.Change);
  EXPECT_EQ(numbers.Triangles, (WholeIds{ 0, 7, 20, 23, 24, 25 }));
  EXPECT_EQ(numbers.TriangleBlocks, (Ids{ 0, 0, 1, NoId, NoId, NoId }));
  EXPECT_EQ(numbers.Blocks[0].FirstTriangle, 0);
  EXPECT_EQ(numbers.Blocks[0].TakenTriangles, Ids{ 7 });
  EXPECT_EQ(numbers.Blocks[1].FirstTriangle, 19);
  EXPECT_EQ(numbers.Blocks[1].TakenTriangles, Ids{ 1 });
}

TEST(WholeNumbers, OrdersAndRegionsOfBlocksGoOn)
{
  const Numbered input;
  const WholeNumbers numbers = NumberWhole(input.Collars, input.Joined, input.Change);
  EXPECT_EQ(numbers.Blocks[1].FirstOrder, 40);
  EXPECT_EQ(numbers.Blocks[0].Regions, (Ids{ 4, 6 }));
  EXPECT_EQ(numbers.Blocks[1].Regions, Ids{ 4 });
}

TEST(WholeNumbers, HaveSixtyFourBits)
{
  Numbered input;
  for (BlockCollar& collar : input.Collars)
  {
    collar.NumberOfVertices = 2000000000;
    collar.NumberOfTriangles = 2000000000;
  }
  const WholeNumbers numbers = NumberWhole(input.Collars, input.Joined, input.Change);
  EXPECT_EQ(numbers.NumberOfVertices, 4000000002);
  EXPECT_EQ(numbers.Triangles.back(), 4000000000);
}

} // namespace biting
