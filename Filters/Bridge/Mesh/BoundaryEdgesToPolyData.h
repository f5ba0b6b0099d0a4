// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingBoundaryEdgesToPolyData_h
#define BitingBoundaryEdgesToPolyData_h

#include "../../Kernel/Base/Pulse.h"
#include "../../Kernel/BitingMesh.h"
#include "../../vtkBitingCompat.h" // for the ABI namespace
#include "../Drawing/Drawing.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkPoints;
class vtkPolyData;
VTK_ABI_NAMESPACE_END

namespace biting
{

/// Fills `output` with the edges of `mesh`, whose vertices are `points`, that cover boundary and
/// interfaces. Each edge carries the values of all cell arrays of `drawing` at its cell; one
/// without a cell has NaN, -1, 0 where there is no -1, or an empty text.
/// On abort `output` has no meaning.
void BoundaryEdgesToPolyData(const BitingMesh& mesh, vtkPoints* points, const Drawing& drawing,
  vtkPolyData* output, Pulse& pulse);

} // namespace biting

#endif
