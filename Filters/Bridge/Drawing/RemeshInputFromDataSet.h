// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingRemeshInputFromDataSet_h
#define BitingRemeshInputFromDataSet_h

#include "../../Kernel/Base/Monitor.h"
#include "../../Kernel/Remeshing/OldMesh.h"
#include "../../vtkBitingCompat.h" // for the ABI namespace
#include "Drawing.h"
#include "PolylinesFromDrawing.h"

#include "vtkSmartPointer.h" // for the array
#include "vtkType.h"         // for vtkIdType

#include <string> // for names and refusals
#include <vector> // for ids

VTK_ABI_NAMESPACE_BEGIN
class vtkAlgorithm;
class vtkDataSet;
class vtkPolyData;
VTK_ABI_NAMESPACE_END

namespace biting
{

/// A mesh as the kernel takes it, with the ids of its dataset.
struct PlanarMesh
{
  RemeshInput Input;
  std::vector<vtkIdType> PointIds; ///< of each vertex
  std::vector<vtkIdType> CellIds;  ///< of each triangle
  PlanarInput Planar;              ///< its plane, and the places of all points
  Drawing Lines;                   ///< whose cells the lines are
};

/// The arrays that keep edges, points and cells of the mesh; empty or "None": none.
struct RemeshArrays
{
  std::string Region; ///< cell array: edges between triangles of different values stay
  std::string Frozen; ///< array of points, cells or lines: those with a value other than 0 stay
};

/// Reads the triangles of `mesh` (FacesFromDataSet.h), and the lines that tag edges: the cells of
/// `lines`, or, where that is null, the lines among those of `mesh`. Lines belong to the vertices
/// at the same places, bit for bit. Vertices whose point array `VertexKind` is 3 stay.
/// Returns why the mesh cannot be read, empty where it can.
std::string RemeshInputFromDataSet(vtkDataSet* mesh, vtkDataSet* lines, const RemeshArrays& arrays,
  PlanarMesh& result, Monitor& monitor);

/// Output 1, edges or triangles of the boundary, of the nearest mesher, remesher or reader of ours
/// upstream of the first input of `consumer`; null where there is none.
vtkPolyData* FindProducedEdges(vtkAlgorithm* consumer);

/// Whether each point of `edges` lies at the point of `mesh` that its `MeshPointId` names.
bool AreEdgesOf(vtkPolyData* edges, vtkDataSet* mesh);

/// FindProducedEdges where `mesh`, the input of `consumer`, has no lines, and AreEdgesOf holds;
/// else null.
vtkPolyData* FindTaggedEdges(vtkAlgorithm* consumer, vtkDataSet* mesh);

} // namespace biting

#endif
