// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingNodeBound_h
#define BitingNodeBound_h

#include "../Base/Point2.h"

namespace biting
{

/// Steps in which f may grow by more than this share of itself are wide: between the nodes around a
/// place that bounds them, linear values are too high by up to .15 of that.
constexpr double WidestGrowth = 0.12;

/// What bounds f at a node of a source: Value = Base + g |node - Place|. Single precision is more
/// than anybody sees of f.
struct NodeBound
{
  /// From the first node of the source: that is as good far from the origin.
  struct Offset
  {
    float X;
    float Y;
  };

  float Value;
  float Base;
  Offset Place;

  bool IsOfOther() const { return this->Value > this->Base; }

  /// Whether it is below what is given at the node, by more than rounding.
  bool IsBelow(double given) const { return this->Value < (1.0 - 1e-6) * given; }

  /// Whether a value at a place is above what the bound brings there, or nearly so: nothing grows
  /// from it then.
  bool Reaches(const Point2& offset, double value, double gradation) const
  {
    constexpr double NearlyAbove = 1.003;
    const Point2 place{ this->Place.X, this->Place.Y };
    return this->Base + gradation * Distance(offset, place) <= NearlyAbove * value;
  }
};

} // namespace biting

#endif
