// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "CavityCones.h"

#include <algorithm> // for sort, minmax

namespace biting
{

namespace
{

/// The facet of a cone at the edge of its wall from corner j on: SetCorners keeps the cyclic order,
/// so the facet lies opposite the corner that is neither of the two.
Id FacetAtEdge(const TetMesh& mesh, Id cone, Id opposite)
{
  const Id* c = &mesh.Corners[TetMesh::Index(4 * cone)];
  return 4 * cone + (c[1] == opposite ? 1 : c[2] == opposite ? 2 : 3);
}

} // namespace

void CavityCones::Fill(TetMesh& mesh, Id vertex, bool mayHide)
{
  this->NumberCorners(mesh);
  this->Hidden.clear();
  if (mayHide)
  {
    this->HideInside(mesh);
  }
  this->MakeCones(mesh, vertex);
  if (this->NumberOfLocals <= FewCorners)
  {
    this->LinkFew(mesh);
  }
  else
  {
    this->LinkMany(mesh);
  }
}

// The numbers stand in VertexCells, as -2, -3 and so on, until the cones are made.
void CavityCones::NumberCorners(TetMesh& mesh)
{
  this->NumberOfLocals = 1; // 0 is the vertex at infinity
  this->LocalCorners.resize(this->Walls.size());
  for (std::size_t i = 0; i < this->Walls.size(); ++i)
  {
    const auto& [a, b, c] = this->Walls[i].Corners;
    this->LocalCorners[i] = { this->NumberOf(mesh, a), this->NumberOf(mesh, b),
      this->NumberOf(mesh, c) };
  }
}

Id CavityCones::NumberOf(TetMesh& mesh, Id vertex)
{
  if (vertex == NoId)
  {
    return 0;
  }
  Id& place = mesh.VertexCells[TetMesh::Index(vertex)];
  if (place >= NoId)
  {
    place = -1 - this->NumberOfLocals++;
  }
  return -1 - place;
}

/// Corners of walls have numbers: others have a cell of the zone still.
void CavityCones::HideInside(TetMesh& mesh)
{
  for (const Id cell : this->Zone)
  {
    for (Id corner = 4 * cell; corner < 4 * cell + 4; ++corner)
    {
      const Id vertex = mesh.Corners[TetMesh::Index(corner)];
      if (vertex != NoId && mesh.VertexCells[TetMesh::Index(vertex)] > NoId)
      {
        mesh.VertexCells[TetMesh::Index(vertex)] = NoId;
        this->Hidden.push_back(vertex);
      }
    }
  }
  std::sort(this->Hidden.begin(), this->Hidden.end());
}

void CavityCones::MakeCones(TetMesh& mesh, Id vertex)
{
  this->Cones.resize(this->Walls.size());
  for (std::size_t i = 0; i < this->Walls.size(); ++i)
  {
    const Wall& wall = this->Walls[i];
    const Id cone = i < this->Zone.size() ? this->Zone[i] : mesh.NewCell();
    this->Cones[i] = cone;
    mesh.SetCorners(cone, vertex, wall.Corners[0], wall.Corners[1], wall.Corners[2]);
    mesh.Link(4 * cone, wall.Outside);
    for (const Id corner : wall.Corners)
    {
      if (corner != NoId)
      {
        mesh.VertexCells[TetMesh::Index(corner)] = cone;
      }
    }
  }
  mesh.VertexCells[TetMesh::Index(vertex)] = this->Cones.front();
  for (std::size_t i = this->Walls.size(); i < this->Zone.size(); ++i)
  {
    mesh.FreeCell(this->Zone[i]);
  }
}

// Each edge of the walls has a wall on either side, which runs along it in the other direction.
void CavityCones::LinkFew(TetMesh& mesh)
{
  const auto place = [](Id from, Id to) { return TetMesh::Index(FewCorners * from + to); };
  for (std::size_t i = 0; i < this->Walls.size(); ++i)
  {
    const auto& [a, b, c] = this->LocalCorners[i];
    // SetCorners turns the corners so that the vertex at infinity is the last one.
    const int turn = a == 0 ? 2 : b == 0 ? 1 : 0;
    const auto facet = [i, turn](int j)
    { return static_cast<std::uint16_t>(4 * i + 1 + static_cast<std::size_t>((j + turn) % 3)); };
    this->EdgeFacets[place(b, c)] = facet(0);
    this->EdgeFacets[place(c, a)] = facet(1);
    this->EdgeFacets[place(a, b)] = facet(2);
  }
  for (std::size_t i = 0; i < this->Walls.size(); ++i)
  {
    const auto& [a, b, c] = this->LocalCorners[i];
    const int turn = a == 0 ? 2 : b == 0 ? 1 : 0;
    const auto link = [this, &mesh, i, turn](int j, std::size_t edge)
    {
      const std::uint16_t twin = this->EdgeFacets[edge];
      mesh.Twins[TetMesh::Index(4 * this->Cones[i] + 1 + (j + turn) % 3)] =
        4 * this->Cones[twin >> 2u] + (twin & 3);
    };
    link(0, place(c, b));
    link(1, place(a, c));
    link(2, place(b, a));
  }
}

void CavityCones::LinkMany(TetMesh& mesh)
{
  this->SortedEdges.clear();
  for (std::size_t i = 0; i < this->Walls.size(); ++i)
  {
    const std::array<Id, 3>& corners = this->Walls[i].Corners;
    for (std::size_t j = 0; j < 3; ++j)
    {
      this->SortedEdges.push_back({ std::minmax(corners[(j + 1) % 3], corners[(j + 2) % 3]),
        FacetAtEdge(mesh, this->Cones[i], corners[j]) });
    }
  }
  std::sort(this->SortedEdges.begin(), this->SortedEdges.end());
  for (std::size_t k = 0; k + 1 < this->SortedEdges.size(); k += 2)
  {
    mesh.Link(this->SortedEdges[k].second, this->SortedEdges[k + 1].second);
  }
}

} // namespace biting
