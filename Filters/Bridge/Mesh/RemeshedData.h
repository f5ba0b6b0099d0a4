// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingRemeshedData_h
#define BitingRemeshedData_h

#include "../../Kernel/Base/Pulse.h"
#include "../../Kernel/BitingRemesh.h"
#include "../../vtkBitingCompat.h" // for the ABI namespace
#include "../Drawing/RemeshInputFromDataSet.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkDataSet;
class vtkPolyData;
VTK_ABI_NAMESPACE_END

namespace biting
{

/// Adds the arrays of `from` to `output`, the mesh `result` as poly data with arrays of its own,
/// which stay. At kept vertices and unchanged triangles values are copied. At new vertices real
/// numbers are linear in the old triangle there, and others those of its nearest corner; new
/// triangles have those of the old one at their middle, and the array `region` that of their
/// region. Active attributes are not passed on: ids that were unique are not.
void TransferData(const RemeshResult& result, const PlanarMesh& mesh, vtkDataSet* from,
  const std::string& region, vtkPolyData* output, Pulse& pulse);

/// Adds to `output` the cell array `OriginalCellId` and, as field data, the numbers of kept,
/// removed and new vertices and of kept triangles.
void AddOriginals(const RemeshResult& result, const PlanarMesh& mesh, vtkPolyData* output);

/// Makes `output` the mesh `from` itself, with all arrays, and with `OriginalPointId` and
/// `OriginalCellId`. An unstructured grid becomes the poly data of its triangles.
void PassThrough(const PlanarMesh& mesh, vtkDataSet* from, vtkPolyData* output);

} // namespace biting

#endif
