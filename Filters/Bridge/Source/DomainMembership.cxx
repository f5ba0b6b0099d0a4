// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "DomainMembership.h"

#include "../../Kernel/Base/Monitor.h"
#include "../../Kernel/Predicates/Predicates.h"

namespace biting
{

DomainMembership::DomainMembership(const Polylines& chains, Monitor& monitor, DomainRule rule)
  : Chains(chains)
  , Asked(monitor)
  , Rule(rule)
{
}

bool DomainMembership::MayHold(const Point2& place)
{
  if (!this->IsMade)
  {
    this->IsMade = true;
    PartOfStage part(this->Asked, 0.0, 0.0);
    ProblemList unreported; // the mesh will be made of the same chains
    DomainOptions options;
    options.Rule = this->Rule;
    this->Domain = MakeDomain(this->Chains, options, unreported, part);
    Pulse pulse(part);
    if (this->Domain.NumberOfSegments() > 0 && !part.HasStopped())
    {
      this->Locator.emplace(this->Domain, pulse);
    }
  }
  return !this->Locator || this->Locator->IsInside(place) || this->IsOnBoundary(place);
}

bool DomainMembership::IsOnBoundary(const Point2& place) const
{
  if (!this->Domain.Bounds.Contains(place))
  {
    return false; // most places of a source that reaches far beyond, and those that are not finite
  }
  return this->Locator->VisitSegments(Box2::Around(place, place),
    [this, &place](Id segment)
    {
      return IsOnSegment(place, this->Domain.Vertices[this->Domain.Starts[segment]],
        this->Domain.Vertices[this->Domain.Ends[segment]]);
    });
}

} // namespace biting
