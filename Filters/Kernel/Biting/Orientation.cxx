// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Orientation.h"

#include "../Predicates/Predicates.h"

#include <algorithm> // for sort
#include <cmath>     // for abs

namespace biting
{

namespace
{

constexpr double SameSquareTolerance = 1e-12; // of a unit vector: rounding of the same square

// A segment as seen from one of its ends.
struct Spoke
{
  Point2 End;
  Point2 Direction;
  bool LeftInside;
};

class SpokesOfVertices
{
public:
  explicit SpokesOfVertices(const Domain& domain);
  std::vector<Spoke> Around(Id vertex) const;

private:
  Spoke MakeSpoke(Id vertex, Id segment) const;

  const Domain& Geometry;
  std::vector<Id> Offsets;
  std::vector<Id> Segments;
};

SpokesOfVertices::SpokesOfVertices(const Domain& domain)
  : Geometry(domain)
  , Offsets(domain.NumberOfVertices() + 1, 0)
  , Segments(2 * domain.NumberOfSegments())
{
  for (Id segment = 0; segment < domain.NumberOfSegments(); ++segment)
  {
    ++this->Offsets[domain.Starts[segment] + 1];
    ++this->Offsets[domain.Ends[segment] + 1];
  }
  for (Id vertex = 0; vertex < domain.NumberOfVertices(); ++vertex)
  {
    this->Offsets[vertex + 1] += this->Offsets[vertex];
  }
  std::vector<Id> next(this->Offsets);
  for (Id segment = 0; segment < domain.NumberOfSegments(); ++segment)
  {
    this->Segments[next[domain.Starts[segment]]++] = segment;
    this->Segments[next[domain.Ends[segment]]++] = segment;
  }
}

// Counterclockwise, beginning at the direction of negative x.
std::vector<Spoke> SpokesOfVertices::Around(Id vertex) const
{
  std::vector<Spoke> spokes;
  for (Id k = this->Offsets[vertex]; k < this->Offsets[vertex + 1]; ++k)
  {
    spokes.push_back(this->MakeSpoke(vertex, this->Segments[k]));
  }
  const Point2 center = this->Geometry.Vertices[vertex];
  std::sort(spokes.begin(), spokes.end(),
    [&center](const Spoke& a, const Spoke& b)
    {
      const bool isAboveA = center < a.End;
      const bool isAboveB = center < b.End;
      return isAboveA != isAboveB ? isAboveB : Orient2D(center, a.End, b.End) > 0;
    });
  return spokes;
}

Spoke SpokesOfVertices::MakeSpoke(Id vertex, Id segment) const
{
  const bool isStart = this->Geometry.Starts[segment] == vertex;
  const Id other = isStart ? this->Geometry.Ends[segment] : this->Geometry.Starts[segment];
  Spoke spoke;
  spoke.End = this->Geometry.Vertices[other];
  const Point2 span = spoke.End - this->Geometry.Vertices[vertex];
  spoke.Direction = 1.0 / Length(span) * span;
  spoke.LeftInside =
    (isStart ? this->Geometry.LeftInside : this->Geometry.RightInside)[segment] != 0;
  return spoke;
}

// The same square: axes that agree up to a turn by a multiple of 90 degrees.
bool AreSameSquare(const Point2& a, const Point2& b)
{
  return std::min(std::abs(Cross(a, b)), std::abs(Dot(a, b))) <= SameSquareTolerance;
}

void AddAxis(const Point2& axis, Id first, std::vector<Point2>& axes)
{
  const bool isKnown = std::any_of(axes.begin() + first, axes.end(),
    [&axis](const Point2& known) { return AreSameSquare(axis, known); });
  if (!isKnown)
  {
    axes.push_back(axis);
  }
}

} // namespace

VertexAxes OrientVertexBites(const Domain& domain, Pulse& pulse)
{
  const SpokesOfVertices spokesOfVertices(domain);
  VertexAxes result;
  for (Id vertex = 0; vertex < domain.NumberOfVertices(); ++vertex)
  {
    pulse.Beat();
    const Id first = static_cast<Id>(result.Axes.size());
    result.Offsets.push_back(first);
    const std::vector<Spoke> spokes = spokesOfVertices.Around(vertex);
    for (std::size_t k = 0; k < spokes.size(); ++k)
    {
      if (spokes[k].LeftInside)
      {
        const Spoke& last = spokes[(k + 1) % spokes.size()];
        AddAxis(SectorAxis(spokes[k].Direction, last.Direction), first, result.Axes);
      }
    }
    if (static_cast<Id>(result.Axes.size()) == first)
    {
      result.Axes.push_back({ 1.0, 0.0 });
    }
  }
  result.Offsets.push_back(static_cast<Id>(result.Axes.size()));
  return result;
}

// A square looks the same from a bisector and from its opposite, so the sign of the bisector, and
// with it the difference between a sector and its complement, does not matter.
Point2 SectorAxis(const Point2& first, const Point2& last)
{
  const bool isWithin135And225 = Dot(first, last) <= -std::abs(Cross(first, last));
  if (isWithin135And225)
  {
    const Point2 across = first - last; // perpendicular to the bisector, and well away from zero
    return 1.0 / Length(across) * across;
  }
  const Point2 bisector = first + last;
  const Point2 turned{ bisector.X - bisector.Y, bisector.X + bisector.Y };
  return 1.0 / Length(turned) * turned;
}

} // namespace biting
