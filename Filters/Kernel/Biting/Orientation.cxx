// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Orientation.h"

#include "Spokes.h"

#include <algorithm> // for any_of, min
#include <cmath>     // for abs

namespace biting
{

namespace
{

constexpr double SameSquareTolerance = 1e-12; // of a unit vector: rounding of the same square

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
