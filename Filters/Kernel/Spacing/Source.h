// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSource_h
#define BitingSource_h

#include "../Base/Pulse.h"
#include "Spacing.h"

#include <algorithm> // for min, max

namespace biting
{

/// How values as given become spacing: scaled, then clamped.
struct ValueRange
{
  double Scale = 1.0;
  double Least = 0.0;
  double Most = 0.0;

  double operator()(double value) const
  {
    return std::min(std::max(this->Scale * value, this->Least), this->Most);
  }
};

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
};

/// A node of a cell.
struct CellNode
{
  Point2 At;
  double Scaled = 0.0; ///< the value, not clamped
  double Value = 0.0;  ///< the spacing
};

/// How far apart points that stand for all between them may be, as a share of f: where they are
/// `length` f apart f is too large by slope * length / 2, at most. Less where the slope is above
/// .3, so that the error stays the same; slopes above 1 count as 1.
double DistanceOfPoints(double length, double slope);

/// Adds an edge between two nodes of a steep cell, but for parts where points stand for all of it:
/// - the part where values are clamped to the least, as a segment;
/// - the part above, up to the most, if it is no steeper than the slope and so long that its ends
///   do not stand for it. The ends are left to the caller.
void AddLowEdge(CellNode low, CellNode high, const SteepRule& rule, SegmentSource& edges);

/// Adds the line in a steep cell where values are clamped to the least no more. `nodes` go around
/// it.
void AddLevelLine(
  const std::vector<CellNode>& nodes, const ValueRange& range, SegmentSource& edges);

} // namespace biting

#endif
