// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingResolutionReport_h
#define BitingResolutionReport_h

#include "../Base/Ids.h"
#include "../Base/Point.h"
#include "../Base/Problem.h"
#include "../Base/Pulse.h"
#include "Arrangement.h"
#include "Meetings.h"

namespace biting
{

/// What the user hears of the resolution of an arrangement: what its first round finds, and why it
/// was refused.
class ResolutionReport
{
public:
  /// Ends that were joined before are among what must not be.
  ResolutionReport(const Arrangement& arrangement, ProblemList& problems);

  /// Later rounds mend what the first one has bent: no news for the user.
  void AddRound(const Meetings& found, Pulse& pulse);

  /// Two edges with the same ends. Faces share edges, and lines carry the tags of their edges: that
  /// is no news.
  void AddEqual(const ArrangementEdge& kept, const ArrangementEdge& other);

  /// Whether anything was reported that must not be where nothing is repaired.
  bool HasDefect() const { return !this->FirstDefect.Ids.empty(); }

  /// Adds why the arrangement is not resolved, with a place; returns false.
  bool Refuse(ProblemCode code);
  bool RefuseCrowd(const Meetings& found);

private:
  void Add(const MeetingReport& report);
  Point2 PlaceOf(const MeetingReport& report) const;
  void RememberFirst(Id firstCell, Id secondCell, const Point2& place);
  void RememberLast(const Meetings& found);

  const Arrangement& Data;
  ProblemList& Problems;
  bool IsFirstRound = true;
  Problem FirstDefect; ///< the cells and the place of the first report
  Problem LastDefect;  ///< of something that the last round has found
};

} // namespace biting

#endif
