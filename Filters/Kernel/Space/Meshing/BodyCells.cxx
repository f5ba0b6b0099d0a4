// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "BodyCells.h"

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
    , Labels(At(this->Mesh.NumberOfSlots()), NoId)
  {
  }

  BodyCells Run(Pulse& pulse)
  {
    BodyCells result;
    for (Id cell = 0; cell < this->Mesh.NumberOfSlots() && pulse.Beat(); ++cell)
    {
      if (!this->Mesh.IsFree(cell) && this->Labels[At(cell)] == NoId)
      {
        this->Fill(cell, result.Lost, pulse);
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
  /// The cells that hang together with `first`, and facets beside them that say another label.
  void Fill(Id first, std::vector<Id>& lost, Pulse& pulse)
  {
    Id label = NoId;
    this->Part.assign(1, first);
    this->Labels[At(first)] = 0;
    std::size_t next = 0;
    while (next < this->Part.size() && pulse.Beat()) // Part grows
    {
      const Id cell = this->Part[next++];
      for (Id side = 4 * cell; side < 4 * cell + 4; ++side)
      {
        const std::array<Id, 3> corners = this->CornersOf(side);
        const Id facet = this->FacetOf(corners);
        const Id other = TetMesh::CellOf(this->Mesh.Twins[At(side)]);
        if (facet == NoId)
        {
          if (this->Labels[At(other)] == NoId)
          {
            this->Labels[At(other)] = 0;
            this->Part.push_back(other);
          }
          continue;
        }
        // The corners of a side are oriented away from its cell.
        const std::size_t place = this->Facets.CornersOf(facet) == corners ? 0 : 1;
        this->Seen[At(facet)] |= static_cast<std::uint8_t>(1u << place);
        const Id own = this->Sides[At(facet)][place];
        label = label == NoId ? own : label;
        if (own != label)
        {
          lost.push_back(facet);
        }
      }
    }
    for (const Id cell : this->Part)
    {
      this->Labels[At(cell)] = label == NoId ? 0 : label;
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

  void TakeCells(BodyCells& result) const
  {
    for (Id cell = 0; cell < this->Mesh.NumberOfSlots(); ++cell)
    {
      if (this->Labels[At(cell)] > 0 && this->Mesh.IsTetrahedron(cell))
      {
        result.Labels.push_back(this->Labels[At(cell)]);
        for (Id corner = 4 * cell; corner < 4 * cell + 4; ++corner)
        {
          result.Corners.push_back(this->Order[At(this->Mesh.Corners[At(corner)])]);
        }
      }
    }
  }

  const TetMesh& Mesh;
  const std::vector<Id>& Order;
  const std::vector<TriangleSides>& Sides;
  Id BoundaryPoints;
  FacetTable Facets;
  std::vector<std::uint8_t> Seen; ///< of facets: from behind 1, from the front 2
  std::vector<Id> Labels;         ///< of cells
  std::vector<Id> Part;           ///< that hangs together
};

} // namespace

BodyCells LabelCells(const SpaceTriangulation& triangulation, const std::vector<Id>& facets,
  const std::vector<TriangleSides>& sides, std::size_t boundaryPoints, Pulse& pulse)
{
  return CellLabelling(triangulation, facets, sides, boundaryPoints).Run(pulse);
}

} // namespace biting
