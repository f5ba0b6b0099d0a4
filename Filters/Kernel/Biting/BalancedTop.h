// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingBalancedTop_h
#define BitingBalancedTop_h

#include "../Base/Point.h"
#include "ReachFactor.h" // for the triangle

namespace biting
{

/// Where the top of the triangle makes each of its two new edges as long as the mean of f at its
/// ends, times `lengthPerSpacing`; on the side of the bond where Top is. Top itself where no place
/// does, or one nearer to it than a thousandth of an edge: sides of bites that are in line stay so
/// exactly.
///
/// A bisector point is as far from one bite as from the other. In a spacing that changes along the
/// bond that makes one edge too long and the other too short, and the lattice breaks up into pieces
/// that do not fit: balanced, it bends with the spacing instead, and keeps six triangles at nearly
/// all vertices.
/// Laws: the same in all units, places and directions; mirrored where Left and Right are exchanged;
/// where f is level, on the bisector.
Point2 BalancedTop(const BiteTriangle& triangle, double lengthPerSpacing);

} // namespace biting

#endif
