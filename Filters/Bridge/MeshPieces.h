// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingMeshPieces_h
#define BitingMeshPieces_h

#include "../Kernel/Base/Ids.h"
#include "../Kernel/Base/Pulse.h"
#include "../Kernel/BitingMesh.h"
#include "../vtkBitingCompat.h" // for the ABI namespace

#include "vtkSmartPointer.h" // for the pieces

#include <vector> // for lists

VTK_ABI_NAMESPACE_BEGIN
class vtkPolyData;
VTK_ABI_NAMESPACE_END

namespace biting
{

/// Which of `numberOfPieces` each triangle is of: it goes with the block that its middle lies in,
/// and blocks are dealt out by DealLeaves. Empty where the mesh is of one block.
std::vector<Id> PiecesOfTriangles(const BitingMesh& mesh, Id numberOfPieces, Pulse& pulse);

/// The pieces of a mesh of triangles, as VTK has them on ranks.
///
/// A piece has triangles and points in the order of the mesh, with all their arrays, and the field
/// data. Added are `GlobalPointIds` and `GlobalCellIds` (vtkIdType, the active global ids): the
/// numbers in the mesh; and the point array `vtkGhostType` (unsigned char): DUPLICATEPOINT where
/// another piece has the point as its own, which is the first one that has a triangle at it. With
/// ghost levels, a piece also has the triangles of others around its own, level by level across
/// their points, which the cell array `vtkGhostType` marks as DUPLICATECELL.
class MeshPieces
{
public:
  MeshPieces(
    vtkSmartPointer<vtkPolyData> mesh, std::vector<Id> piecesOfTriangles, Id numberOfPieces);

  /// To be called before Make; else there are none.
  void SetGhostLevels(int levels);

  Id Count() const { return this->NumberOfPieces; }

  vtkSmartPointer<vtkPolyData> Make(Id piece);

private:
  using Numbers = std::vector<vtkIdType>;

  void OwnPoints();
  void ListTriangles();
  void ListUses();
  Numbers TrianglesOf(Id piece) const;
  bool IsShared(vtkIdType point) const;
  void AddLevel(Id piece, Numbers& points, Numbers& ghosts) const;
  Numbers PointsOf(Id piece, const Numbers& triangles) const;
  void AddPoints(Id piece, const Numbers& points, vtkPolyData* output) const;
  void AddTriangles(Id piece, const Numbers& triangles, vtkPolyData* output) const;

  vtkSmartPointer<vtkPolyData> Mesh;
  std::vector<Id> Pieces; ///< of the triangles
  Id NumberOfPieces;
  int GhostLevels = 0;
  Numbers Corners;
  std::vector<Id> Owners; ///< pieces, of the points
  Numbers FirstPoints;    ///< of each piece, in OwnedPoints
  Numbers OwnedPoints;
  Numbers FirstTriangles; ///< of each piece, in Triangles
  Numbers Triangles;
  Numbers FirstUses; ///< of each point, in Uses; with ghost levels
  Numbers Uses;      ///< triangles
  Numbers NewIds;    ///< of the points in the piece that is made
};

} // namespace biting

#endif
