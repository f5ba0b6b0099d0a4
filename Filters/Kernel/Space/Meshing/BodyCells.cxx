// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "BodyCells.h"

#include "../../Base/DisjointSets.h"
#include "FacetTable.h"

#include <array>   // for corners
#include <cstdint> // for marks

namespace biting
{

namespace
{

class CellLabelling
{
public:
  CellLabelling(const SpaceTriangulation& triangulation, const std::vector<Id>& facets,
    const std::vector<TriangleSides>& sides, std::size_t boundaryPoints)
    : Mesh(triangulation.Mesh)
    , Order(triangulation.Order)
    , Sides(sides)
    , BoundaryPoints(static_cast<Id>(boundaryPoints))
    , Facets(facets, boundaryPoints)
    , Seen(sides.size(), 0)
    , Parts(At(this->Mesh.NumberOfSlots()))
    , Labels(At(this->Mesh.NumberOfSlots()), NoId)
  {
  }

  BodyCells Run(Pulse& pulse)
  {
    BodyCells result;
    this->JoinCells(pulse);
    for (const Wall& wall : this->Walls)
    {
      Id& label = this->Labels[At(this->Parts.SetOf(wall.Cell))];
      const Id own = this->Sides[At(wall.Facet)][wall.Place];
      label = label == NoId ? own : label;
      this->Seen[At(wall.Facet)] |= static_cast<std::uint8_t>(1u << wall.Place);
      if (own != label)
      {
        result.Lost.push_back(wall.Facet);
      }
    }
    // Where facets are missing parts of space run into each other: these are what is wrong.
    constexpr std::uint8_t Both = 3;
    std::vector<Id> missing;
    for (std::size_t facet = 0; facet < this->Seen.size(); ++facet)
    {
      if (this->Seen[facet] != Both)
      {
        missing.push_back(static_cast<Id>(facet));
      }
    }
    result.Lost = missing.empty() ? result.Lost : missing;
    this->TakeCells(result);
    return result;
  }

private:
  /// A facet of the boundary as a cell has it.
  struct Wall
  {
    Id Cell;
    Id Facet;
    std::size_t Place; ///< 0: the cell is behind it, 1: in front
  };

  void JoinCells(Pulse& pulse)
  {
    for (Id side = 0; side < 4 * this->Mesh.NumberOfSlots() && pulse.Beat(1); ++side)
    {
      const Id cell = TetMesh::CellOf(side);
      if (this->Mesh.IsFree(cell))
      {
        continue;
      }
      const std::array<Id, 3> corners = this->CornersOf(side);
      const Id facet = this->FacetOf(corners);
      if (facet == NoId)
      {
        this->Parts.Unite(cell, TetMesh::CellOf(this->Mesh.Twins[At(side)]));
      }
      else
      {
        // The corners of a side are oriented away from its cell.
        this->Walls.push_back(
          { cell, facet, this->Facets.CornersOf(facet) == corners ? std::size_t{ 0 } : 1 });
      }
    }
  }

  std::array<Id, 3> CornersOf(Id side) const
  {
    std::array<Id, 3> points{};
    for (int k = 0; k < 3; ++k)
    {
      const Id vertex = this->Mesh.FacetCorner(side, k);
      points[At(k)] = vertex == NoId ? NoId : this->Order[At(vertex)];
    }
    return LowestFirst(points[0], points[1], points[2]);
  }

  Id FacetOf(const std::array<Id, 3>& corners) const
  {
    const bool isOfBoundary = corners[0] != NoId && corners[0] < this->BoundaryPoints &&
      corners[1] < this->BoundaryPoints && corners[2] < this->BoundaryPoints;
    return isOfBoundary ? this->Facets.Find(corners) : NoId;
  }

  void TakeCells(BodyCells& result)
  {
    const auto labelOf = [this](Id cell)
    { return this->Mesh.IsTetrahedron(cell) ? this->Labels[At(this->Parts.SetOf(cell))] : 0; };
    std::size_t count = 0;
    for (Id cell = 0; cell < this->Mesh.NumberOfSlots(); ++cell)
    {
      count += labelOf(cell) > 0 ? 1 : 0;
    }
    result.Labels.reserve(count);
    result.Corners.reserve(4 * count);
    for (Id cell = 0; cell < this->Mesh.NumberOfSlots(); ++cell)
    {
      const Id label = labelOf(cell);
      for (Id corner = 4 * cell; corner < 4 * cell + 4 && label > 0; ++corner)
      {
        result.Corners.push_back(this->Order[At(this->Mesh.Corners[At(corner)])]);
      }
      if (label > 0)
      {
        result.Labels.push_back(label);
      }
    }
  }

  const TetMesh& Mesh;
  const std::vector<Id>& Order;
  const std::vector<TriangleSides>& Sides;
  Id BoundaryPoints;
  FacetTable Facets;
  std::vector<std::uint8_t> Seen; ///< of facets: from behind 1, from the front 2
  std::vector<Wall> Walls;
  DisjointSets Parts;     ///< of cells that no wall divides
  std::vector<Id> Labels; ///< of parts
};

} // namespace

BodyCells LabelCells(const SpaceTriangulation& triangulation, const std::vector<Id>& facets,
  const std::vector<TriangleSides>& sides, std::size_t boundaryPoints, Pulse& pulse)
{
  return CellLabelling(triangulation, facets, sides, boundaryPoints).Run(pulse);
}

} // namespace biting
