// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "VertexStar.h"

#include <algorithm> // for find, sort, unique, lower_bound
#include <utility>   // for swap

namespace biting
{

namespace
{

template <class Item>
void SortAndUnite(std::vector<Item>& items)
{
  std::sort(items.begin(), items.end());
  items.erase(std::unique(items.begin(), items.end()), items.end());
}

/// The corners of a cell of a triangulation of `vertices`, as these.
std::array<Id, 4> CornersAmong(const TetMesh& part, Id cell, const std::vector<Id>& vertices)
{
  std::array<Id, 4> corners{};
  for (std::size_t k = 0; k < 4; ++k)
  {
    const Id corner = part.Corners[TetMesh::Index(4 * cell) + k];
    corners[k] = corner == NoId ? NoId : vertices[TetMesh::Index(corner)];
  }
  return corners;
}

} // namespace

VertexStar::VertexStar(const TetMesh& mesh, Id vertex)
  : Vertex(vertex)
{
  std::vector<Id> pending{ mesh.VertexCells[TetMesh::Index(vertex)] };
  std::vector<Id>& cells = this->Cells;
  while (!pending.empty())
  {
    const Id cell = pending.back();
    pending.pop_back();
    const auto place = std::lower_bound(cells.begin(), cells.end(), cell);
    if (place != cells.end() && *place == cell)
    {
      continue;
    }
    cells.insert(place, cell);
    for (Id facet = 4 * cell; facet < 4 * cell + 4; ++facet)
    {
      const Id corner = mesh.Corners[TetMesh::Index(facet)];
      const Id twin = mesh.Twins[TetMesh::Index(facet)];
      if (corner != vertex)
      {
        pending.push_back(TetMesh::CellOf(twin));
        continue;
      }
      this->Walls.push_back(WallOf(
        { mesh.FacetCorner(facet, 0), mesh.FacetCorner(facet, 1), mesh.FacetCorner(facet, 2) },
        twin));
      const Id beyond = mesh.Corners[TetMesh::Index(twin)];
      if (beyond != NoId && mesh.IsTetrahedron(TetMesh::CellOf(twin)))
      {
        this->Beyond = beyond;
      }
    }
  }
  for (const Wall& wall : this->Walls)
  {
    this->Link.insert(this->Link.end(), wall.Corners.begin(), wall.Corners.end());
  }
  SortAndUnite(this->Link);
  if (this->Link.front() == NoId)
  {
    this->Link.erase(this->Link.begin());
  }
  std::sort(this->Walls.begin(), this->Walls.end(),
    [](const Wall& a, const Wall& b) { return a.Corners < b.Corners; });
}

VertexStar::Wall VertexStar::WallOf(std::array<Id, 3> corners, Id outside)
{
  bool isOdd = false;
  for (const std::size_t k : { 0u, 1u, 0u })
  {
    if (corners[k + 1] < corners[k])
    {
      std::swap(corners[k], corners[k + 1]);
      isOdd = !isOdd;
    }
  }
  return { corners, isOdd, outside };
}

const VertexStar::Wall* VertexStar::FindWall(const std::array<Id, 4>& corners, int k) const
{
  const auto corner = [&corners, k](int j)
  { return corners[TetMesh::Index(TetMesh::FacetCorners[k][j])]; };
  const Wall wall = WallOf({ corner(0), corner(1), corner(2) }, NoId);
  const auto place = std::lower_bound(this->Walls.begin(), this->Walls.end(), wall,
    [](const Wall& a, const Wall& b) { return a.Corners < b.Corners; });
  const bool isFound =
    place != this->Walls.end() && place->Corners == wall.Corners && place->IsOdd == wall.IsOdd;
  return isFound ? &*place : nullptr;
}

void VertexStar::Fill(TetMesh& mesh, const TetMesh& part, const std::vector<Id>& vertices) const
{
  // Cells of the part that have a wall, and from there all up to the walls.
  std::vector<Id> region;
  std::vector<Id> places(TetMesh::Index(part.NumberOfSlots()), NoId); // in the mesh
  std::size_t used = 0;
  const auto take = [this, &mesh, &region, &places, &used](Id cell)
  {
    Id& place = places[TetMesh::Index(cell)];
    if (place == NoId)
    {
      place = used < this->Cells.size() ? this->Cells[used] : mesh.NewCell();
      ++used;
      region.push_back(cell);
    }
  };
  for (Id cell = 0; cell < part.NumberOfSlots() && region.empty(); ++cell)
  {
    for (int k = 0; k < 4 && !part.IsFree(cell) && region.empty(); ++k)
    {
      if (this->FindWall(CornersAmong(part, cell, vertices), k))
      {
        take(cell);
      }
    }
  }
  std::size_t next = 0;
  while (next < region.size()) // it grows by what is taken
  {
    const Id cell = region[next++];
    const std::array<Id, 4> corners = CornersAmong(part, cell, vertices);
    const Id place = places[TetMesh::Index(cell)];
    mesh.SetCorners(place, corners[0], corners[1], corners[2], corners[3]);
    for (int k = 0; k < 4; ++k)
    {
      const Wall* const wall = this->FindWall(corners, k);
      const Id twin = part.Twins[TetMesh::Index(4 * cell + k)];
      if (!wall)
      {
        take(TetMesh::CellOf(twin));
      }
      mesh.Link(4 * place + k,
        wall ? wall->Outside : 4 * places[TetMesh::Index(TetMesh::CellOf(twin))] + (twin & 3));
      if (corners[TetMesh::Index(k)] != NoId)
      {
        mesh.VertexCells[TetMesh::Index(corners[TetMesh::Index(k)])] = place;
      }
    }
  }
  for (; used < this->Cells.size(); ++used)
  {
    mesh.FreeCell(this->Cells[used]);
  }
  mesh.VertexCells[TetMesh::Index(this->Vertex)] = NoId;
}

} // namespace biting
