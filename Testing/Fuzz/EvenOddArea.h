// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingEvenOddArea_h
#define BitingEvenOddArea_h

#include "Drawing.h"

#include <boost/multiprecision/cpp_int.hpp> // for rationals

#include <utility> // for edges
#include <vector>  // for edges

namespace biting
{

using Rational = boost::multiprecision::cpp_rational;

/// An area, and how far from it that of a correct mesh may be.
///
/// The area changes by no more than d times the length of the boundary where no point of it moves
/// further than d. Drawing::Slack is that d.
struct EvenOddArea
{
  Rational Area;
  double Tolerance = 0.0;
};

/// The area of the even-odd region of the segments that bound, each as often as it is drawn, less
/// than Blur (below) off. An even number of these segments ends at each place.
EvenOddArea MeasureEvenOddArea(const Drawing& drawing);

/// The even-odd areas of all faces, one by one, added up.
EvenOddArea SumOfFaces(const Drawing& drawing);

/// Areas that differ by less are equal: 2^-200 of that of the drawing's box.
Rational Blur(const Drawing& drawing);

/// What edges enclose that have it on their left, exactly.
Rational EnclosedArea(const std::vector<std::pair<Point2, Point2>>& edges);

} // namespace biting

#endif
