// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "FreeEdges.h"

#include "../Base/DistanceToSegment.h"
#include "../Domain/AreaSum.h"
#include "../Domain/Nesting.h"
#include "../Predicates/Predicates.h"

#include <algorithm> // for all_of
#include <array>     // for ends
#include <cmath>     // for abs
#include <cstdint>   // for flags

namespace biting
{

namespace
{

constexpr Id MostAtVertex = 4; // of two parts of a mesh that touch there

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

/// Looks at pairs of edges until two are near.
class NearEdgeSearch
{
public:
  NearEdgeSearch(const FreeEdges& edges, double distance, Pulse& pulse)
    : Edges(edges)
    , Least(distance)
    , Beats(pulse)
  {
  }

  bool AreApart()
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
    return this->GoesOn();
  }

  // For SegmentTree::VisitPairs.
  bool GoesOn() { return !this->HasNear && this->Beats.Beat(); }
  void SetFraction(double) {}
  void operator()(Id one, Id other);

private:
  /// The other ends of the edges at a vertex.
  struct Fan
  {
    std::array<Id, MostAtVertex> Ends;
    Id Count = 0;
  };

  void LookAtLengths();
  void LookAtEnds();
  void LookAtFan(Id apex, const Fan& fan);
  bool IsNear(const Point2& p, const Point2& a, const Point2& b) const
  {
    return !(DistanceToSegment(p, a, b) > this->Least);
  }
  const Point2& Place(Id point) const { return this->Edges.Points[point]; }

  const FreeEdges& Edges;
  const double Least;
  Pulse& Beats;
  bool HasNear = false;
};

void NearEdgeSearch::LookAtLengths()
{
  this->HasNear = !std::all_of(this->Edges.Ends.begin(), this->Edges.Ends.end(),
    [this](const SegmentEnds& ends)
    {
      const Point2& start = this->Place(ends.Start);
      const Point2& end = this->Place(ends.End);
      return start != end && Distance(start, end) > 2.0 * this->Least;
    });
}

void NearEdgeSearch::LookAtEnds()
{
  std::vector<Fan> fans(this->Edges.Points.size());
  for (const SegmentEnds& ends : this->Edges.Ends)
  {
    for (const Id apex : { ends.Start, ends.End })
    {
      Fan& fan = fans[apex];
      if (fan.Count == MostAtVertex)
      {
        this->HasNear = true;
        return;
      }
      fan.Ends[fan.Count++] = ends.Start == apex ? ends.End : ends.Start;
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
  const Point2& place = this->Place(apex);
  for (Id one = 0; one < fan.Count; ++one)
  {
    for (Id other = 0; other < one; ++other)
    {
      const Point2& a = this->Place(fan.Ends[one]);
      const Point2& b = this->Place(fan.Ends[other]);
      const bool isAcute = Dot(a - place, b - place) >= 0.0;
      this->HasNear = this->HasNear ||
        (isAcute &&
          (this->IsNear(a, place, b) || this->IsNear(b, place, a) || Orient2D(place, a, b) == 0));
    }
  }
}

void NearEdgeSearch::operator()(Id one, Id other)
{
  const Point2& a = this->Place(this->Edges.Ends[one].Start);
  const Point2& b = this->Place(this->Edges.Ends[one].End);
  const Point2& c = this->Place(this->Edges.Ends[other].Start);
  const Point2& d = this->Place(this->Edges.Ends[other].End);
  if (!AreBeside(a, b, c, d, this->Least) && !AreBeside(c, d, a, b, this->Least))
  {
    this->HasNear = this->HasNear || Meet(a, b, c, d) != Meeting::None || this->IsNear(a, c, d) ||
      this->IsNear(b, c, d) || this->IsNear(c, a, b) || this->IsNear(d, a, b);
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

bool FreeEdges::AreApart(double distance, Pulse& pulse) const
{
  return NearEdgeSearch(*this, distance, pulse).AreApart();
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

double FreeEdges::Length() const
{
  double length = 0.0;
  for (const SegmentEnds& ends : this->Ends)
  {
    length += Distance(this->Points[ends.Start], this->Points[ends.End]);
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
