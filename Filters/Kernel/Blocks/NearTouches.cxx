// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "NearTouches.h"

#include "../Base/DistanceToSegment.h"
#include "../Biting/Spokes.h"
#include "../Domain/SegmentTree.h"

#include <algorithm> // for min, max
#include <cstdint>   // for flags
#include <vector>    // for the lists

namespace biting
{

namespace
{

// In units of the domain's resolution: twice what rounding takes a vertex off its segment, on both
// sides, with a factor of two to spare.
constexpr double RoundingReach = 8.0;

// Of f: how near to its ends a segment may be divided.
constexpr double LeastWay = 0.25;

constexpr std::size_t MostPairs = 1000; // and one a segment

// Segments that do not cross are nearest to each other at an end. Those after the domain's own are
// embedded points.
class TouchSearch
{
public:
  bool GoesOn() { return !this->Found.AreEverywhere && this->Beats.Beat(); }
  void SetFraction(double fraction) { this->Beats.SetFraction(fraction); }

  void operator()(Id first, Id second)
  {
    if (this->IsNear(this->Segments[first], this->Segments[second]) ||
      this->IsNear(this->Segments[second], this->Segments[first]))
    {
      this->Found.Pairs.push_back({ first, second });
      this->Found.AreEverywhere =
        std::max(first, second) >= this->Geometry.NumberOfSegments() || IsLong(this->Found);
    }
  }

  const Domain& Geometry;
  const std::vector<SegmentEnds>& Segments;
  double Reach;
  NearTouches& Found;
  Pulse& Beats;

private:
  bool IsLong(const NearTouches& touches) const
  {
    return touches.Pairs.size() > MostPairs + this->Segments.size();
  }

  bool IsNear(const SegmentEnds& one, const SegmentEnds& other) const
  {
    const Point2& a = this->Geometry.Vertices[other.Start];
    const Point2& b = this->Geometry.Vertices[other.End];
    return DistanceToSegment(this->Geometry.Vertices[one.Start], a, b) <= this->Reach ||
      DistanceToSegment(this->Geometry.Vertices[one.End], a, b) <= this->Reach;
  }
};

void AddNearSegments(const Domain& domain, double reach, NearTouches& touches, Pulse& pulse)
{
  const std::vector<SegmentEnds> segments = SegmentsAndPoints(domain);
  const SegmentTree tree(domain.Vertices, segments, reach, pulse);
  TouchSearch search{ domain, segments, reach, touches, pulse };
  if (!pulse.HasStopped())
  {
    tree.VisitPairs(std::vector<std::uint8_t>(segments.size(), 1), search);
  }
}

// Whether the first vertices on two segments that leave a vertex, or their ends, are that near.
bool AreNear(
  const Point2& vertex, const Spacing& spacing, const Spoke& one, const Spoke& other, double reach)
{
  const Point2 first = one.End - vertex;
  const Point2 second = other.End - vertex;
  const double length = Length(first);
  const double otherLength = Length(second);
  const double along = std::min({ length, otherLength, LeastWay * spacing(vertex) });
  return Distance(along / length * first, along / otherLength * second) <= reach;
}

void AddNearSpokes(
  const Domain& domain, const Spacing& spacing, double reach, NearTouches& touches, Pulse& pulse)
{
  const SpokesOfVertices all(domain);
  for (Id vertex = 0; vertex < domain.NumberOfVertices() && pulse.Beat(); ++vertex)
  {
    const std::vector<Spoke> spokes = all.Around(vertex);
    for (std::size_t k = 0; k < spokes.size() && spokes.size() > 1; ++k)
    {
      const Spoke& next = spokes[(k + 1) % spokes.size()];
      if (AreNear(domain.Vertices[vertex], spacing, spokes[k], next, reach))
      {
        touches.Pairs.push_back({ spokes[k].Segment, next.Segment });
      }
    }
  }
}

} // namespace

NearTouches FindNearTouches(const Domain& domain, const Spacing& spacing, Pulse& pulse)
{
  const PulsePart part(pulse, 0.0, 0.0);
  const double reach = RoundingReach * domain.Resolution;
  NearTouches touches;
  AddNearSpokes(domain, spacing, reach, touches, pulse);
  AddNearSegments(domain, reach, touches, pulse);
  return touches;
}

} // namespace biting
