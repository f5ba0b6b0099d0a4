// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSurfaceHoles_h
#define BitingSurfaceHoles_h

#include "../../Base/Problem.h"
#include "../../Base/Pulse.h"
#include "SurfaceLinks.h"
#include "SurfaceWelding.h"

// Holes and slits that leave no doubt about what is inside, by f.
//
// A slit of half width s takes the share atan(s / z) / pi from the winding number at the distance z
// in front of it: more than a quarter where z < s, which is nearer than sqrt(2) s to its borders. A
// round hole of radius s does so nearer than 1.16 s. So where no place of a hole is farther from
// its border than f / (4 sqrt(2)), the winding number is clear (not between 1/4 and 3/4) at all
// places that are f / 4 from the surface, and any narrow patch has the same inside.

namespace biting
{

/// Of f: how far a place of a hole may be from its border.
constexpr double ClearShare = 0.17677669529663687; // 1 / (4 sqrt(2))

/// Closes loops of open edges (BorderChains) by triangles, told as ClosedHoles: those of at most
/// 10000 edges, of which no middle of a triangle or new edge is farther than `reach` there from the
/// loop, where the patch has less than half of the area of the parts that it closes. Two loops that
/// border one slit, of at most a million pairs of edges, are closed together, until 10^8 pairs were
/// compared in all. The triangulation has the least sum of area + length^2 / 1000 over triangles
/// and their sides; loops above 100 edges are divided before, at short edges. Its triangles have
/// cells and regions of triangles beside. Those lower than a tenth of their longest side are
/// flipped into the neighbor there, if they lie near its plane. All other loops stay open.
void CloseHoles(SurfaceMesh& mesh, SurfaceLinks& links, const SpacingField& reach,
  ProblemList& problems, Pulse& pulse);

/// A chain as a problem, with its figures.
Problem BorderProblem(ProblemCode code, const SurfaceMesh& mesh, const BorderChain& chain);

} // namespace biting

#endif
