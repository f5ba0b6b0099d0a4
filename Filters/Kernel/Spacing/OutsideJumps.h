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
/// all directions between at corners, each to where its foot ceases to be the nearest point; where
/// the line through the ends of two rays is not straight, there are more between them. Where gaps
/// are far narrower than f, it grows from the border itself. Lines go on past the bounds. What is
/// narrower than the first rays are apart, and seen by none of them, may be missed.
/// Where triangles lie on others, it jumps along the edges of the lower ones.
/// False if the monitor asks to stop. Cost: some five searches of the border for each ray.
bool AddOutsideJumps(const TriangleInterpolator& field, const Box2& bounds, double gradation,
  ConeCollector& cones, Monitor& monitor);

} // namespace biting

#endif
