// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingCoordinateRounding_h
#define BitingCoordinateRounding_h

#include "../../Kernel/Base/Ids.h"
#include "../../Kernel/Base/Pulse.h"

#include <array>  // for axes
#include <vector> // for the points

namespace biting
{

/// How far apart points may be that are meant to be one.
struct CoordinateRounding
{
  double Most = 0.0;            ///< so many units of the largest coordinate (NoiseInUlp)
  std::array<double, 3> Axes{}; ///< along each axis of space, no more than that
};

/// That of the `points` among `coordinates` (three a point, finite), in the type that they had in
/// VTK, `dataType`.
///
/// A computed point a + t (b - a) is off along an axis by u M for the sum, where u is half a unit
/// and M the largest coordinate along that axis, and by 3 u D for the rest, where D is the extent
/// of the drawing. So two of them are M + 3 D units apart at worst. M + 7 D is taken: room for
/// points that were computed from computed ones. Where D is M or more it is NoiseInUlp times the
/// largest coordinate along all axes; so it is for doubles, whose units are far below what is
/// drawn.
///
/// Floats count as floats, unless all are whole numbers. So do doubles that have been floats, as
/// after a calculator or a file: all of them are floats; of one point in eight or more they need
/// all 24 bits of one; and these are of several binary orders of magnitude. Numbers that someone
/// has chosen are not so: 0.1 is no float, whole numbers need few bits, or lie all between 2^23 and
/// 2^24, and so do multiples of any step. Where the monitor asks to stop the result has no meaning.
CoordinateRounding RoundingOfCoordinates(
  int dataType, const double* coordinates, const std::vector<Id>& points, Pulse& pulse);

} // namespace biting

#endif
