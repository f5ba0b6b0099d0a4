// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "TrimmedPiece.h"

#include <cstddef> // for slots
#include <vector>  // for numbers

namespace biting
{

namespace
{

template <typename Value>
void Keep(const std::vector<Id>& kept, std::size_t size, std::vector<Value>& values)
{
  for (std::size_t k = 0; k < kept.size(); ++k)
  {
    for (std::size_t i = 0; i < size; ++i)
    {
      values[size * k + i] = values[size * static_cast<std::size_t>(kept[k]) + i];
    }
  }
  values.resize(size * kept.size());
}

void KeepTriangles(const std::vector<Id>& kept, BitingMesh& mesh)
{
  Keep(kept, 3, mesh.Corners);
  mesh.Neighbors = std::vector<Id>();
  Keep(kept, 1, mesh.Regions);
  Keep(kept, 1, mesh.Piece.TriangleIds);
  Keep(kept, 1, mesh.Piece.Levels);
  Keep(kept, 1, mesh.Quality.MinimumAngle);
  Keep(kept, 1, mesh.Quality.RadiusEdgeRatio);
  Keep(kept, 1, mesh.Quality.AspectRatio);
}

void KeepVertices(const std::vector<Id>& kept, BitingMesh& mesh)
{
  Keep(kept, 1, mesh.Points);
  Keep(kept, 1, mesh.Spacing);
  Keep(kept, 1, mesh.BiteOrders);
  Keep(kept, 1, mesh.Kinds);
  Keep(kept, 1, mesh.OriginalPoints);
  Keep(kept, 1, mesh.Piece.PointIds);
  Keep(kept, 1, mesh.Piece.ForeignPoints);
  Keep(kept, 1, mesh.Quality.NearestNeighborDistance);
  Keep(kept, 1, mesh.Quality.Conformity);
}

} // namespace

void TrimPiece(int ghostLevels, BitingMesh& mesh)
{
  std::vector<Id> triangles;
  std::vector<Id> numbers(mesh.Points.size(), NoId);
  for (std::size_t triangle = 0; triangle < mesh.Regions.size(); ++triangle)
  {
    if (mesh.Piece.Levels[triangle] <= ghostLevels)
    {
      triangles.push_back(static_cast<Id>(triangle));
      for (std::size_t slot = 3 * triangle; slot < 3 * triangle + 3; ++slot)
      {
        numbers[mesh.Corners[slot]] = 0;
      }
    }
  }
  std::vector<Id> vertices;
  for (std::size_t vertex = 0; vertex < numbers.size(); ++vertex)
  {
    if (numbers[vertex] != NoId)
    {
      numbers[vertex] = static_cast<Id>(vertices.size());
      vertices.push_back(static_cast<Id>(vertex));
    }
  }
  KeepTriangles(triangles, mesh);
  for (Id& corner : mesh.Corners)
  {
    corner = numbers[corner];
  }
  KeepVertices(vertices, mesh);
}

} // namespace biting
