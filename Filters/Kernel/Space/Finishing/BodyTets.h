// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingBodyTets_h
#define BitingBodyTets_h

#include "../../Base/IdLists.h"
#include "../Delaunay/TetMesh.h"
#include "../Surface/SurfaceMesh.h"
#include "BodyRelaxation.h"
#include "LinePieces.h"
#include "TetShape.h"

#include <array>   // for corners
#include <cstdint> // for stamps
#include <vector>  // for the arrays

namespace biting
{

class CellChange;

/// The tetrahedra of a body at work. Mesh is as TetMesh says, with regions as labels, but has no
/// ghosts: facets of the boundary and of interfaces have records, numbered as RelaxedBody::Facets,
/// and Twins is as RelaxedBody has it.
class BodyTets
{
public:
  /// Takes points, corners, twins and regions of the body until GiveBack.
  BodyTets(RelaxedBody& body, Pulse& pulse);

  /// Gives them back with the facets.
  void GiveBack();

  using Tetrahedron = std::array<Id, 4>;

  /// What a vertex may do.
  enum class Kind : std::uint8_t
  {
    OnLine, ///< a corner, or slides on its chain
    OnPatch,
    Inside
  };

  /// A vertex of no cell as yet.
  Id AddVertex();

  /// A record for a part of the facet of another one.
  Id AddRecord(Id other);

  /// The slots of the vertex in its cells. Good until the next call.
  const std::vector<Id>& StarOf(Id vertex);

  /// Of the facets with records at the vertex, one slot each.
  std::vector<Id> FacetsAt(Id vertex);

  Id VertexAt(Id slot) const { return this->Mesh.Corners[At(slot)]; }
  const Point3& PointOf(Id slot) const { return this->Mesh.PointAt(this->VertexAt(slot)); }

  /// Precondition: the vertex is a corner of the cell.
  Id SlotOf(Id cell, Id vertex) const
  {
    Id slot = 4 * cell;
    while (this->VertexAt(slot) != vertex)
    {
      ++slot;
    }
    return slot;
  }

  /// The slot of the same facet in the other cell, if there is one; else NoId.
  Id Across(Id slot) const;

  /// The record of the facet of the slot; below 0 where it has none.
  Id RecordOf(Id slot) const { return RelaxedBody::CodeOf(this->Mesh.Twins[At(slot)]); }
  bool IsInterface(Id record) const { return this->FacetSlots[At(2 * record + 1)] != NoId; }

  double BadnessOf(const Tetrahedron& t) const
  {
    return TetShape(this->Mesh.PointAt(t[0]), this->Mesh.PointAt(t[1]), this->Mesh.PointAt(t[2]),
      this->Mesh.PointAt(t[3]))
      .Badness();
  }

  Tetrahedron CornersOf(Id cell) const
  {
    const Id* c = &this->Mesh.Corners[At(4 * cell)];
    return { c[0], c[1], c[2], c[3] };
  }

  std::array<Id, 3> FacetCorners(Id slot) const
  {
    return { this->Mesh.FacetCorner(slot, 0), this->Mesh.FacetCorner(slot, 1),
      this->Mesh.FacetCorner(slot, 2) };
  }

  RelaxedBody& Body;
  LinePieces Lines;
  TetMesh Mesh;
  std::vector<Kind> Kinds;     ///< of vertices
  std::vector<double> Badness; ///< of cells

  // Times: of the last change of a cell at a vertex; of the last vain attempt to move a vertex, or
  // to change a cell. An attempt is repeated only after a change at the vertex, or at a corner of
  // the cell.
  std::uint32_t Clock = 0;
  std::vector<std::uint32_t> Touched;      ///< of vertices
  std::vector<std::uint32_t> TriedMoves;   ///< of vertices
  std::vector<std::uint8_t> NumberOfMoves; ///< by trial, of vertices
  std::vector<std::uint32_t> Tried;        ///< of cells

  bool IsTrial = false;
  std::vector<CellChange>* Log = nullptr; ///< gets what takes changes back, in their order

private:
  friend class CellChange;

  std::vector<Id> DropUnused();
  void DropFree(const std::vector<Id>& numbers, const std::vector<Id>& records);
  std::vector<Id> GiveBackFacets();
  void ResizeCells();
  void Attach(Id record, Id half, Id slot);

  Id NumberOfGiven;           ///< vertices
  std::vector<Id> FacetSlots; ///< two a record: of the cells on its sides, NoId beyond the boundary
  std::vector<Id> Star;
  std::vector<std::uint32_t> Stamps; ///< of cells
  std::uint32_t Stamp = 0;
};

} // namespace biting

#endif
