// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "VertexStars.h"

#include "../Base/SortInSteps.h"
#include "../Predicates/Predicates.h"

#include <algorithm> // for sort, find, copy
#include <cstddef>   // for size_t

namespace biting
{

namespace
{

constexpr Id LargeDegree = 4096; // sorting takes milliseconds

/// Orders segments by their direction seen from one vertex.
struct DirectionOrder
{
  const std::vector<Point2>& Points;
  const std::vector<SegmentEnds>& Segments;
  Id Vertex;

  const Point2& Far(Id segment) const
  {
    const Id other = OtherEnd(this->Segments[static_cast<std::size_t>(segment)], this->Vertex);
    return this->Points[static_cast<std::size_t>(other)];
  }

  bool operator()(Id first, Id second) const
  {
    const Point2& apex = this->Points[static_cast<std::size_t>(this->Vertex)];
    const Point2& a = this->Far(first);
    const Point2& b = this->Far(second);
    const bool isRight = apex < a;
    if (isRight != (apex < b))
    {
      return isRight;
    }
    const int side = Orient2D(apex, a, b);
    return side > 0 || (side == 0 && first < second);
  }
};

std::vector<Id> CountDegrees(std::size_t vertices, const std::vector<SegmentEnds>& segments)
{
  std::vector<Id> offsets(vertices + 1, 0);
  for (const SegmentEnds& ends : segments)
  {
    ++offsets[static_cast<std::size_t>(ends.Start) + 1];
    ++offsets[static_cast<std::size_t>(ends.End) + 1];
  }
  for (std::size_t v = 0; v < vertices; ++v)
  {
    offsets[v + 1] += offsets[v];
  }
  return offsets;
}

} // namespace

VertexStars::VertexStars(
  const std::vector<Point2>& points, const std::vector<SegmentEnds>& segments)
{
  SilentMonitor monitor;
  Pulse pulse(monitor);
  *this = VertexStars(points, segments, pulse);
}

VertexStars::VertexStars(
  const std::vector<Point2>& points, const std::vector<SegmentEnds>& segments, Pulse& pulse)
  : Offsets(CountDegrees(points.size(), segments))
  , Segments(2 * segments.size())
{
  std::vector<Id> next(this->Offsets.begin(), this->Offsets.end() - 1);
  for (std::size_t s = 0; s < segments.size(); ++s)
  {
    for (const Id vertex : { segments[s].Start, segments[s].End })
    {
      const Id place = next[static_cast<std::size_t>(vertex)]++;
      this->Segments[static_cast<std::size_t>(place)] = static_cast<Id>(s);
    }
  }
  for (Id vertex = 0; vertex < this->NumberOfVertices() && !pulse.HasStopped(); ++vertex)
  {
    this->SortStar(vertex, points, segments, pulse);
  }
}

void VertexStars::SortStar(Id vertex, const std::vector<Point2>& points,
  const std::vector<SegmentEnds>& segments, Pulse& pulse)
{
  const DirectionOrder order{ points, segments, vertex };
  const auto begin = this->Segments.begin() + this->Offset(vertex);
  const auto end = this->Segments.begin() + this->Offset(vertex + 1);
  if (this->Degree(vertex) <= LargeDegree)
  {
    std::sort(begin, end, order);
    pulse.Beat(1 + static_cast<std::size_t>(this->Degree(vertex)));
    return;
  }
  std::vector<Id> star(begin, end);
  SortInSteps(star, order, pulse);
  std::copy(star.begin(), star.end(), begin);
}

Id VertexStars::Next(Id vertex, Id segment) const
{
  const Id* next = std::find(this->Begin(vertex), this->End(vertex), segment) + 1;
  return next == this->End(vertex) ? *this->Begin(vertex) : *next;
}

} // namespace biting
