// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingForecast_h
#define BitingForecast_h

#include "../Base/Monitor.h"
#include "../Biting/BitingScheme.h"
#include "../Biting/VertexEstimate.h"
#include "../Domain/Domain.h"
#include "../Domain/DomainLocator.h"
#include "../Spacing/Spacing.h"

namespace biting
{

/// What is known of the mesh beforehand.
struct Forecast
{
  double Density = 0.0; ///< integral of 1/f^2
  double Vertices = 0.0;
};

/// Integrates over the domain and its segments. Where the monitor wants to stop the result has no
/// meaning.
Forecast MakeForecast(const Domain& domain, const DomainLocator& locator, const Spacing& spacing,
  const BitingOptions& options, EstimateEffort effort, Monitor& monitor);

/// Of the time of biting so many vertices, with its calibration: what that takes.
double ShareOfTrials(const BitingOptions& options, double vertices);

} // namespace biting

#endif
