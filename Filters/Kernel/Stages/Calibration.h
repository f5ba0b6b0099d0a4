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

/// An estimate of the mesh, made before it.
struct Forecast
{
  double Density = 0.0; ///< integral of 1/f^2
  double Vertices = 0.0;
};

/// Integrates over the domain and its segments. Where the monitor wants to stop the result has no
/// meaning.
Forecast MakeForecast(const Domain& domain, const DomainLocator& locator, const Spacing& spacing,
  const BitingOptions& options, Monitor& monitor);

/// Of the time of biting so many vertices, with its calibration: what that takes.
double ShareOfTrials(const BitingOptions& options, double vertices);

/// The biting constant for which the mean edge length is f, where that is wanted
/// (BitingOptions::FollowSlope).
///
/// Squares at corners pack in rows along straight sides and at random elsewhere; the mean length
/// differs by 15 % between the two, so no one constant serves all domains. Trial meshes of the same
/// domain with a coarser spacing k f, of half as many vertices as the mesh, but not below 600 nor
/// above 6000, show which it is: at most two, each corrects the constant by the mean length that it
/// finds between inner vertices. Where a trial has too few of these to tell, and with Bisectors,
/// the constant stays that of the options.
/// Cost: that of a raw mesh, at most of a few thousand vertices; none with Bisectors.
double CalibrateBitingConstant(const Domain& domain, const DomainLocator& locator,
  const Spacing& spacing, double integratedDensity, const BitingOptions& options, Monitor& monitor);

} // namespace biting

#endif
