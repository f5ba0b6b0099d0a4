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
  /// `along` and `across` from the start of the edge; f(t) is the spacing at t, as far as that is
  /// below the most. Not above the most.
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
    const auto bound = [this, along, across, length](
                         double begin, double finish, double least, double most)
    {
      const SegmentCone cone(
        { begin * length, 0.0 }, { finish * length, 0.0 }, least, most, this->Gradation);
      return cone({ along, across }, this->Gradation);
    };
    const double least = std::max(low, this->Range.Least);
    const double level = from > 0.0 ? bound(0.0, from, least, least) : this->Range.Most;
    return std::min({ this->Range.Most, level,
      bound(from, std::max(from, to), least, std::max(least, low + to * rise)) });
  }

private:
  const ValueRange Range;
  const double Gradation;
};

} // namespace biting

#endif
