// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingGridMesh_h
#define BitingGridMesh_h

#include "BitingMesh.h"

#include <map>     // for edges
#include <utility> // for edges
#include <vector>  // for the arrays

namespace biting
{

/// So many squares along each side, two triangles each, row by row; numbered as a whole.
inline BitingMesh GridMesh(Id side)
{
  BitingMesh mesh;
  for (Id row = 0; row <= side; ++row)
  {
    for (Id column = 0; column <= side; ++column)
    {
      mesh.Points.push_back({ static_cast<double>(column), static_cast<double>(row) });
      mesh.Spacing.push_back(1.0 + row);
      mesh.BiteOrders.push_back(row * side + column);
      mesh.Kinds.push_back(VertexKind::Interior);
      mesh.OriginalPoints.push_back(NoId);
      mesh.Piece.PointIds.push_back(static_cast<std::int64_t>(mesh.Piece.PointIds.size()));
      const Id first = row * (side + 1) + column;
      if (row < side && column < side)
      {
        mesh.Corners.insert(mesh.Corners.end(),
          { first, first + 1, first + side + 2, first, first + side + 2, first + side + 1 });
        mesh.Regions.insert(mesh.Regions.end(), { 0, 0 });
      }
    }
  }
  std::map<std::pair<Id, Id>, Id> slots;
  const auto end = [&mesh](std::size_t slot, std::size_t turn)
  { return mesh.Corners[slot - slot % 3 + (slot + turn) % 3]; };
  for (std::size_t slot = 0; slot < mesh.Corners.size(); ++slot)
  {
    slots[{ end(slot, 1), end(slot, 2) }] = static_cast<Id>(slot);
  }
  for (std::size_t slot = 0; slot < mesh.Corners.size(); ++slot)
  {
    const auto across = slots.find({ end(slot, 2), end(slot, 1) });
    mesh.Neighbors.push_back(across == slots.end() ? Id{ NoId } : across->second / 3);
  }
  for (std::size_t triangle = 0; triangle < mesh.Regions.size(); ++triangle)
  {
    mesh.Piece.TriangleIds.push_back(static_cast<std::int64_t>(triangle));
  }
  return mesh;
}

/// By the thirds of their rows.
inline std::vector<Id> OwnersByThirds(const BitingMesh& mesh)
{
  std::vector<Id> owners;
  for (std::size_t triangle = 0; triangle < mesh.Regions.size(); ++triangle)
  {
    owners.push_back(static_cast<Id>(3 * triangle / mesh.Regions.size()));
  }
  return owners;
}

} // namespace biting

#endif
