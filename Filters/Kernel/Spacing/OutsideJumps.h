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
/// grows from the lower side. These places are where perpendiculars to border edges end: where
/// their foot ceases to be the nearest point; before corners of the border JumpSquares finds them,
/// but where a corner stands in a bay smaller than its first squares, a jump may be missed. Nothing
/// is added where the triangles cover the bounds.
/// False if the monitor asks to stop. Cost: some ten searches of the border for each perpendicular.
bool AddOutsideJumps(const TriangleInterpolator& field, const Box2& bounds, double gradation,
  ConeCollector& cones, Monitor& monitor);

} // namespace biting

#endif
