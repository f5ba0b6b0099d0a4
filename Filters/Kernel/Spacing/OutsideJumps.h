// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingOutsideJumps_h
#define BitingOutsideJumps_h

#include "ConeCollector.h"
#include "TriangleInterpolator.h"

namespace biting
{

/// Adds to `cones` what makes a triangulated source Lipschitz outside of its triangles, within
/// `bounds`. There it has the value of the nearest point of its border. So it is as steep before a
/// border edge as along it: f grows from the perpendicular at the lower end. And it jumps where two
/// parts of the border are equally near, in holes and before borders that are not convex: there f
/// grows from the lower side. These lines are traced by rays, perpendicular to border edges and in
/// all directions between at corners, each to where its foot ceases to be the nearest point. Of two
/// rays with different edges beyond, there is one between to where both are as near: it finds what
/// else is nearer there, or tells that nothing is. Between rays with one edge beyond, the line is
/// known. Something small near a long edge may be hidden from the rays of that; but its own see the
/// edge, so lines are traced from both sides. Lines go on past the bounds.
/// Where triangles lie on others, it jumps along the edges of the lower ones.
/// False if the monitor asks to stop. Cost: some three searches of the border for each ray; some
/// rays for each two parts of the border that are equally near somewhere.
bool AddOutsideJumps(const TriangleInterpolator& field, const Box2& bounds, double gradation,
  ConeCollector& cones, Monitor& monitor);

} // namespace biting

#endif
