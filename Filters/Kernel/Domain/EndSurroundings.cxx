// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "EndSurroundings.h"

#include <algorithm> // for max, min
#include <utility>   // for move

namespace biting
{

std::vector<ChainSegment> SegmentsOf(
  const Polylines& input, const WeldedPoints& points, Pulse& pulse)
{
  std::vector<ChainSegment> segments;
  const auto vertexAt = [&input, &points](Id place)
  { return points.VertexOf[input.Connectivity[place]]; };
  for (std::size_t chain = 0; chain < input.Kinds.size(); ++chain)
  {
    const bool isLine = input.Kinds[chain] != ChainKind::EmbeddedPoint;
    const Id end = isLine ? input.Offsets[chain + 1] : 0;
    for (Id place = input.Offsets[chain]; place + 1 < end && pulse.Beat(1); ++place)
    {
      const auto [low, high] = std::minmax({ vertexAt(place), vertexAt(place + 1) });
      if (low != high)
      {
        segments.push_back({ { low, high }, place, input.Cells[chain], vertexAt(place) == high });
      }
    }
  }
  return segments;
}

std::vector<Id> FindOpenEnds(const std::vector<ChainSegment>& segments, std::size_t vertices)
{
  std::vector<std::uint8_t> degrees(vertices, 0);
  for (const ChainSegment& segment : segments)
  {
    for (const Id vertex : { segment.Ends.Start, segment.Ends.End })
    {
      degrees[vertex] = degrees[vertex] == 0 ? 1 : 2;
    }
  }
  std::vector<Id> ends;
  for (std::size_t vertex = 0; vertex < degrees.size(); ++vertex)
  {
    if (degrees[vertex] == 1)
    {
      ends.push_back(static_cast<Id>(vertex));
    }
  }
  return ends;
}

EndSurroundings::EndSurroundings(
  std::vector<ChainSegment> segments, const WeldedPoints& points, Pulse& pulse)
  : Vertices(points.Vertices)
  , Rounding(points.Rounding)
  , Beats(pulse)
  , Segments(std::move(segments))
  , Stars(points.Vertices, this->Ends(), pulse)
  , Tree(points.Vertices, this->Ends(), points.Rounding, pulse)
  , IsMarked(points.Vertices.size(), 0)
{
}

std::vector<SegmentEnds> EndSurroundings::Ends() const
{
  std::vector<SegmentEnds> ends;
  ends.reserve(this->Segments.size());
  for (const ChainSegment& segment : this->Segments)
  {
    ends.push_back(segment.Ends);
  }
  return ends;
}

/// From the nearer end of the segment, so that places at it are exactly that.
Foot EndSurroundings::FootOn(Id segment, Id end) const
{
  const Point2& place = this->At(end);
  const Point2& a = this->At(this->Segment(segment).Ends.Start);
  const Point2& b = this->At(this->Segment(segment).Ends.End);
  const double share = Dot(place - a, b - a) / Dot(b - a, b - a);
  const double along = std::min(std::max(share, 0.0), 1.0);
  const Point2 foot = along < 0.5 ? a + along * (b - a) : b - (1.0 - along) * (b - a);
  return { segment, Distance(place, foot), foot, along, end };
}

std::vector<Foot> EndSurroundings::VerticesOnSegmentAt(Id vertex) const
{
  const Id segment = *this->Stars.Begin(vertex);
  const SegmentEnds& own = this->Segment(segment).Ends;
  std::vector<Foot> feet;
  this->Tree.Visit(Box2::Around(this->At(own.Start), this->At(own.End)), SegmentEnds(),
    [this, segment, &own, &feet](Id other)
    {
      const SegmentEnds& ends = this->Segment(other).Ends;
      for (const Id candidate : { ends.Start, ends.End })
      {
        const Foot foot = this->FootOn(segment, candidate);
        if (!own.Has(candidate) && foot.Distance <= this->Rounding)
        {
          feet.push_back(foot);
        }
      }
    });
  return feet;
}

void EndSurroundings::AddOwn(Id end, double reach)
{
  std::size_t next = this->Marked.size();
  this->Marked.push_back(end);
  for (; next < this->Marked.size() && this->Beats.Beat(); ++next)
  {
    const Id vertex = this->Marked[next];
    this->IsMarked[vertex] = 1;
    for (const Id* s = this->Stars.Begin(vertex); s != this->Stars.End(vertex); ++s)
    {
      const Id other = OtherEnd(this->Segment(*s).Ends, vertex);
      if (!this->IsOwn(other) && Distance(this->At(other), this->At(end)) <= reach)
      {
        this->Marked.push_back(other);
      }
    }
  }
}

void EndSurroundings::ForgetOwn()
{
  for (const Id vertex : this->Marked)
  {
    this->IsMarked[vertex] = 0;
  }
  this->Marked.clear();
}

} // namespace biting
