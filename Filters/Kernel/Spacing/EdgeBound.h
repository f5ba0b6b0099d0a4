// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingEdgeBound_h
#define BitingEdgeBound_h

#include "ValueRange.h"

#include <cmath>   // for sqrt
#include <utility> // for swap

namespace biting
{

/// What the values along an edge of a source allow elsewhere: as SegmentCone, but of values as
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
  /// `along` and `across` from the start of the edge; f(t) is the spacing at t.
  double operator()(double along, double across, double length, double start, double end) const
  {
    if (end < start)
    {
      std::swap(start, end);
      along = length - along;
    }
    const double low = this->Range.Scale * start;
    const double rise = this->Range.Scale * (end - start);
    double from = 0.0;
    double value = low;
    double bound = this->Range.Most;
    if (low < this->Range.Least)
    {
      value = this->Range.Least;
      from = value - low < rise ? length * ((value - low) / rise) : length;
      bound = value + this->Gradation * Away(along, across, 0.0, from);
    }
    const double slope = rise / length;
    const double steepness = slope / this->Gradation;
    if (!(steepness < 1.0))
    {
      return std::min(bound, value + this->Gradation * Away(along, across, from, from));
    }
    // Values above the most are no bound; the edge ends where they begin.
    const double to =
      low + rise > this->Range.Most ? length * ((this->Range.Most - low) / rise) : length;
    const double lean = steepness / std::sqrt((1.0 - steepness) * (1.0 + steepness));
    const double foot = std::min(std::max(along - std::abs(across) * lean, from), to);
    return std::min(
      bound, value + slope * (foot - from) + this->Gradation * Away(along, across, foot, foot));
  }

private:
  static double Away(double along, double across, double from, double to)
  {
    const double ahead = std::max(std::max(from - along, along - to), 0.0);
    return std::sqrt(ahead * ahead + across * across);
  }

  const ValueRange Range;
  const double Gradation;
};

} // namespace biting

#endif
