// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Pieces/PieceDealer.h"
#include "GridMesh.h"

#include <gtest/gtest.h>

#include <algorithm> // for is_sorted, max_element
#include <set>       // for vertices
#include <vector>    // for counts

namespace biting
{

namespace
{

constexpr Id Members = 3;

std::vector<CollarPart> Deal(const BitingMesh& mesh, int levels)
{
  const std::vector<Id> owners = OwnersByThirds(mesh);
  const std::vector<Id> constraints(mesh.Corners.size(), NoId);
  const DealtMesh dealt{ mesh, constraints, owners, Members };
  PieceDealer dealer(dealt, levels);
  std::vector<CollarPart> parts;
  for (Id member = 0; member < Members; ++member)
  {
    parts.push_back(dealer.Make(member));
  }
  return parts;
}

} // namespace

class PieceDealerLevels : public ::testing::TestWithParam<int>
{
};

TEST_P(PieceDealerLevels, EachVertexAndTriangleIsOwnedOnceAndAsInTheMesh)
{
  const BitingMesh mesh = GridMesh(9);
  std::vector<int> vertices(mesh.Points.size(), 0);
  std::vector<int> triangles(mesh.Regions.size(), 0);
  for (const CollarPart& part : Deal(mesh, GetParam()))
  {
    const MeshPiece& piece = part.Mesh.Piece;
    for (std::size_t k = 0; k < piece.PointIds.size(); ++k)
    {
      const std::size_t id = static_cast<std::size_t>(piece.PointIds[k]);
      EXPECT_EQ(part.Mesh.Points[k], mesh.Points[id]);
      EXPECT_EQ(part.Mesh.Spacing[k], mesh.Spacing[id]);
      vertices[id] += piece.ForeignPoints[k] == 0 ? 1 : 0;
    }
    for (std::size_t slot = 0; slot < part.Mesh.Corners.size(); ++slot)
    {
      const std::size_t whole = static_cast<std::size_t>(3 * piece.TriangleIds[slot / 3]);
      const std::size_t corner = static_cast<std::size_t>(part.Mesh.Corners[slot]);
      EXPECT_EQ(piece.PointIds[corner], mesh.Corners[whole + slot % 3]);
      const Id across = part.Mesh.Neighbors[slot];
      if (across != NoId)
      {
        EXPECT_EQ(
          piece.TriangleIds[static_cast<std::size_t>(across)], mesh.Neighbors[whole + slot % 3]);
      }
    }
    for (std::size_t k = 0; k < piece.TriangleIds.size(); ++k)
    {
      triangles[static_cast<std::size_t>(piece.TriangleIds[k])] += piece.Levels[k] == 0 ? 1 : 0;
    }
    EXPECT_TRUE(std::is_sorted(piece.PointIds.begin(), piece.PointIds.end()));
    EXPECT_TRUE(std::is_sorted(piece.TriangleIds.begin(), piece.TriangleIds.end()));
  }
  EXPECT_EQ(vertices, std::vector<int>(vertices.size(), 1));
  EXPECT_EQ(triangles, std::vector<int>(triangles.size(), 1));
}

TEST_P(PieceDealerLevels, GhostsAreAllTrianglesAroundThoseOfTheLevelBefore)
{
  const BitingMesh mesh = GridMesh(9);
  for (const CollarPart& part : Deal(mesh, GetParam()))
  {
    std::vector<int> levels(mesh.Regions.size(), -1);
    for (std::size_t k = 0; k < part.Mesh.Regions.size(); ++k)
    {
      levels[static_cast<std::size_t>(part.Mesh.Piece.TriangleIds[k])] = part.Mesh.Piece.Levels[k];
    }
    std::set<Id> reached;
    for (int level = 0; level <= GetParam(); ++level)
    {
      const std::set<Id> before = reached;
      for (std::size_t slot = 0; slot < mesh.Corners.size(); ++slot)
      {
        if (levels[slot / 3] == level)
        {
          reached.insert(mesh.Corners[slot]);
        }
      }
      for (std::size_t slot = 0; slot < mesh.Corners.size() && level > 0; ++slot)
      {
        const bool isNear = before.count(mesh.Corners[slot]) > 0;
        EXPECT_TRUE(!isNear || (levels[slot / 3] >= 0 && levels[slot / 3] <= level));
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Levels, PieceDealerLevels, ::testing::Values(0, 1, 2));

TEST(PieceDealer, LevelsThatHaveNoNumberAreInThePart)
{
  const BitingMesh mesh = GridMesh(400);
  const std::vector<Id> owners = OwnersByThirds(mesh);
  const std::vector<Id> constraints(mesh.Corners.size(), NoId);
  const DealtMesh dealt{ mesh, constraints, owners, Members };
  PieceDealer dealer(dealt, 400);
  const MeshPiece piece = dealer.Make(0).Mesh.Piece;
  EXPECT_EQ(piece.TriangleIds, mesh.Piece.TriangleIds);
  EXPECT_EQ(*std::max_element(piece.Levels.begin(), piece.Levels.end()), 254);
}

TEST(PieceDealer, ASharedVertexBelongsToTheFirstMemberWithATriangleAtIt)
{
  const BitingMesh mesh = GridMesh(3); // a member a row
  const std::vector<CollarPart> parts = Deal(mesh, 0);
  for (std::size_t k = 0; k < 4; ++k)
  {
    EXPECT_EQ(parts[0].Mesh.Piece.ForeignPoints[4 + k], 0);
    EXPECT_EQ(parts[1].Mesh.Piece.ForeignPoints[k], 1);
    EXPECT_EQ(parts[1].Mesh.Piece.ForeignPoints[4 + k], 0);
  }
}

} // namespace biting
