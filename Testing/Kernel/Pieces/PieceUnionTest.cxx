// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Pieces/PieceUnion.h"
#include "GridBlock.h"

#include <gtest/gtest.h>

#include <utility> // for move
#include <vector>  // for the maps

namespace biting
{

namespace
{

constexpr Id Side = 12;

KeptBlocks Keep(const GridBlock& block, int steps)
{
  KeptBlocks kept;
  kept.Parts.Blocks.push_back(block.Block);
  kept.Meshes.push_back(block.Mesh);
  kept.Collars.push_back(TakeCollar(block.Block, block.IsOnCut, block.Mesh, steps));
  return kept;
}

// The collar as its member gets it back where it has not changed.
CollarPart PartOf(const GridBlock& block, const BlockCollar& collar)
{
  CollarPart part;
  BitingMesh& mesh = part.Mesh;
  const auto shared = static_cast<Id>(block.NumberOfShared());
  for (Id vertex = 0; vertex < shared; ++vertex)
  {
    mesh.Piece.PointIds.push_back(vertex);
  }
  for (const Id vertex : collar.Vertices)
  {
    mesh.Piece.PointIds.push_back(shared + vertex);
  }
  mesh.Piece.TriangleIds.assign(collar.Triangles.begin(), collar.Triangles.end());
  mesh.Points = collar.Mesh.Bites.Points;
  mesh.Spacing = collar.Mesh.Bites.Spacings;
  mesh.BiteOrders = collar.Mesh.Bites.BiteOrders;
  mesh.Kinds.assign(mesh.Points.size(), VertexKind::Interior);
  mesh.OriginalPoints.assign(mesh.Points.size(), NoId);
  mesh.Piece.ForeignPoints.assign(mesh.Points.size(), 0);
  mesh.Corners = collar.Mesh.Triangles.Corners;
  mesh.Neighbors = collar.Mesh.Triangles.Neighbors;
  mesh.Regions = collar.Mesh.Triangles.Regions;
  mesh.Piece.Levels.assign(mesh.Regions.size(), 0);
  part.Constraints = collar.Mesh.Triangles.Constraints;
  part.Blocks.emplace_back();
  part.Blocks[0].FirstVertex = shared;
  part.Blocks[0].Regions = { 0 };
  return part;
}

// Without its last triangle that is across from the core.
void TakeOneAway(CollarPart& part)
{
  BitingMesh& mesh = part.Mesh;
  std::size_t slot = mesh.Corners.size() - 1;
  while (mesh.Neighbors[slot] != NoId || part.Constraints[slot] != NoId)
  {
    --slot;
  }
  const Id gone = static_cast<Id>(slot / 3);
  const auto first = static_cast<std::ptrdiff_t>(3 * (slot / 3));
  for (std::vector<Id>* values : { &mesh.Corners, &mesh.Neighbors, &part.Constraints })
  {
    values->erase(values->begin() + first, values->begin() + first + 3);
  }
  mesh.Regions.pop_back();
  mesh.Piece.Levels.pop_back();
  mesh.Piece.TriangleIds.erase(mesh.Piece.TriangleIds.begin() + gone);
  for (Id& across : mesh.Neighbors)
  {
    across = across == gone ? NoId : across - (across > gone ? 1 : 0);
  }
}

} // namespace

class PieceUnionSteps : public ::testing::TestWithParam<int>
{
};

TEST_P(PieceUnionSteps, CoreAndCollarAreTheBlock)
{
  const GridBlock block(Side);
  KeptBlocks kept = Keep(block, GetParam());
  CollarPart part = PartOf(block, kept.Collars[0]);
  ASSERT_LT(part.Mesh.Points.size(), block.Grid.Points.size());
  Pulse pulse(NoMonitor());
  const UnitedPiece piece = UnitePiece(kept, { 0 }, std::move(part), pulse);
  EXPECT_TRUE(piece.IsSound);
  EXPECT_EQ(piece.Mesh.Points, block.Grid.Points);
  EXPECT_EQ(piece.Mesh.Spacing, block.Grid.Spacing);
  EXPECT_EQ(piece.Mesh.BiteOrders, block.Grid.BiteOrders);
  EXPECT_EQ(piece.Mesh.Corners, block.Grid.Corners);
  EXPECT_EQ(piece.Mesh.Neighbors, block.Grid.Neighbors);
  EXPECT_EQ(piece.Mesh.Piece.PointIds, block.Grid.Piece.PointIds);
  EXPECT_EQ(piece.Mesh.Piece.TriangleIds, block.Grid.Piece.TriangleIds);
  EXPECT_EQ(piece.Constraints, block.Mesh.Triangles.Constraints);
  EXPECT_TRUE(kept.Meshes[0].Bites.Points.empty());
}

TEST_P(PieceUnionSteps, ACoreThatDoesNotFitIsNotSound)
{
  const GridBlock block(Side);
  KeptBlocks kept = Keep(block, GetParam());
  CollarPart part = PartOf(block, kept.Collars[0]);
  TakeOneAway(part);
  Pulse pulse(NoMonitor());
  EXPECT_FALSE(UnitePiece(kept, { 0 }, std::move(part), pulse).IsSound);
}

INSTANTIATE_TEST_SUITE_P(Steps, PieceUnionSteps, ::testing::Values(0, 3, 8));

/// What is gone, and what other blocks have before it, moves its numbers.
TEST(PieceUnion, NumbersOfTheWholeAreThoseOfTheBlockMovedOn)
{
  const GridBlock block(Side);
  KeptBlocks kept = Keep(block, 3);
  CollarPart part = PartOf(block, kept.Collars[0]);
  constexpr std::int64_t Before = 3000000000;
  part.Blocks[0].FirstVertex += Before;
  part.Blocks[0].FirstTriangle += Before;
  for (std::vector<std::int64_t>* ids : { &part.Mesh.Piece.PointIds, &part.Mesh.Piece.TriangleIds })
  {
    for (std::int64_t& id : *ids)
    {
      id += Before;
    }
  }
  Pulse pulse(NoMonitor());
  const UnitedPiece piece = UnitePiece(kept, { 0 }, std::move(part), pulse);
  for (std::size_t k = 0; k < block.Grid.Points.size(); ++k)
  {
    EXPECT_EQ(piece.Mesh.Piece.PointIds.at(k), Before + static_cast<std::int64_t>(k));
  }
  EXPECT_EQ(piece.Mesh.Corners, block.Grid.Corners);
}

} // namespace biting
