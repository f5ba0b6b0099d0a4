// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "PreparedSpacing.h"

#include "../Base/PartOfStage.h"
#include "PreservedSpacing.h"
#include "RaisedSpacing.h"
#include "StageProblems.h"

#include <utility> // for move

namespace biting
{

namespace
{

// Where the step ends, as a share of the time.
constexpr double ChoiceEnd = 0.05;

// The features may be none.
SpacingOptions ChooseSpacing(const BitingMeshOptions& options, const Domain& domain,
  std::shared_ptr<const FeatureSource> features, ProblemList& problems, Monitor& monitor)
{
  SpacingOptions spacing = RaiseToRounding(options.Spacing, domain, problems);
  if (options.PreserveBoundary)
  {
    return FollowSegments(spacing, domain, monitor);
  }
  spacing.Features = std::move(features);
  return spacing;
}

} // namespace

Spacing PrepareSpacing(const BitingMeshOptions& options, const Domain& domain,
  std::shared_ptr<const FeatureSource> features, ProblemList& problems, Monitor& monitor)
{
  PartOfStage choosing(monitor, 0.0, ChoiceEnd);
  SpacingOptions wanted = ChooseSpacing(options, domain, std::move(features), problems, choosing);
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
  BitingMeshOptions given = options;
  given.PreserveBoundary = false;
  return PrepareSpacing(given, drawing, nullptr, problems, monitor);
}

} // namespace biting
