// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "VertexStars.h"

#include "../Base/SortInSteps.h"
#include "../Predicates/Predicates.h"

#include <algorithm> // for sort, find, transform
#include <cstddef>   // for size_t

namespace biting
{

namespace
{

constexpr Id LargeDegree = 4096; // sorting takes milliseconds

/// Orders segments by their direction seen from one vertex.
struct DirectionOrder
{
  Point2 Apex;

  bool operator()(const VertexStars::Ray& first, const VertexStars::Ray& second) const
  {
    const bool isRight = this->Apex < first.Far;
    if (isRight != (this->Apex < second.Far))
    {
      return isRight;
    }
    const int side = Orient2D(this->Apex, first.Far, second.Far);
    return side > 0 || (side == 0 && first.Segment < second.Segment);
  }
};

std::vector<Id> CountDegrees(std::size_t vertices, const std::vector<SegmentEnds>& segments)
{
  std::vector<Id> offsets(vertices + 1, 0);
  for (const SegmentEnds& ends : segments)
  {
    ++offsets[ends.Start + 1];
    ++offsets[ends.End + 1];
  }
  for (std::size_t v = 0; v < vertices; ++v)
  {
    offsets[v + 1] += offsets[v];
  }
  return offsets;
}

} // namespace

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
      const Id place = next[vertex]++;
      this->Segments[place] = static_cast<Id>(s);
    }
  }
  std::vector<Ray> rays;
  for (Id vertex = 0; vertex < this->NumberOfVertices() && !pulse.HasStopped(); ++vertex)
  {
    this->SortStar(vertex, points, segments, rays, pulse);
  }
}

/// `rays` is room for those of the vertex.
void VertexStars::SortStar(Id vertex, const std::vector<Point2>& points,
  const std::vector<SegmentEnds>& segments, std::vector<Ray>& rays, Pulse& pulse)
{
  rays.clear();
  for (const Id* s = this->Begin(vertex); s != this->End(vertex); ++s)
  {
    const Id far = OtherEnd(segments[*s], vertex);
    rays.push_back({ points[far], *s });
  }
  const DirectionOrder order{ points[vertex] };
  if (this->Degree(vertex) <= LargeDegree)
  {
    std::sort(rays.begin(), rays.end(), order);
    pulse.Beat(1 + rays.size());
  }
  else
  {
    SortInSteps(rays, order, pulse);
  }
  std::transform(rays.begin(), rays.end(), this->Segments.begin() + this->Offset(vertex),
    [](const Ray& ray) { return ray.Segment; });
}

Id VertexStars::Next(Id vertex, Id segment) const
{
  const Id* next = std::find(this->Begin(vertex), this->End(vertex), segment) + 1;
  return next == this->End(vertex) ? *this->Begin(vertex) : *next;
}

} // namespace biting
