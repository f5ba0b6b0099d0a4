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
class vtkDataSet;
VTK_ABI_NAMESPACE_END

namespace biting
{

/// A mesh as the kernel takes it, and what leads back to its dataset.
struct PlanarMesh
{
  RemeshInput Input;
  std::vector<vtkIdType> PointIds; ///< of each vertex
  std::vector<vtkIdType> CellIds;  ///< of each triangle
  PlanarInput Planar;              ///< its plane, and the places of all points
  Drawing Lines;                   ///< whose cells the lines are
};

/// Which arrays of the mesh say what stays; empty or "None": none.
struct RemeshArrays
{
  std::string Region; ///< cell array: edges between triangles that differ in it stay edges
  std::string Frozen; ///< point or cell array, also of lines: what is not 0 there stays as it is
};

/// Reads the triangles of `mesh` (FacesFromDataSet.h), and the lines that tag edges: the cells of
/// `lines`, or, where that is null, the lines among those of `mesh`. Lines belong to the vertices
/// at the same places, bit for bit. Vertices whose point array `VertexKind` is 3 stay.
/// Returns why the mesh cannot be read, empty where it can.
std::string RemeshInputFromDataSet(vtkDataSet* mesh, vtkDataSet* lines, const RemeshArrays& arrays,
  PlanarMesh& result, Monitor& monitor);

} // namespace biting

#endif
