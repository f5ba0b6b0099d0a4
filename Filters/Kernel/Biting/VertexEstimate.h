// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingVertexEstimate_h
#define BitingVertexEstimate_h

#include "../Base/Monitor.h"
#include "../Domain/Domain.h"
#include "../Domain/DomainLocator.h"
#include "../Spacing/Spacing.h"

namespace biting
{

/// The integral of 1/f^2 over the domain, to about 5 % for a spacing that varies slowly; finer than
/// an adaptive quadrature of bounded cost sees, it is too small. Cost independent of the mesh.
/// Where the monitor asks to stop the result has no meaning; so it is with the next one.
double IntegrateDensity(const Domain& domain, const DomainLocator& locator, const Spacing& spacing,
  Monitor& monitor = NoMonitor());

/// How many vertices divide the segments of the domain into parts of `partLength` spacings: the
/// integral of 1/f along each, by a rule of at most 64 points, fewer where there are many segments.
/// Sees a spacing that is fine on the boundary alone, which no quadrature over the domain does.
double EstimateDivisionPoints(
  const Domain& domain, const Spacing& spacing, double partLength, Monitor& monitor = NoMonitor());

} // namespace biting

#endif
