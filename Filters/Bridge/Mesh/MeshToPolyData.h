// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingMeshToPolyData_h
#define BitingMeshToPolyData_h

#include "../../Kernel/Base/Pulse.h"
#include "../../Kernel/BitingMesh.h"
#include "../../vtkBitingCompat.h" // for the ABI namespace
#include "../Drawing/PolylinesFromPolyData.h"

#include "vtkPoints.h"       // for the points
#include "vtkSmartPointer.h" // for the points

VTK_ABI_NAMESPACE_BEGIN
class vtkPolyData;
VTK_ABI_NAMESPACE_END

namespace biting
{

/// The vertices of `mesh` in space: those of the input bit for bit, the others mapped back.
vtkSmartPointer<vtkPoints> PointsInSpace(
  const BitingMesh& mesh, const PlanarInput& input, Pulse& pulse);

/// Fills `output` with the triangles of `mesh` over `points`, the arrays on vertices and triangles,
/// and the summary with the number of each repair as field data. On abort `output` has no meaning.
void MeshToPolyData(const BitingMesh& mesh, vtkPoints* points, const ProblemList& problems,
  vtkPolyData* output, Pulse& pulse);

/// Says where a piece is in the whole mesh: adds `GlobalPointIds` and `GlobalCellIds` (vtkIdType,
/// the active global ids), the numbers in the whole, and the point array `vtkGhostType` (unsigned
/// char): DUPLICATEPOINT where another rank has the point as its own, which is the first one that
/// has a triangle at it. With ghosts, the cell array `vtkGhostType` marks triangles of other ranks
/// as DUPLICATECELL.
void AddPieceArrays(const MeshPiece& piece, bool hasGhosts, vtkPolyData* output, Pulse& pulse);

} // namespace biting

#endif
