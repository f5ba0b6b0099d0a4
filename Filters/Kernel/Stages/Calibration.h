// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingCalibration_h
#define BitingCalibration_h

#include "../Base/Monitor.h"
#include "../Biting/BitingScheme.h"
#include "../Domain/Domain.h"
#include "../Domain/DomainLocator.h"
#include "../Spacing/Spacing.h"

namespace biting
{

/// The biting constant for which the mean edge length is f.
///
/// With Bisectors it is AutomaticBitingConstant, to be used with BitingOptions::FollowSlope.
/// Squares at corners pack in rows along straight sides and at random elsewhere; the mean length
/// differs by 15 % between the two, so no one constant serves all domains. Trial meshes of the same
/// domain with a coarser spacing k f, of half as many vertices as the mesh, but not below 600 nor
/// above 6000, show which it is: at most two, each corrects the constant by the mean length that it
/// finds between inner vertices. Where a trial has too few of these to tell, the constant stays
/// that of AutomaticBitingConstant.
/// Cost: that of a raw mesh, at most of a few thousand vertices; none with Bisectors.
double CalibrateBitingConstant(const Domain& domain, const DomainLocator& locator,
  const Spacing& spacing, double integratedDensity, const BitingOptions& options, Monitor& monitor);

} // namespace biting

#endif
