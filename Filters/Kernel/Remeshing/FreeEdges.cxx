// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "FreeEdges.h"

#include "../Base/DistanceToSegment.h"
#include "../Domain/AreaSum.h"
#include "../Domain/Nesting.h"
#include "../Predicates/Predicates.h"

#include <algorithm> // for min
#include <array>     // for edges
#include <cmath>     // for abs
#include <cstddef>   // for sizes
#include <utility>   // for move

namespace biting
{

namespace
{

constexpr Id MostAtVertex = 4; // of two parts of a mesh that touch there

constexpr std::size_t LooksPerEdge = 256; // at others

// A cross product of differences is off by less than this, in units of their lengths in the 1-norm.
constexpr double CrossRounding = 1e-15;

double OneNorm(const Point2& a)
{
  return std::abs(a.X) + std::abs(a.Y);
}

/// Whether c and d lie on one side of the line ab, clearly farther from it than `distance`.
bool AreBeside(const Point2& a, const Point2& b, const Point2& c, const Point2& d, double distance)
{
  const Point2 side = b - a;
  const auto height = [&side](const Point2& offset) { return Cross(side, offset); };
  const auto slack = [&side, distance](const Point2& offset)
  { return OneNorm(side) * (distance + CrossRounding * OneNorm(offset)); };
  const double one = height(c - a);
  const double other = height(d - a);
  return (one > 0.0) == (other > 0.0) && std::abs(one) > slack(c - a) &&
    std::abs(other) > slack(d - a);
}

/// Looks at pairs of edges.
class NearEdgeSearch
{
public:
  NearEdgeSearch(const FreeEdges& edges, double distance, bool isForAny, Pulse& pulse)
    : Edges(edges)
    , Least(distance)
    , IsForAny(isForAny)
    , LooksLeft(LooksPerEdge * edges.Ends.size())
    , Beats(pulse)
    , IsNear(edges.Ends.size(), 0)
  {
  }

  /// Empty where it did not come to its end.
  std::vector<std::uint8_t> Find()
  {
    this->LookAtLengths();
    this->LookAtEnds();
    if (this->GoesOn())
    {
      const SegmentTree tree(this->Edges.Points, this->Edges.Ends, this->Least, this->Beats);
      if (this->GoesOn())
      {
        tree.VisitPairs(std::vector<std::uint8_t>(this->Edges.Ends.size(), 1), *this);
      }
    }
    return this->GoesOn() ? std::move(this->IsNear) : std::vector<std::uint8_t>();
  }

  // For SegmentTree::VisitPairs.
  bool GoesOn()
  {
    return !(this->IsForAny && this->HasNear) && this->LooksLeft > 0 && this->Beats.Beat();
  }
  void SetFraction(double) {}
  void operator()(Id one, Id other);

private:
  /// The edges at a vertex.
  struct Fan
  {
    std::array<Id, MostAtVertex> Edges;
    Id Count = 0; ///< also of more
  };

  void LookAtLengths();
  void LookAtEnds();
  void LookAtFan(Id apex, const Fan& fan);
  void Mark(Id edge)
  {
    this->IsNear[edge] = 1;
    this->HasNear = true;
  }
  bool IsNearTo(const Point2& p, const Point2& a, const Point2& b) const
  {
    return !(DistanceToSegment(p, a, b) > this->Least);
  }
  const Point2& Place(Id point) const { return this->Edges.Points[point]; }

  const FreeEdges& Edges;
  const double Least;
  const bool IsForAny; ///< one is enough
  std::size_t LooksLeft;
  Pulse& Beats;
  std::vector<std::uint8_t> IsNear;
  bool HasNear = false;
};

void NearEdgeSearch::LookAtLengths()
{
  for (std::size_t edge = 0; edge < this->IsNear.size(); ++edge)
  {
    const Point2& start = this->Place(this->Edges.Ends[edge].Start);
    const Point2& end = this->Place(this->Edges.Ends[edge].End);
    if (start == end || !(Distance(start, end) > 2.0 * this->Least))
    {
      this->Mark(static_cast<Id>(edge));
    }
  }
}

void NearEdgeSearch::LookAtEnds()
{
  std::vector<Fan> fans(this->Edges.Points.size());
  for (std::size_t edge = 0; edge < this->IsNear.size(); ++edge)
  {
    for (const Id apex : { this->Edges.Ends[edge].Start, this->Edges.Ends[edge].End })
    {
      Fan& fan = fans[apex];
      if (fan.Count < MostAtVertex)
      {
        fan.Edges[fan.Count] = static_cast<Id>(edge);
      }
      else
      {
        this->Mark(static_cast<Id>(edge));
      }
      ++fan.Count;
    }
  }
  for (Id apex = 0; apex < static_cast<Id>(fans.size()) && this->GoesOn(); ++apex)
  {
    this->LookAtFan(apex, fans[apex]);
  }
}

// Edges at an obtuse angle are as far from each other's ends as they are long.
void NearEdgeSearch::LookAtFan(Id apex, const Fan& fan)
{
  const auto endOf = [this, apex, &fan](Id k)
  {
    const SegmentEnds& ends = this->Edges.Ends[fan.Edges[k]];
    return this->Place(ends.Start == apex ? ends.End : ends.Start);
  };
  const Point2& place = this->Place(apex);
  for (Id one = 0; one < std::min(fan.Count, MostAtVertex); ++one)
  {
    for (Id other = 0; other < one; ++other)
    {
      const Point2 a = endOf(one);
      const Point2 b = endOf(other);
      const bool isAcute = Dot(a - place, b - place) >= 0.0;
      if (fan.Count > MostAtVertex ||
        (isAcute &&
          (this->IsNearTo(a, place, b) || this->IsNearTo(b, place, a) ||
            Orient2D(place, a, b) == 0)))
      {
        this->Mark(fan.Edges[one]);
        this->Mark(fan.Edges[other]);
      }
    }
  }
}

void NearEdgeSearch::operator()(Id one, Id other)
{
  --this->LooksLeft;
  const Point2& a = this->Place(this->Edges.Ends[one].Start);
  const Point2& b = this->Place(this->Edges.Ends[one].End);
  const Point2& c = this->Place(this->Edges.Ends[other].Start);
  const Point2& d = this->Place(this->Edges.Ends[other].End);
  const bool areKnown = this->IsNear[one] && this->IsNear[other];
  if (areKnown || AreBeside(a, b, c, d, this->Least) || AreBeside(c, d, a, b, this->Least))
  {
    return;
  }
  // What has no length has no meeting.
  const bool havePoint = a == b || c == d;
  if (this->IsNearTo(a, c, d) || this->IsNearTo(b, c, d) || this->IsNearTo(c, a, b) ||
    this->IsNearTo(d, a, b) || (!havePoint && Meet(a, b, c, d) != Meeting::None))
  {
    this->Mark(one);
    this->Mark(other);
  }
}

} // namespace

FreeEdges::FreeEdges(const OldMesh& mesh)
{
  std::vector<Id> numbers(mesh.Points.size(), NoId);
  const auto numberOf = [this, &mesh, &numbers](Id vertex)
  {
    Id& number = numbers[vertex];
    if (number == NoId)
    {
      number = static_cast<Id>(this->Points.size());
      this->Points.push_back(mesh.Points[vertex]);
    }
    return number;
  };
  for (const Id slot : mesh.FreeSlots())
  {
    const Id start = numberOf(mesh.Start(slot));
    this->Ends.push_back({ start, numberOf(mesh.End(slot)) });
  }
}

std::vector<std::uint8_t> FreeEdges::FindNear(double distance, Pulse& pulse) const
{
  const std::vector<std::uint8_t> areNear = NearEdgeSearch(*this, distance, false, pulse).Find();
  return areNear.empty() ? std::vector<std::uint8_t>(this->Ends.size(), 1) : areNear;
}

bool FreeEdges::AreApart(double distance, Pulse& pulse) const
{
  const std::vector<std::uint8_t> areNear = NearEdgeSearch(*this, distance, true, pulse).Find();
  return !areNear.empty() || this->Ends.empty();
}

bool FreeEdges::BoundOnce(Pulse& pulse) const
{
  const SegmentDepths depths =
    FindDepths(this->Points, this->Ends, std::vector<Id>(this->Ends.size(), 1), pulse);
  const auto isOnce = [](Id depth) { return depth == 0 || depth == 1; };
  for (std::size_t edge = 0; edge < depths.Above.size(); ++edge)
  {
    if (!isOnce(depths.Above[edge]) || !isOnce(depths.Above[edge] - depths.Steps[edge]))
    {
      return false;
    }
  }
  return !pulse.HasStopped();
}

double FreeEdges::LengthOf(const std::vector<std::uint8_t>& isCounted) const
{
  double length = 0.0;
  for (std::size_t edge = 0; edge < this->Ends.size(); ++edge)
  {
    const SegmentEnds& ends = this->Ends[edge];
    length += isCounted[edge] ? Distance(this->Points[ends.Start], this->Points[ends.End]) : 0.0;
  }
  return length;
}

double FreeEdges::Area() const
{
  if (this->Ends.empty())
  {
    return 0.0;
  }
  AreaSum sum(this->Points[this->Ends.front().Start]);
  for (const SegmentEnds& ends : this->Ends)
  {
    sum.Add(this->Points[ends.Start], this->Points[ends.End]);
  }
  return sum.Area();
}

} // namespace biting
