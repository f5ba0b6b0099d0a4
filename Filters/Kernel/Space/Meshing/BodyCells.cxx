// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "BodyCells.h"

#include "../Finishing/BodyRelaxation.h"
#include "FacetTable.h"

#include <array>   // for corners
#include <cstdint> // for marks
#include <utility> // for move

namespace biting
{

namespace
{

class CellLabelling
{
public:
  CellLabelling(SpaceTriangulation& triangulation, const std::vector<Id>& facets,
    const std::vector<TriangleSides>& sides, std::size_t boundaryPoints, Pulse& pulse)
    : Mesh(triangulation.Mesh)
    , Sides(sides)
    , BoundaryPoints(static_cast<Id>(boundaryPoints))
    , Facets(facets, boundaryPoints)
    , Beats(pulse)
    , Parts(At(this->Mesh.NumberOfSlots()), NoId)
  {
    for (Id& corner : this->Mesh.Corners)
    {
      corner = corner < 0 ? corner : triangulation.Order[At(corner)];
    }
    ReleaseInSteps(
      pulse, triangulation.Order, this->Mesh.Points, this->Mesh.Weights, this->Mesh.VertexCells);
  }

  BodyCells Run()
  {
    BodyCells result;
    this->FindWalls();
    this->FindParts();
    this->LabelParts(result);
    if (result.Lost.empty() && !this->Beats.HasStopped())
    {
      this->TakeCells(result);
    }
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

  /// Their twins become codes.
  void FindWalls()
  {
    const auto isOfBoundary = [this](Id corner)
    { return corner >= 0 && corner < this->BoundaryPoints; };
    for (Id side = 0; side < 4 * this->Mesh.NumberOfSlots() && this->Beats.Beat(1); ++side)
    {
      const std::array<Id, 3> own{ this->Mesh.FacetCorner(side, 0), this->Mesh.FacetCorner(side, 1),
        this->Mesh.FacetCorner(side, 2) };
      if (!isOfBoundary(own[0]) || !isOfBoundary(own[1]) || !isOfBoundary(own[2]) ||
        this->Mesh.IsFree(TetMesh::CellOf(side)))
      {
        continue;
      }
      const std::array<Id, 3> corners = LowestFirst(own[0], own[1], own[2]);
      const Id facet = this->Facets.Find(corners);
      if (facet != NoId)
      {
        // The corners of a side are oriented away from its cell.
        const bool isBehind = this->Facets.CornersOf(facet) == corners;
        this->Walls.push_back({ TetMesh::CellOf(side), facet, std::size_t{ isBehind ? 0u : 1u } });
        this->Mesh.Twins[At(side)] = RelaxedBody::CodeOf(facet);
      }
    }
  }

  /// Of cells that no wall divides.
  void FindParts()
  {
    std::vector<Id> pending;
    for (Id first = 0; first < this->Mesh.NumberOfSlots(); ++first)
    {
      if (this->Parts[At(first)] != NoId || this->Mesh.IsFree(first))
      {
        continue;
      }
      const auto part = static_cast<Id>(this->Labels.size());
      this->Labels.push_back(NoId);
      const auto add = [this, part, &pending](Id cell)
      {
        if (this->Parts[At(cell)] == NoId)
        {
          this->Parts[At(cell)] = part;
          pending.push_back(cell);
        }
      };
      add(first);
      while (!pending.empty() && this->Beats.Beat(4))
      {
        const Id cell = pending.back();
        pending.pop_back();
        for (Id side = 4 * cell; side < 4 * cell + 4; ++side)
        {
          const Id twin = this->Mesh.Twins[At(side)];
          add(twin < 0 ? cell : TetMesh::CellOf(twin));
        }
      }
    }
  }

  /// Finds what is lost, too. Where facets are missing parts of space run into each other: these
  /// are what is wrong.
  void LabelParts(BodyCells& result)
  {
    constexpr std::uint8_t Both = 3;
    std::vector<std::uint8_t> seen(this->Sides.size(), 0); // of facets: from behind 1, in front 2
    for (const Wall& wall : this->Walls)
    {
      Id& label = this->Labels[At(this->Parts[At(wall.Cell)])];
      const Id own = this->Sides[At(wall.Facet)][wall.Place];
      label = label == NoId ? own : label;
      seen[At(wall.Facet)] |= static_cast<std::uint8_t>(1u << wall.Place);
      if (own != label)
      {
        result.Lost.push_back(wall.Facet);
      }
    }
    std::vector<Id> missing;
    for (std::size_t facet = 0; facet < seen.size(); ++facet)
    {
      if (seen[facet] != Both)
      {
        missing.push_back(static_cast<Id>(facet));
      }
    }
    result.Lost = missing.empty() ? result.Lost : missing;
  }

  /// Those of bodies come first, then the others go.
  void TakeCells(BodyCells& result)
  {
    TetMesh& mesh = this->Mesh;
    result.Labels.reserve(At(mesh.NumberOfCells()));
    for (Id cell = 0; cell < mesh.NumberOfSlots(); ++cell)
    {
      Id& place = this->Parts[At(cell)];
      const Id label = mesh.IsTetrahedron(cell) ? this->Labels[At(place)] : 0;
      place = label > 0 ? static_cast<Id>(result.Labels.size()) : NoId;
      if (label > 0)
      {
        result.Labels.push_back(label);
      }
    }
    for (Id side = 0; side < 4 * mesh.NumberOfSlots(); ++side)
    {
      const Id place = this->Parts[At(TetMesh::CellOf(side))];
      if (place != NoId)
      {
        const Id to = 4 * place + (side & 3);
        const Id twin = mesh.Twins[At(side)];
        mesh.Corners[At(to)] = mesh.Corners[At(side)];
        mesh.Twins[At(to)] =
          twin < 0 ? twin : 4 * this->Parts[At(TetMesh::CellOf(twin))] + (twin & 3);
      }
    }
    mesh.Corners.resize(4 * result.Labels.size());
    mesh.Twins.resize(4 * result.Labels.size());
    result.Corners = std::move(mesh.Corners);
    result.Twins = std::move(mesh.Twins);
  }

  TetMesh& Mesh; ///< of points, not of vertices
  const std::vector<TriangleSides>& Sides;
  Id BoundaryPoints;
  FacetTable Facets;
  Pulse& Beats;
  std::vector<Wall> Walls;
  std::vector<Id> Parts;  ///< of cells: their part; then their place among those of bodies
  std::vector<Id> Labels; ///< of parts
};

} // namespace

BodyCells LabelCells(SpaceTriangulation triangulation, const std::vector<Id>& facets,
  const std::vector<TriangleSides>& sides, std::size_t boundaryPoints, Pulse& pulse)
{
  return CellLabelling(triangulation, facets, sides, boundaryPoints, pulse).Run();
}

} // namespace biting
