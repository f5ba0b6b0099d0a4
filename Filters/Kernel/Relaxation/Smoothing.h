// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSmoothing_h
#define BitingSmoothing_h

#include "../Base/Ids.h"
#include "../Base/Pulse.h"
#include "DelaunayMesh.h"

namespace biting
{

/// Moves the vertex by a Newton step towards the least energy of the triangles around it: the sum
/// of 9 r^4 + 3 (a + 1/a). r is the inverse of the mean ratio, (sum of squared sides) / (4 sqrt(3)
/// area), 1 for an equilateral triangle; a is the area in units of that of the equilateral
/// triangle whose side is the mean spacing of the corners.
/// The step is 1.3 times Newton's: swept over all vertices it then spreads faster. It is halved,
/// then given up, where it would leave a triangle that is both worse than the worst around the
/// vertex before, and has an angle below 30 degrees. A vertex on a segment slides no farther than
/// its parts allow (ShareOfSlide). Where it moves, its spacing is an estimate, and edges flip.
void SmoothVertex(DelaunayMesh& mesh, Id vertex);

/// Which vertices a sweep passes over.
enum class SweepKind
{
  All,   ///< over none
  Coarse ///< over vertices with all angles above 52 degrees and lengths within 10 % of the spacing
};

/// Smooths all vertices once, as SmoothVertex does, but with flips after the sweep. A coarse sweep
/// needs a mesh that is Delaunay: it looks for flips where vertices moved.
void SmoothAll(DelaunayMesh& mesh, SweepKind kind, Pulse& pulse);

/// Smoothing leaves a star within these limits alone. It makes no star beyond them worse.
struct SmoothingLimits
{
  double GreatestCotangent; ///< of the smallest angle of a triangle
  double ShortestEdge;      ///< in spacings
  double LongestEdge;       ///< in spacings
};

/// Smooths all vertices once within `limits`: no step makes an angle beyond the limit worse, or an
/// edge farther beyond the limits of lengths. Lengths are in units of estimates of f.
void SmoothWithin(DelaunayMesh& mesh, const SmoothingLimits& limits, Pulse& pulse);

} // namespace biting

#endif
