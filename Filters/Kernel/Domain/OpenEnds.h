// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingOpenEnds_h
#define BitingOpenEnds_h

#include "../Base/Ids.h"
#include "../Base/Problem.h"
#include "../Base/Pulse.h"
#include "Domain.h" // for DomainOptions
#include "PointWelding.h"
#include "Polylines.h"

#include <vector> // for the list

namespace biting
{

/// The spacing that is given, but none larger than the drawing; 0 where none is given.
class SpacingAtEnds
{
public:
  SpacingAtEnds(const DomainOptions& options, const std::vector<Point2>& vertices);
  double operator()(const Point2& place) const;

private:
  const DomainOptions& Options;
  double Largest = 0.0;
};

/// A vertex that divides the segment which begins at a place of Polylines::Connectivity.
struct SegmentFoot
{
  Id Place = NoId;
  double Along = 0.0; ///< share of the segment before it, as the chain goes
  Id Vertex = NoId;
};

/// Joins open ends with what they nearly touch. An open end is a vertex at which one segment ends.
/// Its reach is EndTolerance times the given spacing there, or the resolution where that is more.
///
/// - Ends within reach of each other become one vertex, at the place of the first of them.
/// - Ends within reach of a segment move onto it: to its nearest point, or to a vertex so near to
///   that point that an edge between the two would be shorter than a hundredth of the spacing.
///   Where ends lie on two sides of a segment they meet on it.
/// - What an end hangs on within its reach is nothing to join it with: it would close on itself.
/// - What ends are joined with stays where it is. No end moves further than twice its reach.
/// - An end that lies on a segment but for the rounding of vertices stays.
///
/// Each end that moves is a problem of kind JoinedEnds, those that move most first. Vertices are
/// then numbered by their places again. Returns the vertices that divide segments, along these.
/// Neither the order of points and chains matters nor directions. Cost O(n) where no end is open,
/// else O(n log n).
std::vector<SegmentFoot> JoinOpenEnds(const Polylines& input, const DomainOptions& options,
  WeldedPoints& points, ProblemList& problems, Pulse& pulse);

} // namespace biting

#endif
