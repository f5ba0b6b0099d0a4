// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingOutsideJumps_h
#define BitingOutsideJumps_h

#include "ConeCollector.h"
#include "TriangleInterpolator.h"

#include <functional> // for what is not needed

namespace biting
{

/// Adds to `cones` what makes a triangulated source Lipschitz outside of its triangles, within
/// `bounds`. There it has the value of the nearest point of its border. So it is as steep before a
/// border edge as along it: f grows from the perpendicular at the lower end. And it jumps where two
/// parts of the border are equally near, in holes and before borders that are not convex: there f
/// grows from the lower side. These places are where perpendiculars to border edges end: where
/// their foot ceases to be the nearest point. Before corners of the border a quadtree finds them,
/// from squares of 1/64 of the bounds down to a hundredth of f / g; where a corner stands in a bay
/// smaller than that, a jump may be missed; and they are larger in boxes that are unused
/// (SpacingOptions::IsUnused). Nothing is added where the triangles cover the bounds.
/// False if the monitor asks to stop. Cost: some ten searches of the border for each perpendicular.
bool AddOutsideJumps(const TriangleInterpolator& field, const Box2& bounds, double gradation,
  const std::function<bool(const Box2&)>& isUnused, ConeCollector& cones, Monitor& monitor);

} // namespace biting

#endif
