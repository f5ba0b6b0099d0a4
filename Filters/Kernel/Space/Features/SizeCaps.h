// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSizeCaps_h
#define BitingSizeCaps_h

#include "../../Base/BoxTree.h"
#include "SurfaceGround.h"

namespace biting
{

/// Caps are at least this share of the given f.
constexpr double LeastShare = 0.25;

/// Caps f by the thickness of the walls of the surface `input`, inside and outside: the diameter of
/// the largest ball, up to f, that touches the surface at a vertex and is not entered by a wall
/// that faces it (normals opposite within 41 degrees: so faces of wedges are no walls).
/// Shrinking balls (Ma, Bae, Choi, "3D medial axis point approximation using nearest neighbors and
/// the normal field", 2012). Vertices before `firstVertex` get no ball. `inputTree`: of `input`.
void CapByThickness(SurfaceGround& ground, const SurfaceMesh& input,
  const BoxTree<SurfaceItem, 3>& inputTree, Id firstVertex, Pulse& pulse);

/// Caps f on chains by .8 d, d the distance to features to which the way along chains is longer
/// than 4 d, and by the length of the chain, of a closed chain a quarter of it.
void CapByFeatures(SurfaceGround& ground, Pulse& pulse);

/// Caps f where the surface `input` curves, and where chains do, so that a mesh of edges up to
/// 1.22 f is nearer to it than `tolerance` f: normals f apart differ by at most 4 `tolerance`
/// (radians), in input triangles of any size. 0: no cap.
void CapByCurvature(
  SurfaceGround& ground, const SurfaceMesh& input, double tolerance, Pulse& pulse);

/// Halves f where it is .45 to 1.1 LeastShare of the given one and the surface turns by more than
/// 69 degrees in the ball of a facet; edges that are features do not count. False: nowhere.
bool HalveAtTurns(SurfaceGround& ground, Pulse& pulse);

/// Lowers f until it grows by no more than `gradation` along the edges of the ground; 0: by no more
/// than 0.3 from where it is capped.
void GradeSizes(SurfaceGround& ground, double gradation, Pulse& pulse);

} // namespace biting

#endif
