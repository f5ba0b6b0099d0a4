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

/// The coordinate that is the same along a line: x of a vertical one, y of a horizontal one.
inline double Coordinate(const Point2& p, bool isVertical)
{
  return isVertical ? p.X : p.Y;
}

/// Places of cuts at which the fronts that leave them make one lattice, where f is level.
///
/// A front that leaves a straight cut makes rows of vertices parallel to it. The fronts of all cuts
/// fit each other if
/// - cuts parallel to the first one are straight, a whole number of pairs of rows apart: their
///   vertices lie opposite each other;
/// - cuts across the rows are folded: their vertices lie in the rows, alternately half a side to
///   the left and to the right. They are a whole number of sides apart, and straight cuts meet them
///   in left vertices.
/// Rows are counted from the low side of the domain's box, sides along them from the low end of the
/// longest parallel side of the boundary. With w the width, p the wanted pair (or side), the step
/// is w / round(w / p): so the high side of the domain fits, too. Where f is not level there is no
/// lattice; a cut is moved by less than a pair of rows all the same.
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

  /// The place nearest to `place` where a cut through `part` fits. Precondition: sides of `part`
  /// are cuts that fit, or infinite.
  double FittingPlace(double place, const Box2& part, bool isVertical) const;

  /// The factor by which sides in the part are longer than elsewhere, so that pairs of rows fill
  /// the part; 1 where f is not level.
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
