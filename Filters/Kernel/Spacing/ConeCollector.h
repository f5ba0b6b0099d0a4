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

  /// Or a point, where the ends are equal. `startSpacing` and `endSpacing` are the values of f.
  void AddSegment(const Point2& start, const Point2& end, double startSpacing, double endSpacing)
  {
    const auto point = static_cast<Id>(this->Source.Points.size());
    this->Source.Points.insert(this->Source.Points.end(), { start, end });
    this->Source.Values.insert(this->Source.Values.end(), { startSpacing, endSpacing });
    this->Source.Segments.insert(this->Source.Segments.end(), { point, point + 1 });
  }

  const SegmentSource& Segments() const { return this->Source; }

private:
  ValueRange Range;
  SegmentSource Source;
};

} // namespace biting

#endif
