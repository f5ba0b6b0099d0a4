// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "PreparedSpacing.h"

#include "../Base/PartOfStage.h"
#include "PreservedSpacing.h"
#include "StageProblems.h"

#include <functional> // for floors
#include <memory>     // for sources
#include <utility>    // for move

namespace biting
{

namespace
{

// Where the step ends, as a share of the time.
constexpr double ChoiceEnd = 0.05;

SpacingOptions RaiseToRounding(SpacingOptions spacing, const Domain& domain, ProblemList& problems)
{
  const double rounding = domain.Resolution;
  const bool isBelow = spacing.Minimum >= 0.0 && spacing.Minimum < rounding;
  const bool isFree = spacing.Maximum == 0.0 || spacing.Maximum > rounding;
  if (!isBelow || !isFree)
  {
    return spacing;
  }
  spacing.Minimum = rounding;
  const double least = spacing.Scale * LeastGiven(spacing);
  if (least < rounding && !problems.Has(ProblemCode::RaisedSpacing))
  {
    AddProblem(
      ProblemCode::RaisedSpacing, Figure(least) + " is raised to " + Figure(rounding), problems);
  }
  return spacing;
}

// With their lengths; none without ends.
std::shared_ptr<const SegmentSource> DrawnSegments(const std::vector<Point2>& ends)
{
  auto segments = std::make_shared<SegmentSource>();
  segments->Points = ends;
  for (std::size_t end = 0; end < ends.size(); ++end)
  {
    segments->Segments.push_back(static_cast<Id>(end));
    segments->Values.push_back(Distance(ends[end], ends[end ^ 1]));
  }
  return ends.empty() ? nullptr : segments;
}

// The segments and embedded points of a domain.
std::shared_ptr<const FeatureSource> FeaturesOf(const SimplifiedDomain& simplified,
  const BitingMeshOptions& options, std::function<double(const Point2&)> floor)
{
  const Domain& domain = simplified.Drawing;
  auto features = std::make_shared<FeatureSource>();
  features->Points = domain.Vertices;
  features->CellsAcross = options.CellsAcross;
  features->IsDownToMinimum = options.CellsAcross > 1 && options.Spacing.Minimum > 0.0;
  features->MostPieces = 2.0 * static_cast<double>(options.MaximumNumberOfVertices); // two an edge
  features->Starts = domain.Starts;
  features->Ends = domain.Ends;
  features->LeftInside = domain.LeftInside;
  features->RightInside = domain.RightInside;
  features->Floor = std::move(floor);
  features->Drawn = DrawnSegments(simplified.DrawnEnds);
  for (Id vertex = 0; vertex < domain.NumberOfVertices(); ++vertex)
  {
    if (domain.IsEmbedded[vertex])
    {
      features->Starts.push_back(vertex);
      features->Ends.push_back(vertex);
      features->LeftInside.push_back(1);
      features->RightInside.push_back(1);
    }
  }
  return features;
}

Spacing MakeChosen(const SpacingOptions& wanted, const Domain& domain, const PartOfStage& choosing,
  ProblemList& problems, Monitor& monitor)
{
  if (AddAborted(choosing, problems))
  {
    return {};
  }
  PartOfStage making(monitor, ChoiceEnd, 1.0);
  return MakeSpacing(wanted, domain.Bounds, problems, making);
}

} // namespace

Spacing PrepareSpacing(const BitingMeshOptions& options, const SimplifiedDomain& simplified,
  ProblemList& problems, Monitor& monitor, std::function<double(const Point2&)> floor)
{
  const Domain& domain = simplified.Drawing;
  PartOfStage choosing(monitor, 0.0, ChoiceEnd);
  SpacingOptions wanted = RaiseToRounding(options.Spacing, domain, problems);
  if (options.PreserveBoundary)
  {
    wanted = FollowSegments(std::move(wanted), domain, choosing);
  }
  else
  {
    wanted.Features =
      options.LimitByFeatureSize ? FeaturesOf(simplified, options, std::move(floor)) : nullptr;
  }
  return MakeChosen(wanted, domain, choosing, problems, monitor);
}

Spacing PrepareGivenSpacing(
  const BitingMeshOptions& options, const Domain& drawing, ProblemList& problems, Monitor& monitor)
{
  const PartOfStage choosing(monitor, 0.0, ChoiceEnd);
  SpacingOptions wanted = RaiseToRounding(options.Spacing, drawing, problems);
  wanted.Features = nullptr;
  return MakeChosen(wanted, drawing, choosing, problems, monitor);
}

} // namespace biting
