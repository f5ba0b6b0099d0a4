// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Forecast.h"

#include "../Base/PartOfStage.h"

namespace biting
{

namespace
{

constexpr double VerticesOfTrials = 12000.0; // as many as cost the same, roughly

} // namespace

Forecast MakeForecast(const Domain& domain, const DomainLocator& locator, const Spacing& spacing,
  const BitingOptions& options, EstimateEffort effort, Monitor& monitor)
{
  PartOfStage integrating(monitor, 0.0, 0.5);
  const double density = IntegrateDensity(domain, locator, spacing, integrating, effort);
  PartOfStage dividing(monitor, 0.5, 1.0);
  const double divisionPoints =
    options.PreserveBoundary ? 0.0 : EstimateDivisionPoints(domain, spacing, 1.0, dividing, effort);
  return { density,
    EstimateNumberOfVertices(density, options) + domain.NumberOfVertices() + divisionPoints };
}

double ShareOfTrials(const BitingOptions& options, double vertices)
{
  const bool hasTrials = options.BitingConstant == 0.0 && options.Placement == Placement::Corners;
  return hasTrials ? VerticesOfTrials / (VerticesOfTrials + vertices) : 0.0;
}

} // namespace biting
