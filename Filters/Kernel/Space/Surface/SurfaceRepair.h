// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSurfaceRepair_h
#define BitingSurfaceRepair_h

#include "../../Base/Problem.h"
#include "../../Base/Pulse.h"
#include "SurfaceLinks.h"

namespace biting
{

/// Keeps the first of the triangles that have the same three vertices, whatever their orientation;
/// tells the others as DuplicateTriangles. Walls that two regions give become one, of both regions.
void RemoveDuplicates(SurfaceMesh& mesh, ProblemList& problems, Pulse& pulse);

/// Removes triangles whose corners lie on one line, exactly, and tells them as FlatTriangles.
///
/// The triangle (a, b, c) with b between a and c goes, and the triangle (c, a, d) across ac becomes
/// (c, b, d) and (b, a, d): an edge flip that changes no place of the surface. Where ac is open the
/// triangle only goes. It stays where ac has more than two triangles, where bd is an edge already,
/// or no shorter than ac and (c, a, d) is to go, too: then it is told that it stayed. Each flip
/// takes a triangle away or makes an edge shorter, so that flips end.
void RemoveFlatTriangles(
  SurfaceMesh& mesh, SurfaceLinks& links, ProblemList& problems, Pulse& pulse);

/// The same for those triangles, of the number `first` and above, whose height is below a tenth of
/// the longest side.
void FlipThinTriangles(SurfaceMesh& mesh, SurfaceLinks& links, std::size_t first, Pulse& pulse);

} // namespace biting

#endif
