// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingDensitySamples_h
#define BitingDensitySamples_h

#include "../Base/Point.h"
#include "../Base/Pulse.h"
#include "../Domain/Domain.h"
#include "../Domain/DomainLocator.h"
#include "../Spacing/Spacing.h"

#include <cstddef> // for a number
#include <vector>  // for samples

namespace biting
{

/// A part of the integral of 1/f^2 over a domain, and where it is.
struct DensitySample
{
  Point2 Place;
  double Density = 0.0;
};

/// The leaves of a quadtree over the domain's box, the root at level 0. Squares are divided down to
/// level 5; from there to level 16 while they have more than about `most` of the integral and fewer
/// than `mostVisits` were visited. Squares outside of the domain are left out. Depends on the
/// arguments alone. Where the monitor wants to stop the result has no meaning.
std::vector<DensitySample> SampleDensity(const Domain& domain, const DomainLocator& locator,
  const Spacing& spacing, double most, std::size_t mostVisits, Pulse& pulse);

} // namespace biting

#endif
