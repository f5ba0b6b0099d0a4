// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "GridMesh.h"
#include "Pieces/PieceUnion.h"

#include <gtest/gtest.h>

#include <vector> // for values

namespace biting
{

/// The middle row is of the member, those beside it are ghosts of the levels 1 and 2.
TEST(TrimmedPiece, HasTheTrianglesUpToItsLevelAndTheirVertices)
{
  constexpr Id Side = 5;
  for (const int level : { 0, 1, 2 })
  {
    BitingMesh mesh = GridMesh(Side);
    mesh.Piece.ForeignPoints.assign(mesh.Points.size(), 0);
    for (std::size_t triangle = 0; triangle < mesh.Regions.size(); ++triangle)
    {
      const int row = static_cast<int>(triangle / 10);
      mesh.Piece.Levels.push_back(static_cast<std::uint8_t>(row < 2 ? 2 - row : row - 2));
      mesh.Quality.MinimumAngle.push_back(static_cast<double>(triangle));
    }
    mesh.Quality.RadiusEdgeRatio = mesh.Quality.AspectRatio = mesh.Quality.MinimumAngle;
    mesh.Quality.Conformity = mesh.Quality.NearestNeighborDistance = mesh.Spacing;
    const BitingMesh whole = mesh;
    TrimPiece(level, mesh);
    const std::size_t rows = static_cast<std::size_t>(1 + 2 * level);
    ASSERT_EQ(mesh.Regions.size(), 10 * rows);
    ASSERT_EQ(mesh.Points.size(), 6 * (rows + 1));
    for (std::size_t slot = 0; slot < mesh.Corners.size(); ++slot)
    {
      const std::size_t id = static_cast<std::size_t>(mesh.Piece.TriangleIds[slot / 3]);
      const std::size_t corner = static_cast<std::size_t>(mesh.Corners[slot]);
      EXPECT_EQ(mesh.Points[corner],
        whole.Points[static_cast<std::size_t>(whole.Corners[3 * id + slot % 3])]);
      EXPECT_EQ(mesh.Quality.AspectRatio[slot / 3], static_cast<double>(id));
      EXPECT_EQ(mesh.Quality.Conformity[corner],
        whole.Spacing[static_cast<std::size_t>(mesh.Piece.PointIds[corner])]);
    }
  }
}

} // namespace biting
