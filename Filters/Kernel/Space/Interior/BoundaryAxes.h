// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingBoundaryAxes_h
#define BitingBoundaryAxes_h

#include "InteriorBites.h"

namespace biting
{

/// Axes of cubes at the vertices of a boundary, in front of them those of the world. Where all
/// facets of a vertex are within 10 degrees of one plane, its normal is an axis; where there are
/// two such planes or more, as at feature lines, that of the second is another one, as far as it is
/// at right angles to the first. Else they are those of the world.
std::vector<CubeAxes> AxesOfBoundary(const BodyBoundary& boundary);

} // namespace biting

#endif
