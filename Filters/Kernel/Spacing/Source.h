// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSource_h
#define BitingSource_h

#include "../Base/Pulse.h"
#include "Spacing.h"
#include "ValueRange.h"

namespace biting
{

/// Where the spacing is too steep, and what is looked at.
struct SteepRule
{
  double Slope;     ///< greater ones are steep; infinite: none is
  ValueRange Range; ///< of the spacing
  Box2 Bounds;      ///< where f is asked for
};

/// A spacing that is given on cells: a grid, triangles. To add a kind of source, derive from this.
class Source
{
public:
  virtual ~Source() = default;

  /// What is given at x; outside of the cells the value of the nearest border. Called from any
  /// number of threads at once.
  virtual double operator()(const Point2& x) const = 0;

  /// Returns the largest slope of a cell, without the scale. Adds the places from which the
  /// spacing, scaled and clamped, grows by more than the rule's slope: the edges of steep cells,
  /// and points where values jump. For g-Lipschitz f the largest function below is then
  /// min(given(x), min over these y of given(y) + g |x - y|): in a cell that is steeper than g the
  /// minimum lies on an edge. Edges may be left out where others stand for them.
  virtual double AddLowEdges(const SteepRule& rule, SegmentSource& edges, Pulse& pulse) const = 0;

protected:
  Source() = default;
  Source(const Source&) = default;
  Source(Source&&) noexcept = default;
  Source& operator=(const Source&) = default;
  Source& operator=(Source&&) noexcept = default;
};

/// A place and the spacing there.
struct LowPlace
{
  Point2 At;
  double Value = 0.0;
};

/// Whether the edge from a to b of a steep cell is listed as a segment: where it is no steeper than
/// the slope and so long that its ends do not stand for it. Halfway between these f would be too
/// large by slope * length / 2, at most 4 % for a slope of .3.
inline bool IsLowEdge(const LowPlace& a, const LowPlace& b, double slope)
{
  constexpr double LengthOfPoint = 0.25;
  const double length = Distance(a.At, b.At);
  return length > LengthOfPoint * std::min(a.Value, b.Value) &&
    std::abs(b.Value - a.Value) <= slope * length;
}

} // namespace biting

#endif
