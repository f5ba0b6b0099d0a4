// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSimplification_h
#define BitingSimplification_h

#include "../Base/Ids.h"
#include "../Base/Monitor.h"
#include "../Base/Point.h"
#include "../Base/Problem.h"
#include "../Domain/Domain.h"

#include <functional> // for spacing and tags
#include <vector>     // for the arrays

namespace biting
{

/// How far the drawing may be from what is meshed, in units of the spacing f at the place.
struct SimplificationOptions
{
  double Tolerance = 0.0;       ///< 0: every vertex stays
  double CornerAngle = 45.0;    ///< degrees of turning, from which a corner stays
  double MinimumLoopSize = 0.0; ///< closed loops of smaller extent are left out; 0: none

  /// Whether two input cells carry the same tags; vertices between segments of others stay. May be
  /// empty: all do.
  std::function<bool(Id, Id)> AreAlike;

  bool IsAsked() const { return this->Tolerance > 0.0 || this->MinimumLoopSize > 0.0; }
};

/// A domain with fewer vertices, and what went.
struct SimplifiedDomain
{
  Domain Drawing;

  /// The ends of all segments of the domain, in pairs. Empty where no vertex of a chain went.
  std::vector<Point2> DrawnEnds;

  Id RemovedVertices = 0;   ///< of chains
  Id LeftOutLoops = 0;      ///< each is a problem of code SmallLoops
  double LeftOutArea = 0.0; ///< that they enclose
};

/// Removes vertices of chains: paths of segments whose inner vertices end two of them, of the same
/// kind and with the same tags. Its vertices are a part of those of `domain`, in their order; its
/// segments too, each with the cell of the first one that it stands for, and in its place. The
/// bounds are those of `domain`.
///
/// - Area: a change of more than 5 % is told.
/// - Distance: each segment and the path that it stands for are within Tolerance times f of one
///   another, both ways, f being the least along the path nearby.
/// - Topology, exactly: the result obeys the invariant of Domain. Chains are moved over no vertex,
///   so crossings, touches, nesting, faces and what lies in each are those of `domain`.
/// - What stays: ends of chains, embedded points, at least three vertices of each loop, and corners
///   that turn by CornerAngle or more, seen at some Tolerances' distance (ChainCorners.h).
/// - Corners: no angle of the inside gets sharp by it where the drawing is blunt (ChainReduction).
/// - Clearance: a path moves by at most the clearance that remains beside it. It is measured to
///   vertices, as the distance of two segments is that of an end of one of them. So a channel keeps
///   a share of its width.
///
/// Loops are left out first: closed chains without junctions whose larger extent along the axes is
/// below MinimumLoopSize times the least f on them. A loop stays if it bounds an inside in which
/// something else lies, if it bounds an outside in which something stays, or if it is the largest
/// of all.
///
/// The result does not depend on the order or direction of segments, nor on how they are joined to
/// chains of the input. Cost O(n log n), in ordinary cases. Empty where the monitor wants to stop.
/// Source of the guard: C. Dyken, M. Daehlen, T. Sevaldrud, "Simultaneous curve simplification",
/// 2009.
SimplifiedDomain Simplify(const Domain& domain, const SimplificationOptions& options,
  const std::function<double(const Point2&)>& spacing, ProblemList& problems, Monitor& monitor);

/// Adds a problem where the area of the domain changed by more than 5 % (ProblemCode::ChangedArea):
/// the tolerance is as wide as what is drawn.
void ReportChangedArea(double before, double after, ProblemList& problems);

/// As Simplify for the chains, where only f at the vertices is known: no loop is left out.
/// Precondition: Tolerance is above zero.
SimplifiedDomain SimplifyChains(const Domain& domain, const SimplificationOptions& options,
  const std::vector<double>& spacings, Monitor& monitor);

} // namespace biting

#endif
