// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingTetMesh_h
#define BitingTetMesh_h

#include "../../Base/Ids.h"
#include "../../Base/Point.h"
#include "../../Predicates/Predicates3.h"

#include <cstddef> // for size_t
#include <string>  // for the check
#include <vector>  // for the arrays

namespace biting
{

/// The tetrahedral mesh at work: its cells cover all of space. Beyond each triangle of the convex
/// hull lies a ghost, whose corner 3 is the vertex at infinity, NoId. Other cells are tetrahedra.
///
/// Facet e = 4t + k (k = 0..3) belongs to cell t and lies opposite its corner k, Corners[e].
/// Twins[e] is the same facet in the cell on its other side: there is always one. Corners are
/// oriented positively (Orient3D); of a ghost, where the vertex at infinity is any point beyond the
/// hull's triangle. The corners of facet e, in the order FacetCorners[k], are oriented so that
/// corner k makes a positive cell in front of them.
///
/// Free cells have Free as corner 3; Twins[4t] is the next free cell.
struct TetMesh
{
  static constexpr Id Free = -2;
  static constexpr int FacetCorners[4][3] = { { 1, 2, 3 }, { 0, 3, 2 }, { 0, 1, 3 }, { 0, 2, 1 } };

  std::vector<Point3> Points;
  std::vector<double> Weights; ///< of the vertices; empty: all are 0
  std::vector<Id> Corners;
  std::vector<Id> Twins;
  std::vector<Id> VertexCells; ///< a cell whose corner the vertex is; NoId where there is none

  /// What a user keeps of each cell; NoId in new ones. Empty unless KeepLabels was called.
  std::vector<Id> Labels;

  Id FirstFree = NoId;
  Id NumberOfFree = 0;

  static Id CellOf(Id facet) { return facet >> 2; }
  static Id FirstFacet(Id cell) { return cell << 2; }

  /// Cells that are free are counted.
  Id NumberOfSlots() const { return static_cast<Id>(this->Corners.size() >> 2); }
  Id NumberOfCells() const { return this->NumberOfSlots() - this->NumberOfFree; }
  Id NumberOfVertices() const { return static_cast<Id>(this->Points.size()); }

  bool IsFree(Id cell) const { return this->Corners[Index(4 * cell + 3)] == Free; }
  bool IsGhost(Id cell) const { return this->Corners[Index(4 * cell + 3)] == NoId; }
  bool IsTetrahedron(Id cell) const { return this->Corners[Index(4 * cell + 3)] >= 0; }

  const Point3& PointAt(Id vertex) const { return this->Points[Index(vertex)]; }
  double WeightAt(Id vertex) const
  {
    return this->Weights.empty() ? 0.0 : this->Weights[Index(vertex)];
  }

  /// Corner j (0..2) of the facet, in the order of FacetCorners.
  Id FacetCorner(Id facet, int j) const
  {
    return this->Corners[Index((facet & ~3) + FacetCorners[facet & 3][j])];
  }

  void Link(Id facet, Id twin)
  {
    this->Twins[Index(facet)] = twin;
    this->Twins[Index(twin)] = facet;
  }

  void KeepLabels() { this->Labels.resize(this->Corners.size() >> 2, NoId); }

  /// A cell for which Corners and Twins are still to be set.
  Id NewCell();
  void FreeCell(Id cell);

  /// Sets corners so that the vertex at infinity, if any, comes last; the first one and the cyclic
  /// order of the others are kept. The first is no ghost's.
  void SetCorners(Id cell, Id first, Id a, Id b, Id c);

  /// Whether the point and the cell exclude each other: the point lies inside the sphere of the
  /// tetrahedron (the one orthogonal to its corners, if there are weights), or beyond the triangle
  /// of the ghost; where it lies in the plane of that triangle, inside its circle. Ties are decided
  /// by TieInSphere. The point is none of the cell's corners.
  bool IsInConflict(Id cell, const Point3& point, double weight) const;

  /// All of memory that the arrays take.
  std::size_t Bytes() const;

  static std::size_t Index(Id id) { return static_cast<std::size_t>(id); }
};

/// Checks: twins are mutual and have the same three corners in opposite orientation; ghosts have
/// the vertex at infinity last and no other cell has it; tetrahedra are oriented positively,
/// exactly; the cell of each vertex has it; free cells are those of the list; Euler's number of the
/// three-sphere: vertices - edges + facets - cells = 0. With `isRegular` also, exactly: no cell is
/// in conflict with the corner across any of its facets, which makes the triangulation regular and
/// the hull convex. Returns the first violation as text, empty where there is none.
std::string CheckTetMesh(const TetMesh& mesh, bool isRegular);

} // namespace biting

#endif
