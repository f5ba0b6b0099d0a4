// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingRegularTriangulation_h
#define BitingRegularTriangulation_h

#include "../../Base/Ids.h"
#include "../../Base/Point.h"
#include "CavityCones.h"
#include "TetMesh.h"

#include <cstdint> // for marks
#include <utility> // for move
#include <vector>  // for lists

namespace biting
{

/// What became of a point.
enum class PointOutcome
{
  Inserted,  ///< it is a vertex
  Waiting,   ///< all points up to now lie in one plane
  Duplicate, ///< it is at the place of a vertex
  Hidden     ///< too light
};

struct PointInsertion
{
  PointOutcome What = PointOutcome::Waiting;
  Id Vertex = NoId; ///< the number of the new vertex; of a duplicate the vertex at its place
};

/// A vertex that waited, or was hidden, and turned out to be at the place of another one.
struct LateDuplicate
{
  Id Vertex = NoId;
  Id Of = NoId;
};

/// The regular triangulation of weighted points of space, made one point after the other; without
/// weights it is the Delaunay triangulation.
///
/// Insertion: a walk from a vertex nearby finds the cell of the point; the cells in conflict with
/// it are a cavity, which is star-shaped as seen from the point and is filled with the cones over
/// its walls (A. Bowyer, D. F. Watson, 1981). Ties are decided by TieInSphere, which knows places
/// only: so the triangulation depends neither on the order of insertion nor on the numbers of the
/// vertices, and a vertex that comes and goes leaves it as it was.
///
/// While all points lie in one plane there are no cells: vertices wait. A point at the place of a
/// vertex is a duplicate, whatever its weight. A point too light to have a cell is hidden; it comes
/// back when a removal makes room.
/// Invariant: CheckTetMesh(Mesh(), true) is empty.
class RegularTriangulation
{
public:
  /// Of points that have weights, or of those that have none.
  explicit RegularTriangulation(bool hasWeights = false)
    : HasWeights(hasWeights)
  {
  }

  /// Room for points of ordinary distributions: 6.8 cells a point.
  void Reserve(std::size_t numberOfPoints, double cellsPerPoint = 6.8);

  /// Inserts a point; the number of a new vertex is the next one. `hint`: a vertex nearby, or NoId.
  PointInsertion Insert(const Point3& point, double weight = 0.0, Id hint = NoId);

  /// Removes a vertex; its number is not given again. Its neighbours are triangulated apart, and
  /// the cells of that in its star are taken over: O(k^2) for k neighbours. Hidden points are tried
  /// again, each of them.
  void Remove(Id vertex);

  const TetMesh& Mesh() const { return this->Tets; }

  /// Its arrays go to the caller.
  TetMesh TakeMesh() { return std::move(this->Tets); }

  /// What a user keeps of cells (TetMesh).
  std::vector<Id>& KeepLabels();

  /// The cell in which the point lies, from the vertex `hint` or NoId: a tetrahedron, or a ghost if
  /// it is beyond the hull. NoId where there are no cells.
  Id Locate(const Point3& point, Id hint) const;

  const std::vector<LateDuplicate>& LateDuplicates() const { return this->Late; }
  /// Of the space that the vertices span: 3 where there are cells, 2 in a plane, 1 on a line, 0 at
  /// one place, -1 where there are none.
  int Dimension() const
  {
    return this->Tets.NumberOfCells() > 0 ? 3 : static_cast<int>(this->Base.size()) - 1;
  }

  const std::vector<Id>& HiddenVertices() const { return this->Hidden; }

private:
  PointInsertion InsertVertex(Id vertex, Id hint);
  PointInsertion Wait(Id vertex);
  void Start();
  void FindCavity(Id first, Id vertex);
  void InsertLater(const std::vector<Id>& vertices);
  void WaitAgain();
  void StartAgain(Id without);

  bool HasWeights;
  TetMesh Tets;
  Id LastVertex = NoId;    ///< where walks begin without a hint
  std::vector<Id> Waiting; ///< in the order they came
  std::vector<Id> Base;    ///< up to four of these, affinely independent
  std::vector<Id> Hidden;
  std::vector<LateDuplicate> Late;
  CavityCones Cavity;
  std::vector<std::uint8_t> Marks; ///< of cells, while a cavity is looked for; else all Unseen
};

} // namespace biting

#endif
