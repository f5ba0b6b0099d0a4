// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSurfaceWelding_h
#define BitingSurfaceWelding_h

#include "../../Base/Pulse.h"
#include "SurfaceMesh.h"

namespace biting
{

/// Gives vertices the numbers of those that they become, `kept`, a lower number or their own; keeps
/// those in use, and the triangles that have three corners.
void MergeVertices(SurfaceMesh& mesh, const std::vector<Id>& kept);

/// Makes one vertex of points at one place, in the order of the first point at each, and forgets
/// points that no triangle uses. Triangles of which two corners become one go. Returns how many
/// points in use were at the place of another.
std::size_t WeldEqualPoints(SurfaceMesh& mesh, Pulse& pulse);

/// The same for vertices of open edges that differ by no more than `rounding` along each axis. The
/// first of them stays where it is, and no two that stay are that near to each other. Where the
/// surface is closed already nothing moves: edges shorter than the rounding are shapes, too.
/// Returns how many vertices became others. Cost O(n).
std::size_t WeldBorders(SurfaceMesh& mesh, const Point3& rounding, Pulse& pulse);

} // namespace biting

#endif
