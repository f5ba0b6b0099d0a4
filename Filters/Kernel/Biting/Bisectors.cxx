// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Bisectors.h"

#include "../Base/Numbers.h"

#include <algorithm> // for any_of, min, max
#include <cmath>     // for abs, sqrt
#include <utility>   // for pair

namespace biting
{

namespace
{

// Narrows [enter, leave] to where |offset + t slope| <= halfWidth.
void ClipToSlab(double offset, double slope, double halfWidth, double& enter, double& leave)
{
  if (slope == 0.0)
  {
    leave = std::abs(offset) <= halfWidth ? leave : -Infinity;
    return;
  }
  const double middle = -offset / slope;
  const double half = std::abs(halfWidth / slope);
  enter = std::max(enter, middle - half);
  leave = std::min(leave, middle + half);
}

} // namespace

std::pair<double, double> InsideOf(
  const Point2& axis, double halfWidth, const Point2& offset, const Point2& direction)
{
  double enter = -Infinity;
  double leave = Infinity;
  if (axis != Point2{})
  {
    ClipToSlab(Dot(offset, axis), Dot(direction, axis), halfWidth, enter, leave);
    ClipToSlab(Cross(axis, offset), Cross(axis, direction), halfWidth, enter, leave);
    return { enter, leave };
  }
  const double square = Dot(direction, direction);
  const double middle = -Dot(offset, direction) / square;
  const Point2 nearest = offset + middle * direction;
  const double rest = (halfWidth * halfWidth - Dot(nearest, nearest)) / square;
  const double half = rest >= 0.0 ? std::sqrt(rest) : -Infinity;
  return { middle - half, middle + half };
}

Bisectors::Bisectors(const Bites& bites, const BiteGrid& grid, double lengthPerHalfWidth,
  double tolerance, double slack)
  : All(bites)
  , Grid(grid)
  , LengthPerHalfWidth(lengthPerHalfWidth)
  , Tolerance(tolerance)
  , Slack(slack)
{
}

void Bisectors::SetBite(Id bite)
{
  this->Bite = this->MakeNeighbor(bite);
  if (bite != this->NextBite || this->Bite.Center != this->Next)
  {
    this->Gather(this->Bite.Center, [](const Neighbor&) { return false; });
  }
  this->NextBite = NoId;
}

// Gathers the bites whose bond with a bite at p is short enough, until stopsAt() is true of one.
// Returns whether it was.
template <typename Stop>
bool Bisectors::Gather(const Point2& p, Stop&& stopsAt)
{
  this->NumberOfNeighbors = 0;
  const double reach = GreatestBond * this->LengthPerHalfWidth;
  bool hasStopped = false;
  this->Grid.VisitNear(p, reach,
    [this, &p, &stopsAt, &hasStopped, reach](Id other)
    {
      const Point2 bond = this->All.Centers[other] - p;
      const double limit = reach * this->All.HalfWidths[other];
      const double square = Dot(bond, bond);
      if (!(square < limit * limit))
      {
        return false;
      }
      Neighbor& neighbor = this->Neighbors[this->NumberOfNeighbors];
      neighbor = this->MakeNeighbor(other);
      this->NumberOfNeighbors += square > 0.0 ? 1 : 0;
      hasStopped = stopsAt(neighbor);
      return hasStopped || this->IsFull();
    });
  return hasStopped;
}

bool Bisectors::IsCrowded() const
{
  return this->IsFull() && this->All.Phases[this->Bite.Bite] != BitePhase::Interior;
}

Bisectors::Neighbor Bisectors::MakeNeighbor(Id bite) const
{
  return { bite, this->All.Centers[bite], this->All.Axes[bite], this->All.HalfWidths[bite],
    this->CoreOf(bite) };
}

Bisectors::Heights Bisectors::HeightsOver(const Neighbor& other, const Point2& bond) const
{
  const Point2 half = 0.5 * bond;
  const Point2 direction = Perpendicular(bond);
  Heights heights{ 0.0, 0.0 };
  const std::pair<double, double> inside[2] = { InsideOf(this->Bite.Axis, this->Bite.HalfWidth,
                                                  half, direction),
    InsideOf(other.Axis, other.HalfWidth, -1.0 * half, direction) };
  for (const auto& [enter, leave] : inside)
  {
    if (enter <= leave)
    {
      heights = { std::max(heights.Left, leave), std::min(heights.Right, enter) };
    }
  }
  return heights;
}

// The mean over the three sides of |length / wanted - 1|. Circles fix two of the sides, so the
// third one tells.
double Bisectors::Misfit(const Neighbor& other, const Point2& bond, double height) const
{
  const double perWanted =
    2.0 / (this->LengthPerHalfWidth * (this->Bite.HalfWidth + other.HalfWidth));
  const double base = perWanted * Length(bond);
  if (this->Bite.Axis == Point2{})
  {
    return std::abs(base - 1.0);
  }
  const double leg = base * std::sqrt(0.25 + height * height);
  return (std::abs(base - 1.0) + 2.0 * std::abs(leg - 1.0)) / 3.0;
}

bool Bisectors::IsCoveredNearby(const Point2& p) const
{
  const Neighbor* first = this->Neighbors.data();
  return std::any_of(first, first + this->NumberOfNeighbors,
    [&p](const Neighbor& neighbor) { return Covers(neighbor, p); });
}

// A bite that covers p is nearer to it than the corner of a square, and so than a bond.
bool Bisectors::IsCovered(const Point2& p)
{
  this->Next = p;
  this->NextBite = this->All.Size();
  return this->Gather(p, [&p](const Neighbor& neighbor) { return Covers(neighbor, p); }) ||
    (this->IsFull() &&
      this->Grid.VisitLeaf(p, [this, &p](Id bite) { return this->IsCoveredBy(bite, p); }));
}

bool Bisectors::IsDeep(const Point2& p, Id birth) const
{
  return this->Grid.VisitLeaf(
    p, [this, &p](Id bite) { return Gauge(this->All, bite, p) < DeepShare * this->CoreOf(bite); },
    birth);
}

} // namespace biting
