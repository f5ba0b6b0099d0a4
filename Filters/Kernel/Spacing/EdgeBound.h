// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingEdgeBound_h
#define BitingEdgeBound_h

#include "SegmentCone.h"
#include "ValueRange.h"

#include <utility> // for swap

namespace biting
{

/// What the values along an edge of a source allow elsewhere: a SegmentCone, but of values as
/// given, linear along the edge, which become spacing by scaling and clamping.
class EdgeBound
{
public:
  /// `gradation` is positive.
  EdgeBound(const ValueRange& range, double gradation)
    : Range(range)
    , Gradation(gradation)
  {
  }

  /// min over t in [0, length] of f(t) + gradation times the distance from t to the place that lies
  /// `along` and `across` from the start of the edge; f(t) is the spacing at t. Not above
  /// the most.
  double operator()(double along, double across, double length, double start, double end) const
  {
    if (end < start)
    {
      std::swap(start, end);
      along = length - along;
    }
    const double low = this->Range.Scale * start;
    const double rise = this->Range.Scale * (end - start);
    const auto shareAt = [low, rise](double value) { return std::min((value - low) / rise, 1.0); };
    const double from = low < this->Range.Least ? shareAt(this->Range.Least) : 0.0;
    const double to = low + rise > this->Range.Most ? shareAt(this->Range.Most) : 1.0;
    const double least = this->Range(start);
    SegmentCone level;
    level.SetValues(from * length, least, 0.0, this->Gradation);
    SegmentCone rising;
    rising.Start.X = from * length;
    rising.SetValues(
      std::max(to - from, 0.0) * length, least, this->Range(end) - least, this->Gradation);
    const Point2 x{ along, across };
    const double bound = std::min(this->Range.Most, rising(x, this->Gradation));
    return from > 0.0 ? std::min(bound, level(x, this->Gradation)) : bound;
  }

private:
  const ValueRange Range;
  const double Gradation;
};

} // namespace biting

#endif
