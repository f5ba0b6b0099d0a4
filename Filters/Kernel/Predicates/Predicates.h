// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingPredicates_h
#define BitingPredicates_h

#include "../Base/Point.h"

namespace biting
{

/// The exact signs that decide topology. Nothing else in the kernel compares rounded geometry to
/// decide how things are connected.
///
/// Each predicate is a filter in double arithmetic with a proven error bound, which answers nearly
/// always, then a wider stage, then exact expansion arithmetic (J. R. Shewchuk, "Adaptive Precision
/// Floating-Point Arithmetic and Fast Robust Geometric Predicates", 1997).
/// Exact for coordinates that are zero or between LeastCoordinate and GreatestCoordinate in
/// magnitude; their differences may be as small as they come.
constexpr double GreatestCoordinate = 1e70;
constexpr double LeastCoordinate = 1e-70;

/// Sign of the doubled area of (a, b, c): +1 counterclockwise, -1 clockwise, 0 exactly collinear.
/// Laws: cyclic rotation of the arguments keeps the sign; exchanging two negates it.
int Orient2D(const Point2& a, const Point2& b, const Point2& c);

/// Position of d against the circle through a, b, c, which are counterclockwise:
/// +1 inside, -1 outside, 0 exactly on it.
/// Laws: cyclic rotation of (a, b, c) keeps the sign; exchanging any two of the four negates it.
int InCircle(const Point2& a, const Point2& b, const Point2& c, const Point2& d);

/// How two closed segments meet.
enum class Meeting
{
  None,     ///< no common point
  Endpoint, ///< one common point, an end of both
  Touch,    ///< one common point, an end of exactly one of them
  Crossing, ///< one common point, interior to both
  Overlap   ///< more than one common point: they share a stretch
};

/// How the segments ab and cd meet, decided exactly. Both have distinct ends.
/// Law: exchanging the segments, or the ends of one, keeps the answer.
Meeting Meet(const Point2& a, const Point2& b, const Point2& c, const Point2& d);

/// Whether p lies on the closed segment ab, decided exactly.
bool IsOnSegment(const Point2& p, const Point2& a, const Point2& b);

/// Where the lines ab and cd cross, rounded. Precondition: Meet(a, b, c, d) is Crossing.
/// The result lies in the bounding boxes of both segments.
/// Each coordinate is within one unit in its last place of the true one.
/// Law: exchanging the segments, or the ends of one, keeps the result to the last bit.
Point2 CrossingPoint(const Point2& a, const Point2& b, const Point2& c, const Point2& d);

/// Calls answered by each stage since the program began, when counting is compiled in (tests only:
/// BITING_COUNT_PREDICATES, for the whole program); otherwise zeros.
struct PredicateCounts
{
  long long Calls = 0;
  long long Widened = 0; ///< not answered by the first stage
  long long Exact = 0;   ///< needed expansions
};
PredicateCounts GetPredicateCounts();

} // namespace biting

#include "PredicateFilters.h" // for the first stages, inline

#endif
