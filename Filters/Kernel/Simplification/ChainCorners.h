// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingChainCorners_h
#define BitingChainCorners_h

#include "../Base/Ids.h"
#include "../Base/Pulse.h"
#include "../Domain/Domain.h"
#include "DomainChains.h"

#include <functional> // for the order of equals
#include <vector>     // for the arrays

namespace biting
{

constexpr double AngleStep = 1e-6; ///< degrees: angles nearer to each other are equal

/// How a corner is seen.
struct CornerView
{
  const std::vector<double>& Tolerances; ///< of each vertex of the domain
  double Angle;                          ///< degrees of turning, from which it is one
  std::function<bool(Id, Id)> IsFirst;   ///< the order of slots that turn equally
};

/// The slots of `chains` at which they turn by Angle or more, seen from a distance of four
/// tolerances: between where the chain left the circle around the vertex before, and where it
/// leaves it after. At that distance a zigzag that a tolerance hides turns by less than 25 degrees.
/// Of several corners within one circle the one that turns most counts. The boundary is followed
/// past junctions and ends of tags: so a corner of the domain stays however near a junction is.
std::vector<Id> FindCorners(
  const Domain& domain, const DomainChains& chains, const CornerView& view, Pulse& pulse);

} // namespace biting

#endif
