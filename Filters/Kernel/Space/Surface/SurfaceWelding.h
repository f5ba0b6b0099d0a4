// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSurfaceWelding_h
#define BitingSurfaceWelding_h

#include "../../Base/Problem.h"
#include "../../Base/Pulse.h"
#include "SurfaceMesh.h"

#include <functional> // for lengths by place

namespace biting
{

using SpacingField = std::function<double(const Point3&)>;

/// Makes one vertex of points at one place, in the order of the first point at each, and forgets
/// points that no triangle uses. Triangles of which two corners become one go. Returns how many
/// points in use were at the place of another.
std::size_t WeldEqualPoints(SurfaceMesh& mesh, Pulse& pulse);

/// The same for vertices of open edges that differ by no more than `rounding` along each axis. The
/// first of them stays where it is, and no two that stay are that near to each other. Where the
/// surface is closed already nothing moves: edges shorter than the rounding are shapes, too.
/// Returns how many became others. Cost: n log n, and n times the vertices in a slab as wide.
std::size_t WeldBorders(SurfaceMesh& mesh, const Point3& rounding, Pulse& pulse);

/// The same for those that are nearer than a tenth of the shortest side of their triangles, and
/// than `reach` there. Each is told as NearPoints.
void WeldSlits(SurfaceMesh& mesh, const SpacingField& reach, ProblemList& problems, Pulse& pulse);

} // namespace biting

#endif
