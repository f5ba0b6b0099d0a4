// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSurfaceToPolyData_h
#define BitingSurfaceToPolyData_h

#include "../../Kernel/Base/Problem.h"
#include "../../Kernel/Base/Pulse.h"
#include "../../Kernel/Space/Meshing/SurfaceMesher.h"
#include "../../Kernel/Space/Surface/SurfaceCheck.h"
#include "../../vtkBitingCompat.h" // for the ABI namespace
#include "../Drawing/Drawing.h"

#include "vtkPoints.h"
#include "vtkSmartPointer.h" // for points

#include <string> // for the summary

VTK_ABI_NAMESPACE_BEGIN
class vtkPolyData;
VTK_ABI_NAMESPACE_END

namespace biting
{

/// Points at `places`; `type` is VTK_FLOAT or VTK_DOUBLE.
vtkSmartPointer<vtkPoints> MakePoints(const std::vector<Point3>& places, int type, Pulse& pulse);

/// Makes `output` triangles, three of `corners` each, between `places`, without arrays; `type` is
/// VTK_FLOAT or VTK_DOUBLE.
void SetTriangles(const std::vector<Point3>& places, const std::vector<Id>& corners, int type,
  vtkPolyData* output, Pulse& pulse);

/// The repaired surface with the arrays of the drawing and those that the documentation of
/// vtkBitingSurfaceCheck lists for output 0.
void SurfaceToPolyData(const CheckedSurface& surface, const ProblemList& problems,
  const Drawing& drawing, vtkPolyData* output, Pulse& pulse);

/// Edges between `places` as lines, two ends each, with their kinds; `mesh` has the same places.
void EdgesToPolyData(const std::vector<Point3>& places, const std::vector<Id>& given,
  const std::vector<SurfaceEdgeKind>& edgeKinds, vtkPolyData* mesh, vtkPolyData* output);

/// What it is in a few lines, and what is wrong with it.
std::string SummaryOf(const CheckedSurface& surface, const ProblemList& problems);

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
