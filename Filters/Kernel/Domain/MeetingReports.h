// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingMeetingReports_h
#define BitingMeetingReports_h

#include "../Base/Ids.h"
#include "Arrangement.h"
#include "Meetings.h" // for the reports

#include <vector> // for the list

namespace biting
{

/// Which of the places where edges meet the user hears of. Edges are those of the arrangement; the
/// list of reports is added to.
class MeetingReporter
{
public:
  MeetingReporter(const Arrangement& arrangement, std::vector<MeetingReport>& reports)
    : Input(arrangement)
    , Reports(reports)
  {
  }

  /// Faces share parts of edges, and lines run over faces.
  void ReportOverlap(Id first, Id second, Id vertex);

  /// Interfaces may end anywhere; only boundaries that touch are worth a word.
  void ReportTouch(Id edge, Id toucher, Id vertex);

  /// Where what may bound the domain is moved to a vertex near it, one of `other`: by more than
  /// rounding, or to one that a chain passes (`isPassed`). That an interface ends on it but for
  /// rounding, or a point lies on it, is no news.
  void ReportNear(Id edge, Id other, Id vertex, bool isPassed);

  /// Faces on top of each other are told of in another way (CellOverlaps.h), but not what crosses
  /// itself.
  void ReportCrossing(Id first, Id second);

private:
  bool IsNews(Id first, Id second) const;
  bool AreOfOneFace(Id first, Id second) const;
  bool IsBoundary(Id edge) const { return this->Input.Edge(edge).BoundaryCount > 0; }
  bool MayBound(Id edge) const;

  const Arrangement& Input;
  std::vector<MeetingReport>& Reports;
};

} // namespace biting

#endif
