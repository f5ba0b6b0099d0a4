// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSurfaceHoles_h
#define BitingSurfaceHoles_h

#include "../../Base/Problem.h"
#include "../../Base/Pulse.h"
#include "SurfaceLinks.h"

#include <functional> // for the spacing

// Holes and slits that leave no doubt about what is inside, by f.
//
// A slit of half width s takes the share atan(s / z) / pi from the winding number at the distance z
// in front of it: more than a quarter where z < s, which is nearer than sqrt(2) s to its borders. A
// round hole of radius s does so nearer than 1.16 s. So where no place of a hole is farther from
// its border than f / (4 sqrt(2)), the winding number is clear (not between 1/4 and 3/4) at all
// places that are f / 4 from the surface, and any narrow patch has the same inside.

namespace biting
{

using SpacingField = std::function<double(const Point3&)>;

/// Makes one vertex of those of open edges that are nearer to each other than a tenth of the
/// shortest open edge at either, and than f / (4 sqrt(2)). Each is told as NearPoints.
void WeldSlits(SurfaceMesh& mesh, const SpacingField& spacing, ProblemList& problems, Pulse& pulse);

/// Closes loops of open edges (BorderChains) by triangles, told as ClosedHoles: those of at most
/// 10000 edges, of which no middle of a triangle or new edge is farther than f / (4 sqrt(2)) from
/// the loop. The triangulation is that of the least area but for a thousandth of the squares of
/// lengths; long loops are divided before, at short edges. Its triangles are of the cells and
/// regions beside. Those flatter than 1 : 10 are flipped away: the neighbor across the longest side
/// gets a vertex there, as a crack at a vertex on an edge wants. All other loops stay open.
void CloseHoles(SurfaceMesh& mesh, SurfaceLinks& links, const SpacingField& spacing,
  ProblemList& problems, Pulse& pulse);

/// A chain as a problem, with its figures.
Problem BorderProblem(ProblemCode code, const SurfaceMesh& mesh, const BorderChain& chain);

} // namespace biting

#endif
