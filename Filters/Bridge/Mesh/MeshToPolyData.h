// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingMeshToPolyData_h
#define BitingMeshToPolyData_h

#include "../../Kernel/Base/Pulse.h"
#include "../../Kernel/BitingMesh.h"
#include "../../Kernel/Quality/Quality.h"
#include "../../vtkBitingCompat.h" // for the ABI namespace
#include "../Drawing/Drawing.h"
#include "../Drawing/PolylinesFromDrawing.h"

#include "vtkPoints.h"       // for the points
#include "vtkSmartPointer.h" // for the points

#include <vector> // for values

VTK_ABI_NAMESPACE_BEGIN
class vtkFieldData;
class vtkPoints;
class vtkPolyData;
VTK_ABI_NAMESPACE_END

namespace biting
{

/// The vertices of `mesh` in space: those of the input bit for bit (on the globe up to whole
/// turns), the others mapped back.
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

/// Adds `Spacing`, `NearestNeighborDistance` and `Conformity` to point data.
void AddConformityArrays(
  const MeshQuality& quality, const std::vector<double>& spacing, vtkFieldData* data, Pulse& pulse);

/// Adds `MinimumAngle`, `RadiusEdgeRatio` and `AspectRatio` to cell data.
void AddShapeArrays(const MeshQuality& quality, vtkFieldData* data, Pulse& pulse);

/// Adds the numbers of vertices and triangles and the worst shapes, one value each.
void AddShapeSummary(const MeshQuality& quality, vtkFieldData* data);

/// Adds the conformity of the whole mesh, one value each.
void AddConformitySummary(const MeshQuality& quality, vtkFieldData* data);

/// Fills `output` with the edges of `mesh`, whose vertices are `points`, that cover boundary and
/// interfaces. Each edge carries the values of all cell arrays of `drawing` at its cell; one
/// without a cell has NaN, -1, 0 where there is no -1, or an empty text.
/// On abort `output` has no meaning.
void BoundaryEdgesToPolyData(const BitingMesh& mesh, vtkPoints* points, const Drawing& drawing,
  vtkPolyData* output, Pulse& pulse);

} // namespace biting

#endif
