// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSurfaceUnion_h
#define BitingSurfaceUnion_h

#include "../Surface/SurfaceCheck.h"

// The union of closed surfaces that cross each other or themselves.
//
// Inside is where the winding number is 1 or more; surfaces that cross nothing are oriented by
// nesting, so that cavities stay. Triangles that meet others are divided along segments: exact
// signs say which triangles meet which sides; a place where a side meets a triangle is the same for
// both triangles at the side. Triangles that lie on each other are divided together, in one plane.
// New points nearer to a point than the tolerance are that one, and points that near to a segment
// divide it in all planes that have it. The pieces are those of a constrained Delaunay
// triangulation in each plane. Each piece is asked for itself, by a ray, what is on both its sides.
// So pieces that do not fit leave open edges, which CheckSurface finds. What is inside is not clear
// where a shell within another one, of which it would be a cavity, lies on a side of that, and
// where the winding number is below 0: a lobe of a surface that is inside out.

namespace biting
{

/// Of surfaces that bound something (IsBounding), of no regions; else, where it is not clear, and
/// where segments could not be recovered, empty. Triangles have the cells of those that
/// they are pieces of; new points have no id. The tolerance is 1e-7 of the diagonal, or 4 times the
/// noise of coordinates. Cost O(n log n) but for k segments and points in one plane: O(k^2).
SurfaceMesh UniteSurfaces(const CheckedSurface& surface, double noise, Pulse& pulse);

} // namespace biting

#endif
