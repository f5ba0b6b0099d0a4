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

/// A square with a part of the integral of 1/f^2 over a domain.
struct DensitySample
{
  Point2 Place;         ///< its centre
  double Area = 0.0;    ///< of the domain in it
  double Density = 0.0; ///< the integral over that
};

/// How fine squares are.
struct SampleLimits
{
  double Most = 0.0;          ///< of the integral in one
  std::size_t MostVisits = 0; ///< after so many squares the others stay as large as they are
  int LeastDepth = 5;         ///< halvings of the box of the domain
};

/// Squares of a quadtree that have at most about `limits.Most` of the integral each, but are not
/// smaller than 2^-16 of the box of the domain; those without any are left out. Depends on the
/// arguments alone. Where the monitor wants to stop the result has no meaning.
std::vector<DensitySample> SampleDensity(const Domain& domain, const DomainLocator& locator,
  const Spacing& spacing, const SampleLimits& limits, Pulse& pulse);

} // namespace biting

#endif
