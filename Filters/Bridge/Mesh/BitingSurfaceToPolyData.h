// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingBitingSurfaceToPolyData_h
#define BitingBitingSurfaceToPolyData_h

#include "../../Kernel/Base/Pulse.h"
#include "../../Kernel/Space/Meshing/SurfaceMesher.h"
#include "../../vtkBitingCompat.h" // for the ABI namespace
#include "../Drawing/Drawing.h"

#include <string> // for the summary

VTK_ABI_NAMESPACE_BEGIN
class vtkPolyData;
VTK_ABI_NAMESPACE_END

namespace biting
{

/// Fills `output` with the mesh, its measures and its figures, as the documentation of
/// vtkBitingSurfaceMesher lists them, and with the cell arrays of `drawing`, of which `surface` was
/// read. Returns the mesh in a few lines. On abort `output` has no meaning.
std::string BitingSurfaceToPolyData(const BitingSurface& mesh, const CheckedSurface& surface,
  const Drawing& drawing, vtkPolyData* output, Pulse& pulse);

/// A line for the summary where caps of f made many times the vertices asked for; else empty.
std::string CapsText(double asked, std::size_t made);

/// Fills `output` with one vertex cell a bite.
void SpheresToPolyData(
  const std::vector<Point3>& centers, const std::vector<double>& radii, vtkPolyData* output);

} // namespace biting

#endif
