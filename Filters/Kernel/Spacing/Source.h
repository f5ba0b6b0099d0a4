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

/// Which cells count as steep, and the part of the plane that matters.
struct SteepRule
{
  double Slope;     ///< larger slopes are steep; infinite: none is
  ValueRange Range; ///< of the spacing
  Box2 Bounds;      ///< where f is asked for
};

/// A spacing that is given on cells: a grid, triangles. To add a kind of source, derive from this.
class Source
{
public:
  virtual ~Source() = default;

  /// The value given at x; outside of the cells, that of the nearest place of their border. Called
  /// from any number of threads at once.
  virtual double operator()(const Point2& x) const = 0;

  /// Returns the largest slope of a cell, without the scale. Adds the places from which the
  /// spacing, scaled and clamped, grows by more than the rule's slope: the edges of steep cells,
  /// and points where values jump. For g-Lipschitz f the largest function below is then
  /// min(given(x), min over these y of given(y) + g |x - y|): in a cell that is steeper than g the
  /// minimum lies on an edge. An edge may be left out where others give the same bound.
  virtual double AddLowEdges(const SteepRule& rule, SegmentSource& edges, Pulse& pulse) const = 0;
};

/// A node of a cell.
struct CellNode
{
  Point2 At;
  double Scaled = 0.0; ///< the value, not clamped
  double Value = 0.0;  ///< the spacing
};

/// The distance of points that replace a line, in f: length * min(1, .3 / min(slope, 1)). Between
/// points d f apart f is too large by a share of up to slope * d / 2: for slopes from .3 to 1 the
/// distance keeps that at .15 length.
double DistanceOfPoints(double length, double slope);

/// Adds the parts of an edge between two nodes of a steep cell which its ends do not stand for:
/// - the part where values are clamped to the least, as a segment;
/// - the part above, up to the most, if it is no steeper than the slope and longer than
///   DistanceOfPoints(1/4, slope) f. The caller adds the ends.
void AddLowEdge(CellNode low, CellNode high, const SteepRule& rule, SegmentSource& edges);

/// Adds the level line of the least value in a steep cell: beyond it values are clamped. `nodes` go
/// around the cell.
void AddLevelLine(
  const std::vector<CellNode>& nodes, const ValueRange& range, SegmentSource& edges);

} // namespace biting

#endif
