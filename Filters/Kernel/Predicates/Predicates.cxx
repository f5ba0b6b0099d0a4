// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Predicates.h"

#include "DoubleDouble.h"
#include "Expansion.h"

#include <algorithm> // for clamp, min, max
#include <utility>   // for swap
#ifdef BITING_COUNT_PREDICATES
#include <atomic> // for counting from several threads
#endif

namespace biting
{
namespace
{

using detail::UnitRoundoff;

/// The errors of DoubleDouble's operators: 9u^2 for each of the two products, 4u^2 for their sum,
/// relative to M = |left| + |right|; with the roundings of M this stays below 14u^2 M.
constexpr double OrientWideBound = 16.0 * UnitRoundoff * UnitRoundoff;

/// A squared length and a cross product are off by 13u^2 as above, their product by
/// (13 + 13 + 9)u^2, and each of the two sums adds 4u^2: 43u^2 of the magnitude M; with the
/// roundings of M this stays below 44u^2 M.
constexpr double InCircleWideBound = 64.0 * UnitRoundoff * UnitRoundoff;

/// Scales coordinates so that products of four keep all their bits. A coordinate is a multiple of
/// 2^-285 and at most 2^233 in magnitude (LeastCoordinate, GreatestCoordinate); scaled, a product
/// of four is a multiple of 2^-1068 and the determinant is below 2^1012.
constexpr double InCircleScale = 262144.0; // 2^18

/// A vector of numbers wider than double, so that one text serves both stages.
template <class Number>
struct WideVector
{
  Number X;
  Number Y;
};

/// The vector from `origin` to p: exact in both kinds of numbers.
template <class Number>
WideVector<Number> VectorTo(const Point2& p, const Point2& origin)
{
  return { Number(TwoDifference(p.X, origin.X)), Number(TwoDifference(p.Y, origin.Y)) };
}

template <class Number>
auto WideCross(const WideVector<Number>& p, const WideVector<Number>& q)
{
  return p.X * q.Y - p.Y * q.X;
}

template <class Number>
auto SquaredLength(const WideVector<Number>& p)
{
  return p.X * p.X + p.Y * p.Y;
}

template <class Number>
auto OrientDeterminant(const Point2& a, const Point2& b, const Point2& c)
{
  return WideCross(VectorTo<Number>(a, c), VectorTo<Number>(b, c));
}

template <class Number>
auto InCircleDeterminant(const Point2& a, const Point2& b, const Point2& c, const Point2& d)
{
  const auto da = VectorTo<Number>(a, d);
  const auto db = VectorTo<Number>(b, d);
  const auto dc = VectorTo<Number>(c, d);
  return SquaredLength(da) * WideCross(db, dc) + SquaredLength(db) * WideCross(dc, da) +
    SquaredLength(dc) * WideCross(da, db);
}

using ExactDifference = Expansion<2>;

int ExactOrient2D(const Point2& a, const Point2& b, const Point2& c)
{
  detail::CountStage(detail::Stage::Exact);
  return OrientDeterminant<ExactDifference>(a, b, c).Sign();
}

int ExactInCircle(const Point2& a, const Point2& b, const Point2& c, const Point2& d)
{
  detail::CountStage(detail::Stage::Exact);
  return InCircleDeterminant<ExactDifference>(
    InCircleScale * a, InCircleScale * b, InCircleScale * c, InCircleScale * d)
    .Sign();
}

bool IsSame(const DoubleDouble& a, const DoubleDouble& b)
{
  return a.High == b.High && a.Low == b.Low;
}

/// Whether q is the mirror image of p, and s that of r, at one line along an axis: exactly, as
/// differences are. Then one circle goes through the four.
bool AreMirrored(const Point2& p, const Point2& q, const Point2& r, const Point2& s)
{
  return (p.Y == q.Y && r.Y == s.Y && IsSame(TwoDifference(p.X, r.X), TwoDifference(s.X, q.X))) ||
    (p.X == q.X && r.X == s.X && IsSame(TwoDifference(p.Y, r.Y), TwoDifference(s.Y, q.Y)));
}

/// A segment whose ends are in order, so that results do not depend on how it was given.
struct Segment
{
  Segment(const Point2& a, const Point2& b)
    : Low(std::min(a, b))
    , High(std::max(a, b))
  {
  }

  Point2 Low;
  Point2 High;
};

bool operator<(const Segment& s, const Segment& t)
{
  return s.Low < t.Low || (s.Low == t.Low && s.High < t.High);
}

/// Two segments of one line: along it, the order of points is the lexicographic one.
Meeting MeetOnLine(const Segment& s, const Segment& t)
{
  const Point2 begin = std::max(s.Low, t.Low);
  const Point2 end = std::min(s.High, t.High);
  if (begin == end)
  {
    return Meeting::Endpoint;
  }
  return begin < end ? Meeting::Overlap : Meeting::None;
}

bool IsBetween(double value, double bound, double otherBound)
{
  return std::min(bound, otherBound) <= value && value <= std::max(bound, otherBound);
}

/// `value` moved into the intervals of both pairs, which have a point in common.
double ClampToBoth(double value, double a, double b, double c, double d)
{
  const double low = std::max(std::min(a, b), std::min(c, d));
  const double high = std::min(std::max(a, b), std::max(c, d));
  return std::clamp(value, low, high) + 0.0; // +0.0 makes of a negative zero a positive one
}

/// start + (numerator / denominator) * difference as one exact fraction, rounded only at the end.
template <class Numerator, class Denominator>
double PointOnLine(double start, const ExactDifference& difference, const Numerator& numerator,
  const Denominator& denominator)
{
  const Expansion<2> exactStart(DoubleDouble{ start, 0.0 });
  const auto sum = denominator * exactStart + numerator * difference;
  return Quotient(sum.Rounded(), denominator.Rounded());
}

/// On the line of s at the parameter (t.Low - s.Low) x t / (s x t).
Point2 LineCrossing(const Segment& s, const Segment& t)
{
  const auto alongS = VectorTo<ExactDifference>(s.High, s.Low);
  const auto alongT = VectorTo<ExactDifference>(t.High, t.Low);
  const auto numerator = WideCross(VectorTo<ExactDifference>(t.Low, s.Low), alongT);
  const auto denominator = WideCross(alongS, alongT);
  return { PointOnLine(s.Low.X, alongS.X, numerator, denominator),
    PointOnLine(s.Low.Y, alongS.Y, numerator, denominator) };
}

} // namespace

int detail::Orient2DWidened(const Point2& a, const Point2& b, const Point2& c)
{
  CountStage(Stage::Wide);
  const double left = (a.X - c.X) * (b.Y - c.Y);
  const double right = (a.Y - c.Y) * (b.X - c.X);
  if (left == 0.0 && right == 0.0) // nothing underflows in range: both products are exactly zero
  {
    return 0;
  }
  const double determinant = OrientDeterminant<DoubleDouble>(a, b, c).High;
  if (std::abs(determinant) > OrientWideBound * (std::abs(left) + std::abs(right)))
  {
    return determinant > 0.0 ? 1 : -1;
  }
  return ExactOrient2D(a, b, c);
}

int detail::InCircleWidened(
  const Point2& a, const Point2& b, const Point2& c, const Point2& d, double magnitude)
{
  CountStage(Stage::Wide);
  if (AreMirrored(a, b, c, d) || AreMirrored(a, c, b, d) || AreMirrored(a, d, b, c))
  {
    return 0; // nearly all of those that come here from rows along the sides of a square
  }
  const double determinant = InCircleDeterminant<DoubleDouble>(a, b, c, d).High;
  if (std::abs(determinant) > InCircleWideBound * magnitude + InCircleUnderflow)
  {
    return determinant > 0.0 ? 1 : -1;
  }
  return ExactInCircle(a, b, c, d);
}

Meeting Meet(const Point2& a, const Point2& b, const Point2& c, const Point2& d)
{
  const int sideOfC = Orient2D(a, b, c);
  const int sideOfD = Orient2D(a, b, d);
  if (sideOfC == 0 && sideOfD == 0)
  {
    return MeetOnLine(Segment(a, b), Segment(c, d));
  }
  if (sideOfC == sideOfD)
  {
    return Meeting::None;
  }
  const int sideOfA = Orient2D(c, d, a);
  const int sideOfB = Orient2D(c, d, b);
  if (sideOfA == sideOfB)
  {
    return Meeting::None;
  }
  // Each segment has its ends on different sides of the other's line, or one end on it.
  const bool endOfCd = sideOfC == 0 || sideOfD == 0;
  const bool endOfAb = sideOfA == 0 || sideOfB == 0;
  if (endOfAb && endOfCd)
  {
    return Meeting::Endpoint;
  }
  return endOfAb || endOfCd ? Meeting::Touch : Meeting::Crossing;
}

bool IsOnSegment(const Point2& p, const Point2& a, const Point2& b)
{
  return IsBetween(p.X, a.X, b.X) && IsBetween(p.Y, a.Y, b.Y) && Orient2D(a, b, p) == 0;
}

Point2 CrossingPoint(const Point2& a, const Point2& b, const Point2& c, const Point2& d)
{
  Segment s(a, b);
  Segment t(c, d);
  if (t < s)
  {
    std::swap(s, t);
  }
  const Point2 crossing = LineCrossing(s, t);
  return { ClampToBoth(crossing.X, a.X, b.X, c.X, d.X),
    ClampToBoth(crossing.Y, a.Y, b.Y, c.Y, d.Y) };
}

#ifdef BITING_COUNT_PREDICATES

namespace
{
std::atomic<long long> StageCalls[3];
}

void detail::CountStage(Stage stage)
{
  StageCalls[static_cast<int>(stage)].fetch_add(1, std::memory_order_relaxed);
}

PredicateCounts GetPredicateCounts()
{
  return { StageCalls[0], StageCalls[1], StageCalls[2] };
}

#else

PredicateCounts GetPredicateCounts()
{
  return {};
}

#endif

} // namespace biting
