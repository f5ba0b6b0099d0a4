// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "GridMesh.h"
#include "Pieces/PieceDealer.h"

#include <gtest/gtest.h>

#include <vector> // for bytes

namespace biting
{

namespace
{

CollarPart Part()
{
  CollarPart part;
  part.Mesh = GridMesh(4);
  part.Mesh.Piece.IsPart = true;
  part.Mesh.Piece.ForeignPoints.assign(part.Mesh.Points.size(), 1);
  part.Mesh.Piece.PointIds.back() = std::int64_t{ 1 } << 40;
  part.Constraints = { 3, NoId };
  part.Blocks.resize(2);
  part.Blocks[1].FirstVertex = std::int64_t{ 1 } << 41;
  part.Blocks[1].GoneVertices = { 5, 7 };
  part.Blocks[1].Regions = { 2 };
  part.GhostLevels = 2;
  part.CountsAsked = true;
  return part;
}

} // namespace

TEST(CollarPart, ComesOutOfItsBytesAsItWas)
{
  const std::vector<char> bytes = PackPart(Part());
  CollarPart part;
  ASSERT_TRUE(UnpackPart(bytes, part));
  EXPECT_EQ(PackPart(part), bytes);
  EXPECT_EQ(part.Mesh.Corners, Part().Mesh.Corners);
  EXPECT_EQ(part.Mesh.Piece.PointIds, Part().Mesh.Piece.PointIds);
  EXPECT_EQ(part.Blocks[1].FirstVertex, Part().Blocks[1].FirstVertex);
  EXPECT_EQ(part.Blocks[1].GoneVertices, Part().Blocks[1].GoneVertices);
  EXPECT_TRUE(part.CountsAsked);
}

TEST(CollarPart, IsNotMadeOfOtherBytes)
{
  std::vector<char> bytes = PackPart(Part());
  CollarPart part;
  EXPECT_FALSE(UnpackPart({}, part));
  bytes.push_back(0);
  EXPECT_FALSE(UnpackPart(bytes, part));
  bytes.resize(bytes.size() / 2);
  EXPECT_FALSE(UnpackPart(bytes, part));
}

} // namespace biting
