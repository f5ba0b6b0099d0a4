// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingConeCollector_h
#define BitingConeCollector_h

#include "Spacing.h"
#include "ValueRange.h"

namespace biting
{

/// Collects the segments from which f may grow no faster than the gradation.
class ConeCollector
{
public:
  explicit ConeCollector(const ValueRange& range)
    : Range(range)
  {
  }

  const ValueRange& Values() const { return this->Range; }

  void AddPoint(const Point2& place, double spacing);

  /// `startSpacing` and `endSpacing` are the values of f.
  void AddSegment(const Point2& start, const Point2& end, double startSpacing, double endSpacing);

  const SegmentSource& Segments() const { return this->Source; }

private:
  ValueRange Range;
  SegmentSource Source;
};

} // namespace biting

#endif
