// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingPointWelding_h
#define BitingPointWelding_h

#include "../Base/Ids.h"
#include "../Base/Point.h"
#include "../Base/Problem.h"
#include "../Base/Pulse.h"
#include "Polylines.h"

#include <vector> // for the arrays

namespace biting
{

/// Distinct vertices, and which of them each point of the input is.
struct WeldedPoints
{
  std::vector<Point2> Vertices;
  std::vector<Id> VertexPoints; ///< first input point at each vertex
  std::vector<Id> VertexOf;     ///< of a point; NoId: no chain uses it
  double Rounding = 0.0;        ///< of a vertex
  double Resolution = 0.0;      ///< what is not further apart is one; at least Rounding
  Point2 Stretch{ 1.0, 1.0 };   ///< by which differences along x and y count, for Resolution
};

/// The place of an input point; coordinates too small for exact predicates are zero.
Point2 PlaceOf(const Polylines& input, Id point);

/// Makes one vertex of points that are equal, or nearer to each other than the resolution or the
/// noise of seams, which `problems` then tells. Vertices are numbered by their places. Those of
/// boundaries keep theirs, then those of interfaces, then open ends. No two vertices are within
/// that of each other, and each point is within it of its vertex. Without meaning where the monitor
/// wants to stop. Cost O(n log n).
WeldedPoints WeldPoints(
  const Polylines& input, double mergeTolerance, ProblemList& problems, Pulse& pulse);

} // namespace biting

#endif
