// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSurfaceFromDrawing_h
#define BitingSurfaceFromDrawing_h

#include "../../Kernel/Base/Monitor.h"
#include "../../Kernel/Space/Surface/SurfaceMesh.h"
#include "CoordinateRounding.h"
#include "Drawing.h"

#include <string> // for the refusal

namespace biting
{

/// A surface as it comes, and how exact its coordinates are.
struct GivenSurface
{
  SurfaceMesh Mesh; ///< all points, whether or not a triangle uses them
  CoordinateRounding Rounding;
};

/// Reads the two-dimensional cells of all blocks as triangles. Quads are divided by the shorter
/// diagonal that leaves both triangles on one side, polygons by cutting ears, strips into their
/// triangles; of quadratic cells the corners are cut off at the points on sides. Cells of less than
/// two dimensions, hidden and ghost cells, and cells with a hidden point, are left out. Returns why
/// it cannot be read, empty where it can: a cell of three dimensions or of higher order, a cell
/// that refers to a point that does not exist, more points or corners than 32-bit ids can number,
/// coordinates that are not finite or beyond GreatestCoordinate3.
std::string SurfaceFromDrawing(const Drawing& drawing, GivenSurface& surface, Monitor& monitor);

} // namespace biting

#endif
