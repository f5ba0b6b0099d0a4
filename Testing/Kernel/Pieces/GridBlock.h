// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingGridBlock_h
#define BitingGridBlock_h

#include "Blocks/BlockCollar.h"
#include "GridMesh.h"

#include <cstddef> // for counts
#include <cstdint> // for flags
#include <vector>  // for the maps

namespace biting
{

/// A grid (GridMesh.h) as a block: its lowest row of vertices is on a cut, the rest of its boundary
/// on one segment.
struct GridBlock
{
  explicit GridBlock(Id side)
    : Side(side)
    , Grid(GridMesh(side))
    , IsOnCut(static_cast<std::size_t>(side) + 1, 1)
  {
    for (Id vertex = 0; vertex <= side; ++vertex)
    {
      this->Block.Vertices.push_back(vertex);
    }
    this->Mesh.Bites.Points = this->Grid.Points;
    this->Mesh.Bites.Spacings = this->Grid.Spacing;
    this->Mesh.Bites.BiteOrders = this->Grid.BiteOrders;
    for (std::size_t vertex = 0; vertex < this->Grid.Points.size(); ++vertex)
    {
      this->Mesh.Bites.Segments.push_back(this->IsOnSegment(static_cast<Id>(vertex)) ? 0 : NoId);
    }
    this->Mesh.Triangles.Corners = this->Grid.Corners;
    this->Mesh.Triangles.Neighbors = this->Grid.Neighbors;
    this->Mesh.Triangles.Regions = this->Grid.Regions;
    for (const Id across : this->Grid.Neighbors)
    {
      this->Mesh.Triangles.Constraints.push_back(across == NoId ? 0 : NoId);
    }
  }

  std::size_t NumberOfShared() const { return this->Block.Vertices.size(); }
  bool IsShared(Id vertex) const { return vertex <= this->Side; }
  bool IsOnSegment(Id vertex) const
  {
    const Id column = vertex % (this->Side + 1);
    const bool isAtRim =
      column == 0 || column == this->Side || vertex / (this->Side + 1) == this->Side;
    return isAtRim && !this->IsShared(vertex);
  }

  Id Side;
  BitingMesh Grid;
  BlockDomain Block;
  BlockMesh Mesh;
  std::vector<std::uint8_t> IsOnCut;
};

} // namespace biting

#endif
