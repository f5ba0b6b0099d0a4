// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingCutRows_h
#define BitingCutRows_h

#include "../Base/Box.h"
#include "../Spacing/Spacing.h"
#include "CutFrame.h"

#include <optional> // for the first cut

namespace biting
{

/// Of the place where a line parallel to an axis meets the other axis.
inline double Coordinate(const Point2& p, bool isVertical)
{
  return isVertical ? p.X : p.Y;
}

/// Places of cuts at which the fronts that leave them make one lattice, where f is level.
///
/// A front that leaves a straight cut makes rows of vertices parallel to it. The fronts of all cuts
/// fit each other if
/// - cuts that are parallel to the first one are straight, and pairs of rows apart: so their
///   vertices lie opposite each other;
/// - the others, across the rows, are folded: their vertices lie in the rows, one to the left and
///   one to the right in turns, by half a side. They are whole sides apart, and cuts meet them in
///   the left ones.
/// Rows are counted from the low side of the domain's box, sides along them from the low end of the
/// longest side of the boundary that is parallel to them. So that the high ones fit as well, rows
/// and sides are shorter or longer by a part of one over the width.
/// Where f is not level no lattice is to be had, and cuts are moved by less than a pair of rows.
class CutRows
{
public:
  /// Of two rows, in units of the sides of the lattice.
  static constexpr double Pair = 1.7320508075688772;

  /// `bounds`: of the domain, in the frame, as all boxes and places. `sideLength`: of the lattice,
  /// in units of f. The spacing must outlive this object.
  CutRows(const Spacing& spacing, const Box2& bounds, double sideLength, const CutFrame& frame = {})
    : CutRows(spacing, bounds, bounds, sideLength, frame)
  {
  }

  /// `sides`: of the longest sides of the boundary (CutFrame.h).
  CutRows(const Spacing& spacing, const Box2& bounds, const Box2& sides, double sideLength,
    const CutFrame& frame)
    : F(spacing)
    , Frame(frame)
    , Bounds(bounds)
    , Sides(sides)
    , SideLength(sideLength)
  {
  }

  /// The first cut decides which ones are straight.
  void AddCut(bool isVertical)
  {
    this->IsFirstVertical = this->IsFirstVertical.value_or(isVertical);
  }
  bool IsStraight(bool isVertical) const
  {
    return this->IsFirstVertical.value_or(isVertical) == isVertical;
  }

  /// The fitting place next to `place` for a cut through `part`, whose sides are cuts that fit, or
  /// infinite.
  double FittingPlace(double place, const Box2& part, bool isVertical) const;

  /// By which factor sides are longer in the part than elsewhere for their rows to fill it; 1 where
  /// f is not level.
  double StretchOf(const Box2& part) const;

private:
  Box2 Within(const Box2& part) const;
  bool IsLevel(const Box2& part) const;
  double SpacingAt(const Point2& place) const { return this->F(this->Frame.From(place)); }

  const Spacing& F;
  CutFrame Frame;
  Box2 Bounds;
  Box2 Sides;
  double SideLength;
  std::optional<bool> IsFirstVertical;
};

} // namespace biting

#endif
