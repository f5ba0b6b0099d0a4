// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingMeetings_h
#define BitingMeetings_h

#include "../Base/Ids.h"
#include "../Base/Point.h"
#include "../Base/Problem.h"
#include "../Base/Pulse.h"
#include "Arrangement.h"

#include <cstddef> // for size_t
#include <vector>  // for the lists

namespace biting
{

/// An edge, and a vertex on it that splits it.
struct EdgeSplit
{
  Id Edge = NoId;
  Id Vertex = NoId;
};

/// Two edges that cross in their interiors, away from all their ends; First < Second.
struct EdgeCrossing
{
  Id First = NoId;
  Id Second = NoId;
};

/// What the user is told: two edges that cross or overlap, or a boundary that touches another, or
/// one that lies so near to another that it counts as on it.
struct MeetingReport
{
  ProblemCode Code = ProblemCode::Crossings;
  Id First = NoId;
  Id Second = NoId;
  Id Vertex = NoId; ///< of Second, on First, or where an overlap begins or ends; not of crossings
};

/// All places where edges meet other than at common ends; sorted, each once.
struct Meetings
{
  std::vector<EdgeSplit> Splits;
  std::vector<EdgeCrossing> Crossings;
  std::vector<MeetingReport> Reports;
  bool AreTooMany = false; ///< the search was given up

  bool IsEmpty() const { return this->Splits.empty() && this->Crossings.empty(); }
};

/// Finds the meetings of which at least one edge is new; gives up where there are more crossings
/// than `most`, or more splits than a million and 50 for each edge. False: the monitor has asked to
/// stop.
///
/// A vertex lies on an edge where it does so exactly, or where it lies within Resolution of the
/// edge and sees its ends under an obtuse angle. The angle makes both parts shorter than the edge,
/// so that splitting comes to an end. With KeepsSpikes, a vertex that an edge joins to an end of
/// the edge beside it, where nothing else ends, must lie on it exactly: these are the sides of a
/// spike, which stays open however thin; but not where each bounds a face of its own. Edges that
/// share a vertex can only overlap: each is tested against its neighbours in the order of
/// directions around that vertex, as far as these are that near. Others are found by the tree.
bool FindMeetings(
  const Arrangement& arrangement, std::size_t most, Meetings& meetings, Pulse& pulse);

} // namespace biting

#endif
