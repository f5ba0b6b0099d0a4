// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingBodyToGrid_h
#define BitingBodyToGrid_h

#include "../../Kernel/Base/Monitor.h"
#include "../../Kernel/Space/Meshing/BodyMesher.h"
#include "../../vtkBitingCompat.h" // for the ABI namespace
#include "../Drawing/Drawing.h"

#include <string> // for the summary

VTK_ABI_NAMESPACE_BEGIN
class vtkPolyData;
class vtkUnstructuredGrid;
VTK_ABI_NAMESPACE_END

namespace biting
{

/// Fills `mesh` with the tetrahedra of the body and `boundary` with its boundary, and both with the
/// arrays and figures that the documentation of vtkBitingTetrahedralizer lists; `surface` and
/// `drawing` are what the body was made of. Regions of the boundary become those of the cells
/// there. Returns the mesh in a few lines. On abort outputs have no meaning.
std::string BitingBodyToGrid(BitingBody& body, const CheckedSurface& surface,
  const Drawing& drawing, vtkUnstructuredGrid* mesh, vtkPolyData* boundary, Monitor& monitor);

} // namespace biting

#endif
