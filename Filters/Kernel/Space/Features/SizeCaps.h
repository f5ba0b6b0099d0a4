// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSizeCaps_h
#define BitingSizeCaps_h

#include "../../Base/BoxTree.h"
#include "SurfaceGround.h"

namespace biting
{

/// Caps are at least this share of what is given.
constexpr double LeastShare = 0.25;

/// Caps f by the thickness of the walls of the surface `input`, inside and outside: the diameter of
/// the largest ball, up to f, that touches the surface at a vertex and is not entered by a wall
/// that faces it (normals opposite within 41 degrees: so faces of wedges are no walls).
/// Shrinking balls (Ma, Bae, Choi, "3D medial axis point approximation using nearest neighbors and
/// the normal field", 2012). Balls are of vertices from `firstVertex` on. `inputTree`: its.
void CapByThickness(SurfaceGround& ground, const SurfaceMesh& input,
  const BoxTree<SurfaceItem, 3>& inputTree, std::size_t firstVertex, Pulse& pulse);

/// Caps f on chains by .8 of the distance to features to which the way along chains is more than
/// four times as long, and by the length of chains.
void CapByFeatures(SurfaceGround& ground, Pulse& pulse);

/// Caps f where the surface `input` curves, and where chains do, so that a mesh of edges f is
/// nearer to it than `tolerance` f: within f the surface turns by no more than that allows, in
/// however small triangles. 0: no cap.
void CapByCurvature(
  SurfaceGround& ground, const SurfaceMesh& input, double tolerance, Pulse& pulse);

/// Lowers f until it grows by no more than `gradation` along the edges of the ground.
void GradeSizes(SurfaceGround& ground, double gradation, Pulse& pulse);

} // namespace biting

#endif
