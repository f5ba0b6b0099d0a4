// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingCornerCover_h
#define BitingCornerCover_h

#include "../Base/Ids.h"
#include "../Base/Point.h"
#include "Bites.h"

#include <array> // for triangles

// Whether nothing is left over of a triangle, by what is about its corners alone.

namespace biting
{

/// Whether each place of the triangle is within `distance` of one of its corners.
bool IsWithinOfCorners(const std::array<Point2, 3>& corners, double distance);

/// Whether these bites, centred at the corners of the triangle, cover it. Where it says no they may
/// do so all the same.
bool CoverTriangle(const Bites& bites, const std::array<Id, 3>& atCorners);

} // namespace biting

#endif
