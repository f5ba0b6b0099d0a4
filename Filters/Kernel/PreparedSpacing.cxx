// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "PreparedSpacing.h"

#include "Base/PartOfStage.h"
#include "Base/Pulse.h"
#include "Meshing/DomainFeatures.h"
#include "Meshing/PreservedSpacing.h"
#include "Meshing/StageProblems.h"
#include "RaisedSpacing.h"

#include <utility> // for move

namespace biting
{

namespace
{

// Where steps end, as shares of the time.
constexpr double LocatorEnd = 0.05;
constexpr double ChoiceEnd = 0.05;

// The features may be none.
SpacingOptions ChooseSpacing(const BitingMeshOptions& options, const Domain& domain,
  std::shared_ptr<const FeatureSource> features, const DomainLocator& locator,
  ProblemList& problems, Monitor& monitor)
{
  SpacingOptions spacing = RaiseToRounding(options.Spacing, domain, problems);
  if (options.PreserveBoundary)
  {
    return FollowSegments(spacing, domain, monitor);
  }
  spacing.Features = std::move(features);
  spacing.IsUnused = OutsideOf(locator);
  return spacing;
}

} // namespace

Spacing PrepareSpacing(const BitingMeshOptions& options, const Domain& domain,
  std::shared_ptr<const FeatureSource> features, const DomainLocator& locator,
  ProblemList& problems, Monitor& monitor)
{
  PartOfStage choosing(monitor, 0.0, ChoiceEnd);
  SpacingOptions wanted =
    ChooseSpacing(options, domain, std::move(features), locator, problems, choosing);
  if (AddAborted(choosing, problems))
  {
    return {};
  }
  PartOfStage making(monitor, ChoiceEnd, 1.0);
  return MakeSpacing(wanted, domain.Bounds, problems, making);
}

Spacing PrepareGivenSpacing(
  const BitingMeshOptions& options, const Domain& drawing, ProblemList& problems, Monitor& monitor)
{
  const SpacingOptions& spacing = options.Spacing;
  if (!spacing.Grid && !spacing.Triangulation && !spacing.Segments)
  {
    return MakeSpacing(
      RaiseToRounding(spacing, drawing, problems), drawing.Bounds, problems, monitor);
  }
  BitingMeshOptions given = options;
  given.PreserveBoundary = false;
  PartOfStage locating(monitor, 0.0, LocatorEnd);
  Pulse pulse(locating);
  const DomainLocator locator(drawing, pulse);
  PartOfStage preparing(monitor, LocatorEnd, 1.0);
  return locating.HasStopped()
    ? Spacing()
    : PrepareSpacing(given, drawing, nullptr, locator, problems, preparing);
}

} // namespace biting
