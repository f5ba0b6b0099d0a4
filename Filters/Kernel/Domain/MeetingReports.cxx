// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "MeetingReports.h"

#include "../Predicates/Predicates.h"

#include <cmath> // for abs

namespace biting
{

void MeetingReporter::ReportOverlap(Id first, Id second, Id vertex)
{
  if (this->IsNews(first, second))
  {
    this->Reports.push_back({ ProblemCode::DuplicateSegments, first, second, vertex });
  }
}

void MeetingReporter::ReportTouch(Id edge, Id toucher, Id vertex)
{
  if (this->IsBoundary(edge) && this->IsBoundary(toucher))
  {
    this->Reports.push_back({ ProblemCode::Touches, edge, toucher, vertex });
  }
}

void MeetingReporter::ReportNear(Id edge, Id other, Id vertex, bool isPassed)
{
  const SegmentEnds& ends = this->Input.Edge(edge).Ends;
  const Point2& start = this->Input.At(ends.Start);
  const Point2& end = this->Input.At(ends.End);
  const Point2& p = this->Input.At(vertex);
  const bool isRounding =
    std::abs(Cross(end - start, p - start)) <= this->Input.Rounding * Distance(start, end);
  const bool isMoved = !isRounding || (isPassed && this->MayBound(other));
  if (this->MayBound(edge) && isMoved && !IsOnSegment(p, start, end))
  {
    this->Reports.push_back({ ProblemCode::NearPoints, edge, other, vertex });
  }
}

void MeetingReporter::ReportCrossing(Id first, Id second)
{
  if (this->IsNews(first, second) || this->AreOfOneFace(first, second))
  {
    this->Reports.push_back({ ProblemCode::Crossings, first, second, NoId });
  }
}

bool MeetingReporter::IsNews(Id first, Id second) const
{
  const bool isOfLines = this->Input.Edge(first).HasLine() && this->Input.Edge(second).HasLine();
  return isOfLines || this->IsBoundary(first) || this->IsBoundary(second);
}

bool MeetingReporter::AreOfOneFace(Id first, Id second) const
{
  const Id face = this->Input.Edge(first).Faces.First();
  return face != NoId && face == this->Input.Edge(second).Faces.First();
}

bool MeetingReporter::MayBound(Id edge) const
{
  return this->IsBoundary(edge) || this->Input.Edge(edge).OpenCount > 0;
}

} // namespace biting
