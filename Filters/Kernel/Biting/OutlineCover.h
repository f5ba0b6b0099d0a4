// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingOutlineCover_h
#define BitingOutlineCover_h

#include "../Base/Ids.h"
#include "../Base/Point2.h"
#include "Bites.h"

#include <array> // for the intervals

namespace biting
{

/// Tells of most bites whose outline is covered that it is, at a fraction of the cost of BiteOutline:
/// without an allocation, without the gaps.
/// Law: where IsFull, each place of the outline lies in another bite. What a square covers of a circle
/// does not count, nor more than 24 bites on one side.
class OutlineCover
{
public:
  OutlineCover(const Bites& bites, Id bite);

  void Cover(Id other);
  bool IsFull() const;

private:
  static constexpr int Most = 24;

  // What is covered of a side, from -1 to 1. A circle has one, along which the places of the four
  // sides of the square about it follow one another, counterclockwise.
  struct Side
  {
    int Count = 0;
    std::array<double, Most> Lows;
    std::array<double, Most> Highs;
  };

  void CoverBySquare(const Point2& center, const Point2& axis, double halfWidth);
  void CoverSquareByCircle(const Point2& center, double radius);
  void CoverCircleByCircle(const Point2& center, double radius);
  void Add(Side& side, double low, double high);
  bool IsFull(const Side& side) const;

  const Bites& All;
  Id Bite;
  Point2 Axis;
  double PerHalfWidth;
  std::array<Side, 4> Sides;
};

} // namespace biting

#endif
