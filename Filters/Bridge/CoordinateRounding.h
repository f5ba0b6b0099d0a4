// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingCoordinateRounding_h
#define BitingCoordinateRounding_h

#include "../Kernel/Base/Ids.h"
#include "../Kernel/Base/Pulse.h"

#include <vector> // for the points

namespace biting
{

/// How far apart the `points` among `coordinates` (three a point, finite) may be that are meant to
/// be one: so many units in the last place of their largest coordinate (NoiseInUlp), in the type
/// that they had in VTK, `dataType`.
///
/// Floats count as floats. So do doubles that have been floats, as after a calculator or a file:
/// all of them are floats; of one point in eight or more they need all 24 bits of one; and these
/// are of several binary orders of magnitude. Numbers that someone has chosen are not so: 0.1 is no
/// float, whole numbers need few bits, or lie all between 2^23 and 2^24, and so do multiples of any
/// step. Where the monitor asks to stop the result has no meaning.
double RoundingOfCoordinates(
  int dataType, const double* coordinates, const std::vector<Id>& points, Pulse& pulse);

} // namespace biting

#endif
