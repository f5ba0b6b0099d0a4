// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Nesting.h"

#include "../Base/SortInSteps.h"
#include "../Predicates/Predicates.h"
#include "VertexStars.h"

#include <cstddef>  // for size_t
#include <iterator> // for prev
#include <numeric>  // for iota
#include <set>      // for the segments that the sweep line cuts
#include <utility>  // for move

namespace biting
{

namespace
{

/// Orders the segments that the sweep line cuts from below to above, and points among them.
struct BelowOrder
{
  using is_transparent = void;

  const std::vector<Point2>* Vertices;
  const std::vector<SegmentEnds>* Segments; ///< from left to right

  const Point2& Start(Id segment) const
  {
    const Id vertex = (*this->Segments)[segment].Start;
    return (*this->Vertices)[vertex];
  }
  const Point2& End(Id segment) const
  {
    const Id vertex = (*this->Segments)[segment].End;
    return (*this->Vertices)[vertex];
  }
  int Side(Id segment, const Point2& p) const
  {
    return Orient2D(this->Start(segment), this->End(segment), p);
  }

  bool operator()(Id segment, const Point2& p) const { return this->Side(segment, p) > 0; }
  bool operator()(const Point2& p, Id segment) const { return this->Side(segment, p) < 0; }
  bool operator()(Id a, Id b) const
  {
    if (a == b)
    {
      return false;
    }
    if (this->Start(b) < this->Start(a))
    {
      return this->Side(b, this->Start(a)) < 0;
    }
    const int side = this->Side(a, this->Start(b));
    return side != 0 ? side > 0 : this->Side(a, this->End(b)) > 0;
  }
};

std::vector<SegmentEnds> LeftToRight(
  const std::vector<Point2>& vertices, const std::vector<SegmentEnds>& segments)
{
  std::vector<SegmentEnds> directed = segments;
  for (SegmentEnds& ends : directed)
  {
    if (vertices[ends.End] < vertices[ends.Start])
    {
      ends = { ends.End, ends.Start };
    }
  }
  return directed;
}

/// Sums `steps` over the segments that are crossed from below to above, beginning outside.
class Sweep
{
public:
  Sweep(const std::vector<Point2>& vertices, const std::vector<SegmentEnds>& segments,
    std::vector<Id> steps, Pulse& pulse)
    : Vertices(vertices)
    , Directed(LeftToRight(vertices, segments))
    , Steps(std::move(steps))
    , Beats(pulse)
    , Stars(vertices, this->Directed, pulse)
    , Cut(BelowOrder{ &vertices, &this->Directed })
    , Places(segments.size(), this->Cut.end())
    , Above(segments.size(), 0)
    , Below(segments.size(), NoId)
    , LoneInside(vertices.size(), 0)
  {
  }

  bool Run();
  InsideFlags Flags(const std::vector<SegmentEnds>& segments) const;
  SegmentDepths Depths();

private:
  using CutSegments = std::set<Id, BelowOrder>;

  std::vector<Id> EventOrder() const;
  void Pass(Id vertex);
  CutSegments::iterator EraseEnding(Id vertex, CutSegments::iterator above);
  void InsertStarting(Id vertex, CutSegments::iterator above);
  Id SegmentBelow(CutSegments::iterator above) const;
  Id DepthAbove(Id segment) const;

  const std::vector<Point2>& Vertices;
  const std::vector<SegmentEnds> Directed;
  const std::vector<Id> Steps;
  Pulse& Beats;
  const VertexStars Stars;
  CutSegments Cut;
  std::vector<CutSegments::iterator> Places; ///< of each segment in Cut
  std::vector<Id> Above;                     ///< the sum just above each segment
  std::vector<Id> Below;                     ///< the segment below the left end of each
  std::vector<Id> Order;                     ///< in which segments were met
  std::vector<std::uint8_t> LoneInside;
};

bool Sweep::Run()
{
  const std::vector<Id> order = this->EventOrder();
  for (std::size_t i = 0; i < order.size() && this->Beats.Beat(); ++i)
  {
    this->Pass(order[i]);
    this->Beats.SetFraction(static_cast<double>(i) / static_cast<double>(order.size()));
  }
  return !this->Beats.HasStopped();
}

std::vector<Id> Sweep::EventOrder() const
{
  std::vector<Id> order(this->Vertices.size());
  std::iota(order.begin(), order.end(), 0);
  const auto isBefore = [this](Id a, Id b) { return this->Vertices[a] < this->Vertices[b]; };
  SortInSteps(order, isBefore, this->Beats);
  return order;
}

/// Segments that end here make room for those that start here.
void Sweep::Pass(Id vertex)
{
  const Id degree = this->Stars.Degree(vertex);
  const Id* last = this->Stars.End(vertex) - 1;
  const bool hasEnding = degree > 0 && this->Directed[*last].End == vertex;
  const auto above = hasEnding ? this->EraseEnding(vertex, this->Cut.end())
                               : this->Cut.lower_bound(this->Vertices[vertex]);
  if (degree == 0)
  {
    const Id depth = this->DepthAbove(this->SegmentBelow(above));
    this->LoneInside[vertex] = depth % 2 != 0 ? 1 : 0;
  }
  this->InsertStarting(vertex, above);
}

/// Erases from below to above, which is the star backwards; returns what lies above them.
Sweep::CutSegments::iterator Sweep::EraseEnding(Id vertex, CutSegments::iterator above)
{
  for (const Id* s = this->Stars.End(vertex); s != this->Stars.Begin(vertex); --s)
  {
    const auto segment = static_cast<std::size_t>(s[-1]);
    if (this->Directed[segment].Start == vertex)
    {
      break;
    }
    above = this->Cut.erase(this->Places[segment]);
  }
  return above;
}

void Sweep::InsertStarting(Id vertex, CutSegments::iterator above)
{
  Id below = this->SegmentBelow(above);
  for (const Id* s = this->Stars.Begin(vertex); s != this->Stars.End(vertex); ++s)
  {
    const auto segment = static_cast<std::size_t>(*s);
    if (this->Directed[segment].End == vertex)
    {
      break;
    }
    this->Above[segment] = this->DepthAbove(below) + this->Steps[segment];
    this->Below[segment] = below;
    this->Order.push_back(*s);
    this->Places[segment] = this->Cut.insert(above, *s);
    below = *s;
  }
}

/// NoId where nothing lies below.
Id Sweep::SegmentBelow(CutSegments::iterator above) const
{
  return above == this->Cut.begin() ? NoId : *std::prev(above);
}

Id Sweep::DepthAbove(Id segment) const
{
  return segment == NoId ? 0 : this->Above[segment];
}

/// Above is the left of a segment that leads from left to right.
InsideFlags Sweep::Flags(const std::vector<SegmentEnds>& segments) const
{
  InsideFlags flags;
  flags.Vertices = this->LoneInside;
  for (std::size_t s = 0; s < segments.size(); ++s)
  {
    const std::uint8_t above = this->Above[s] % 2 != 0 ? 1 : 0;
    const std::uint8_t below = (this->Above[s] - this->Steps[s]) % 2 != 0 ? 1 : 0;
    const bool isReversed = segments[s].Start != this->Directed[s].Start;
    flags.Left.push_back(isReversed ? below : above);
    flags.Right.push_back(isReversed ? above : below);
  }
  return flags;
}

SegmentDepths Sweep::Depths()
{
  SegmentDepths depths;
  depths.Steps = this->Steps;
  depths.Above = std::move(this->Above);
  depths.Below = std::move(this->Below);
  depths.Order = std::move(this->Order);
  return depths;
}

/// Turned where the segment leads from right to left.
std::vector<Id> Upwards(const std::vector<Point2>& vertices,
  const std::vector<SegmentEnds>& segments, std::vector<Id> steps)
{
  for (std::size_t s = 0; s < steps.size(); ++s)
  {
    const bool isReversed = vertices[segments[s].End] < vertices[segments[s].Start];
    steps[s] = isReversed ? -steps[s] : steps[s];
  }
  return steps;
}

} // namespace

SegmentDepths FindDepths(const std::vector<Point2>& vertices,
  const std::vector<SegmentEnds>& segments, const std::vector<Id>& turns, Pulse& pulse)
{
  Sweep sweep(vertices, segments, Upwards(vertices, segments, turns), pulse);
  return sweep.Run() ? sweep.Depths() : SegmentDepths();
}

InsideFlags FindInside(const std::vector<Point2>& vertices,
  const std::vector<SegmentEnds>& segments, const std::vector<std::uint8_t>& bounds, Pulse& pulse)
{
  Sweep sweep(vertices, segments, std::vector<Id>(bounds.begin(), bounds.end()), pulse);
  return sweep.Run() ? sweep.Flags(segments) : InsideFlags();
}

} // namespace biting
