// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "CornerGuard.h"

#include "../Base/Numbers.h"
#include "ChainCorners.h"

#include <algorithm> // for lower_bound, sort
#include <cmath>     // for atan2
#include <cstddef>   // for ptrdiff_t

namespace biting
{

namespace
{
// Degrees: about the smallest angle of meshes without sharp corners.
constexpr double SharpAngle = 36.0;

// Degrees: no such angle is made outside of the domain either. Rounding keeps vertices on its sides
// from being told apart.
constexpr double NeedleAngle = 0.01;

// Where more segments than this end, some angles are sharp in any case: 360 / SharpAngle.
constexpr std::ptrdiff_t MostEnds = 10;

double AngleBetween(const Point2& a, const Point2& b)
{
  return DegreesPerRadian * std::atan2(std::abs(Cross(a, b)), Dot(a, b));
}

} // namespace

CornerGuard::CornerGuard(const Domain& domain, const DomainChains& chains)
  : Drawing(domain)
  , Chains(chains)
{
  for (Id slot = 0; slot < chains.NumberOfSlots(); ++slot)
  {
    if (chains.IsOpenEnd(slot))
    {
      this->Ends.emplace_back(chains.Vertices[slot], slot);
    }
  }
  std::sort(this->Ends.begin(), this->Ends.end());
}

std::vector<Id> CornerGuard::FindOtherSides(Id slot) const
{
  std::vector<Id> found;
  const Id previous = this->Chains.Previous[slot];
  const Id next = this->Chains.Nexts[slot];
  this->FindOtherSidesAt(previous, slot, next, found);
  this->FindOtherSidesAt(next, slot, previous, found);
  return found;
}

void CornerGuard::FindOtherSidesAt(Id near, Id slot, Id far, std::vector<Id>& found) const
{
  const auto add = [this, near, slot, far, &found](Id other)
  {
    if (this->IsSharpened(near, slot, far, other))
    {
      found.push_back(this->Chains.Vertices[other]);
    }
  };
  if (!this->Chains.IsOpenEnd(near))
  {
    const Id previous = this->Chains.Previous[near];
    add(previous == slot ? this->Chains.Nexts[near] : previous);
    return;
  }
  const Id vertex = this->Chains.Vertices[near];
  const auto first =
    std::lower_bound(this->Ends.begin(), this->Ends.end(), std::make_pair(vertex, Id{ 0 }));
  const auto last = std::lower_bound(first, this->Ends.end(), std::make_pair(vertex + 1, Id{ 0 }));
  for (auto end = first; last - first <= MostEnds && end != last; ++end)
  {
    if (end->second != near)
    {
      const Id next = this->Chains.Nexts[end->second];
      add(next != NoId ? next : this->Chains.Previous[end->second]);
    }
  }
}

// Whether the angle at the place of `near` with the place of `other` would be.
bool CornerGuard::IsSharpened(Id near, Id slot, Id far, Id other) const
{
  const Point2 side = this->At(other) - this->At(near);
  const Point2 before = this->At(slot) - this->At(near);
  const Point2 after = this->At(far) - this->At(near);
  const double angle = AngleBetween(after, side);
  return angle < SharpAngle - AngleStep && angle < AngleBetween(before, side) - AngleStep &&
    (angle < NeedleAngle || this->IsInside(near, slot, Cross(after, side) > 0.0));
}

// Whether the domain is on that side of the chain, walking from `near` to its neighbour `slot`.
bool CornerGuard::IsInside(Id near, Id slot, bool isLeft) const
{
  const bool isForth = this->Chains.Nexts[near] == slot;
  const Id first = isForth ? near : slot;
  const Id segment = this->Chains.Segments[first];
  const bool isAlong = this->Drawing.Starts[segment] == this->Chains.Vertices[first];
  const bool isLeftOfSegment = isLeft == (isForth == isAlong);
  return (isLeftOfSegment ? this->Drawing.LeftInside : this->Drawing.RightInside)[segment] != 0;
}

} // namespace biting
