// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSmallCrossings_h
#define BitingSmallCrossings_h

#include "../Surface/SurfaceCheck.h"

#include <vector> // for places

// Crossings and folds of closed surfaces that leave no doubt about what is inside, by f.
//
// Parity (an odd number of triangles on a ray) and the winding number (above 1/2) say the same of a
// place but where that number is neither 0 nor 1. Such a region is bounded by pieces of triangles
// with other numbers behind and in front of them. Along the surface these change only where
// triangles cross. So the corners of the pieces are ends of the segments where triangles cross, or
// vertices of triangles that cross nothing and have other numbers, or vertices of which all
// triangles cross others: a box around these has the region in it. No place of a box with the
// diagonal 2 s is farther than s from the surface: s <= ClearShare f as for holes.

namespace biting
{

/// Whether triangles are oriented, and as many run along each edge as against it: then they have
/// winding numbers.
bool IsBounding(const CheckedSurface& surface);

/// Places of which one or two are the ends of what is common to two triangles that are not in one
/// plane: their common vertex, and where sides of one meet the other. Sides of several triangles
/// meet a triangle at the same place, bit for bit. Of folds corners of a box.
std::vector<Point3> PlacesOfMeeting(const SurfaceMesh& mesh, const SurfaceContact& contact);

/// Without the triangles that cross or fold, and those that bound such regions, if all are in boxes
/// of diagonals up to 2 ClearShare f, one for those that hang together: there remain holes, for
/// CloseHoles. Else empty, and where a shell is not closed and orientable.
SurfaceMesh CutOutCrossings(
  const CheckedSurface& surface, const SpacingField& spacing, Pulse& pulse);

} // namespace biting

#endif
