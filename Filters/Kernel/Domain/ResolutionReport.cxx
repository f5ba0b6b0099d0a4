// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "ResolutionReport.h"

#include "../Predicates/Predicates.h"

#include <algorithm> // for minmax
#include <cstdint>   // for counts
#include <sstream>   // for a count
#include <string>    // for to_string

namespace biting
{

ResolutionReport::ResolutionReport(const Arrangement& arrangement, ProblemList& problems)
  : Data(arrangement)
  , Problems(problems)
{
  for (const ProblemGroup& group : problems.Groups())
  {
    if (group.Code == ProblemCode::JoinedEnds)
    {
      const Problem& first = group.First.front();
      const auto cell = static_cast<Id>(first.Ids.back());
      this->RememberFirst(cell, cell, InPlane(first.Place));
    }
  }
}

void ResolutionReport::AddRound(const Meetings& found, Pulse& pulse)
{
  for (const MeetingReport& report : found.Reports)
  {
    if (this->IsFirstRound && pulse.Beat())
    {
      this->Add(report);
    }
  }
  this->IsFirstRound = false;
  this->RememberLast(found);
}

void ResolutionReport::Add(const MeetingReport& report)
{
  if (report.Code == ProblemCode::NearPoints)
  {
    this->Problems.Add(
      { report.Code, { this->Data.VertexPoints[report.Vertex], NoId }, this->Data.At(report.Vertex),
        "on a segment of cell " + std::to_string(this->Data.Edge(report.First).Cell) });
    return;
  }
  const auto [first, second] =
    std::minmax({ this->Data.Edge(report.First).Cell, this->Data.Edge(report.Second).Cell });
  const Id other =
    report.Code == ProblemCode::Touches ? this->Data.VertexPoints[report.Vertex] : second;
  constexpr auto MostKept = static_cast<std::int64_t>(ProblemList::KeptPerKind);
  const bool isKept = this->Problems.Count(report.Code) < MostKept;
  const Point2 place = isKept ? this->PlaceOf(report) : Point2();
  this->Problems.Add({ report.Code, { first, other }, place, {} });
  this->RememberFirst(first, second, place);
}

Point2 ResolutionReport::PlaceOf(const MeetingReport& report) const
{
  if (report.Vertex != NoId)
  {
    return this->Data.At(report.Vertex);
  }
  const SegmentEnds& a = this->Data.Edge(report.First).Ends;
  const SegmentEnds& b = this->Data.Edge(report.Second).Ends;
  return CrossingPoint(
    this->Data.At(a.Start), this->Data.At(a.End), this->Data.At(b.Start), this->Data.At(b.End));
}

void ResolutionReport::RememberFirst(Id firstCell, Id secondCell, const Point2& place)
{
  if (this->FirstDefect.Ids.empty())
  {
    this->FirstDefect.Ids = { firstCell, secondCell };
    this->FirstDefect.Place = place;
  }
}

/// For a refusal where the first round had nothing to report, as all was within rounding.
void ResolutionReport::RememberLast(const Meetings& found)
{
  if (!found.Crossings.empty())
  {
    const auto [first, second] = found.Crossings.front();
    this->LastDefect.Ids = { this->Data.Edge(first).Cell, this->Data.Edge(second).Cell };
    this->LastDefect.Place = this->PlaceOf({ ProblemCode::Crossings, first, second, NoId });
  }
  else if (!found.Splits.empty())
  {
    const EdgeSplit& split = found.Splits.front();
    const Id cell = this->Data.Edge(split.Edge).Cell;
    this->LastDefect.Ids = { cell, cell };
    this->LastDefect.Place = this->Data.At(split.Vertex);
  }
}

void ResolutionReport::AddEqual(const ArrangementEdge& kept, const ArrangementEdge& other)
{
  const bool areLines = kept.HasLine() && other.HasLine();
  const bool countsTwice = kept.BoundaryCount + other.BoundaryCount > 0;
  if (this->IsFirstRound && (areLines || countsTwice))
  {
    const Point2& place = this->Data.At(kept.Ends.Start);
    const auto [first, second] = std::minmax({ kept.Cell, other.Cell });
    this->Problems.Add({ ProblemCode::DuplicateSegments, { first, second }, place, {} });
    this->RememberFirst(first, second, place);
  }
}

bool ResolutionReport::Refuse(ProblemCode code)
{
  Problem problem;
  if (code != ProblemCode::Aborted)
  {
    problem = this->FirstDefect.Ids.empty() ? this->LastDefect : this->FirstDefect;
  }
  problem.Code = code;
  this->Problems.Add(problem);
  return false;
}

/// One place stands for all.
bool ResolutionReport::RefuseCrowd(const Meetings& found)
{
  std::ostringstream count;
  count.precision(2);
  count << "one of about " << found.AboutHowMany << " crossings or more";
  this->RememberLast(found);
  this->FirstDefect = this->LastDefect;
  this->FirstDefect.Detail = count.str();
  return this->Refuse(ProblemCode::NotResolved);
}

} // namespace biting
