// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingLowerBound_h
#define BitingLowerBound_h

#include "SegmentExtension.h"

namespace biting
{

/// What a function is not to be below: max over the points y of segments of f(y) - g |x - y|. It is
/// the extension of the negative values, negative. The cost of a call is logarithmic near the
/// segments, and a few steps where the bound is far below what is asked for.
class LowerBound
{
public:
  /// `slope` is positive.
  LowerBound(const SegmentSource& source, double slope, Monitor& monitor = NoMonitor());

  /// The larger one of `value` and the bound at x.
  double Raise(const Point2& x, double value) const
  {
    const LowestCone known{ -value, NoId };
    return -this->Negative.Evaluate(this->Negative.Whole(), x, known, 0.0).Value;
  }

private:
  SegmentExtension Negative;
};

} // namespace biting

#endif
