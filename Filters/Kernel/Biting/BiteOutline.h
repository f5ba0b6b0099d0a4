// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingBiteOutline_h
#define BitingBiteOutline_h

#include "../Base/Box.h"
#include "../Base/Ids.h"
#include "../Base/Point.h"
#include "Bites.h"

#include <array>   // for the sides
#include <cmath>   // for abs
#include <cstdint> // for direction masks
#include <vector>  // for intervals

namespace biting
{

/// The half-width with which a bite would reach a point, from its axis (Bites.h) and the point's
/// offset from its centre.
inline double GaugeOf(const Point2& axis, const Point2& offset)
{
  if (axis == Point2{})
  {
    return Length(offset);
  }
  const double along = std::abs(Dot(offset, axis));
  const double across = std::abs(Cross(axis, offset));
  return along > across ? along : across;
}

/// The same of bite `bite`.
inline double Gauge(const Bites& bites, Id bite, const Point2& p)
{
  return GaugeOf(bites.Axes[bite], p - bites.Centers[bite]);
}

/// How deep p lies in bite `bite`: its distance to the nearest side, negative outside.
inline double Depth(const Bites& bites, Id bite, const Point2& p)
{
  return bites.HalfWidths[bite] - Gauge(bites, bite, p);
}

/// Whether the sides of the bite are parallel to the axes of the plane.
inline bool IsAxisAligned(const Bites& bites, Id bite)
{
  return bites.Axes[bite].Y == 0.0;
}

/// The part of a bite's outline that no other bite covers: where the front runs along this bite.
///
/// Works in the frame of the bite: centre at the origin, axis along x. Side k has the outward
/// normal at 90 k degrees; a place on it is its coordinate along the side, from -half-width to
/// half-width, growing with y on sides 0 and 2 and with x on sides 1 and 3. A circle is told by the
/// square about it: a place on that is the place on the circle in the same direction.
/// Other bites cover their open interior: of two sides that coincide neither covers the other, so
/// no vertex of the front is lost to a tie (rounding is antisymmetric here: it cannot let both
/// cover).
class BiteOutline
{
public:
  struct Interval
  {
    double Low;
    double High;
  };

  /// Begins the outline of `bite`: nothing covered.
  void Begin(const Bites& bites, Id bite);

  /// Takes away what `other` covers.
  void Cover(const Bites& bites, Id other);

  /// Finds the gaps of all sides, to be called after the last Cover.
  void Finish();

  /// Whether all gaps lie outside of `box`, and so would those that more bites leave. After Finish.
  bool IsHiddenWithin(const Box2& box) const;

  /// The part of a gap within `box`, and a margin for rounding; it ends before it starts where
  /// there is none.
  Interval PartWithin(int side, const Interval& gap, const Box2& box) const;

  /// The uncovered intervals of side 0..3, ascending.
  const std::vector<Interval>& Gaps(int side) const { return this->Uncovered[side]; }

  /// A place on a side, in the plane.
  Point2 At(int side, double place) const;

  /// Calls visit(point) for the ends of all gaps: the vertices of the front on this bite. A corner
  /// that two gaps share comes once; a circle has no corners.
  template <typename Visit>
  void VisitEnds(Visit&& visit) const;

private:
  Interval ArcWithin(int side, const Interval& gap, const Box2& box) const;
  void CoverBySquare(const Point2& center, const Point2& axis, double halfWidth);
  void CoverByCircle(const Point2& center, double radius);
  void CoverSquareByCircle(const Point2& center, double radius);
  void CoverCircleBySquare(const Point2& center, const Point2& axis, double halfWidth);
  void CoverCircleByCircle(const Point2& center, double radius);
  void CoverAll();
  void AddArc(const Point2& first, const Point2& last);
  void CoverAligned(const Point2& center, double halfWidth);
  void CoverTurned(const Point2& center, const Point2& axis, double halfWidth);
  void Add(int side, double low, double high);
  void FindGaps(int side);

  Point2 Center;
  Point2 Axis;
  double HalfWidth = 0.0;
  bool IsCircle = false;
  std::array<std::vector<Interval>, 4> Covered;
  std::array<std::vector<Interval>, 4> Uncovered;
};

template <typename Visit>
void BiteOutline::VisitEnds(Visit&& visit) const
{
  std::array<bool, 4> corners{}; // 0: (+,+), 1: (-,+), 2: (-,-), 3: (+,-)
  constexpr int LowCorner[4] = { 3, 1, 2, 2 };
  constexpr int HighCorner[4] = { 0, 0, 1, 3 };
  for (int side = 0; side < 4; ++side)
  {
    for (const Interval& gap : this->Uncovered[side])
    {
      if (gap.Low > -this->HalfWidth)
      {
        visit(this->At(side, gap.Low));
      }
      if (gap.High < this->HalfWidth)
      {
        visit(this->At(side, gap.High));
      }
      corners[LowCorner[side]] |= gap.Low <= -this->HalfWidth;
      corners[HighCorner[side]] |= gap.High >= this->HalfWidth;
    }
  }
  for (int corner = 0; corner < 4; ++corner)
  {
    if (!this->IsCircle && corners[corner])
    {
      const bool isRight = corner == 0 || corner == 3;
      visit(this->At(isRight ? 0 : 2, corner < 2 ? this->HalfWidth : -this->HalfWidth));
    }
  }
}

/// The directions in which p's near surroundings are covered, as a set of probes: probe i points at
/// (i + 1/2) 360/64 degrees, so that none is parallel to an axis.
/// A bite with p on its side (within a slack) covers a half plane of directions, with p at its
/// corner a quadrant, with p on its circle a half plane. An uncovered wedge below 5.6 degrees may
/// be missed; any uncovered region has a wider one (the angles of a polygon with n corners add up
/// to (n - 2) 180 degrees).
class DirectionMask
{
public:
  /// Adds what bite `bite` covers around p.
  void Add(const Bites& bites, Id bite, const Point2& p, double slack);

  bool IsFull() const { return this->Covered == ~std::uint64_t{ 0 }; }

private:
  void AddCircle(const Point2& offset, double depth, double slack);

  std::uint64_t Covered = 0;
};

} // namespace biting

#endif
