// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "PreparedInput.h"

#include "../Base/Monitor.h"
#include "../Base/Pulse.h"
#include "../Spacing/SegmentCone.h"
#include "StageProblems.h"

#include <algorithm>  // for min, transform
#include <functional> // for floors
#include <limits>     // for the largest number
#include <memory>     // for sources
#include <optional>   // for what is made once
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

constexpr double GivenSpacingEnd = 0.3; // of the time

// The spacing before gradation and any limit by feature size, made where it is first asked for.
// Problems of it are told later, by PrepareSpacing.
std::function<double(const Point2&)> SpacingAsGiven(
  const Polylines& input, const BitingMeshOptions& options, Monitor& monitor)
{
  auto made = std::make_shared<std::optional<Spacing>>();
  return [&input, &options, &monitor, made](const Point2& x)
  {
    if (!*made)
    {
      const Box2 bounds = Box2::Around(input.Points, input.Connectivity);
      SpacingOptions given = options.Spacing;
      given.Gradation = 0.0;
      ProblemList unheard;
      PartOfStage standing(monitor, 0.0, 0.0);
      made->emplace(MakeSpacing(given, bounds, unheard, standing));
    }
    return (**made)(x);
  };
}

SimplifiedDomain Reduce(
  Domain drawing, const BitingMeshOptions& options, ProblemList& problems, Monitor& monitor)
{
  SimplificationOptions wanted = options.Simplification;
  wanted.Tolerance = options.PreserveBoundary ? 0.0 : wanted.Tolerance;
  SimplifiedDomain result;
  if (!wanted.IsAsked())
  {
    result.Drawing = std::move(drawing);
    return result;
  }
  PartOfStage preparing(monitor, 0.0, GivenSpacingEnd);
  const Spacing given = PrepareGivenSpacing(options, drawing, problems, preparing);
  if (!AddAborted(preparing, problems) && !problems.HasErrors())
  {
    PartOfStage simplifying(monitor, GivenSpacingEnd, 1.0);
    result = Simplify(
      drawing, wanted, [&given](const Point2& x) { return given(x); }, problems, simplifying);
  }
  return result;
}

// Where steps end, as shares of the time.
constexpr double CheckEnd = 0.1;
constexpr double FilingEnd = 0.4;

bool IsValid(const SpacingOptions& spacing, Monitor& monitor)
{
  ProblemList problems;
  return CheckSpacing(spacing, problems, monitor);
}

void ApplyScale(SpacingOptions& spacing)
{
  if (spacing.Scale != 1.0)
  {
    const auto scaled = [scale = spacing.Scale](const auto& source) -> GivenSource
    {
      auto copy = std::make_shared<std::decay_t<decltype(*source)>>(*source);
      std::transform(copy->Values.begin(), copy->Values.end(), copy->Values.begin(),
        [scale](double value) { return scale * value; });
      return copy;
    };
    spacing.Uniform = std::min(spacing.Scale * spacing.Uniform, std::numeric_limits<double>::max());
    for (GivenSource& source : spacing.Sources)
    {
      source = std::visit(scaled, source);
    }
    spacing.Scale = 1.0;
  }
}

// Adds each segment of the domain, with its length along all of it.
void AddLengths(const Domain& domain, SegmentSource& source)
{
  for (Id segment = 0; segment < domain.NumberOfSegments(); ++segment)
  {
    const Point2& start = domain.Vertices[domain.Starts[segment]];
    const Point2& end = domain.Vertices[domain.Ends[segment]];
    for (const Point2& point : { start, end })
    {
      source.Segments.push_back(static_cast<Id>(source.Points.size()));
      source.Points.push_back(point);
      source.Values.push_back(Distance(start, end));
    }
  }
}

void AddPoint(const Point2& point, double value, SegmentSource& source)
{
  const Id id = static_cast<Id>(source.Points.size());
  source.Points.push_back(point);
  source.Values.push_back(value);
  source.Segments.insert(source.Segments.end(), 2, id);
}

// Whether anything but the lengths can make the spacing small.
bool IsAsked(const SpacingOptions& spacing)
{
  return spacing.Uniform > 0.0 || spacing.Maximum > 0.0 || !spacing.Sources.empty();
}

// Points only: between them L may be lower than on a straight line.
std::shared_ptr<const SegmentSource> MakeFloor(
  const SegmentSource& lengths, const Domain& domain, double gradation, Monitor& monitor)
{
  PartOfStage filing(monitor, 0.0, FilingEnd);
  Pulse filed(filing);
  const SegmentExtension extension(MakeCones(lengths, 1.0, gradation, filed), gradation, filed);
  PartOfStage evaluating(monitor, FilingEnd, 1.0);
  Pulse pulse(evaluating);
  if (filing.HasStopped())
  {
    return nullptr;
  }
  auto floor = std::make_shared<SegmentSource>();
  for (Id vertex = 0; vertex < domain.NumberOfVertices() && pulse.Beat(64); ++vertex)
  {
    if (!domain.IsEmbedded[vertex])
    {
      AddPoint(domain.Vertices[vertex], extension(domain.Vertices[vertex]), *floor);
    }
  }
  for (Id segment = 0; segment < domain.NumberOfSegments() && pulse.Beat(64); ++segment)
  {
    pulse.SetFraction(static_cast<double>(segment) / domain.NumberOfSegments());
    const Point2 middle =
      Midpoint(domain.Vertices[domain.Starts[segment]], domain.Vertices[domain.Ends[segment]]);
    AddPoint(middle, extension(middle), *floor);
  }
  return floor;
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

Domain ReadDrawing(
  const Polylines& input, const BitingMeshOptions& options, ProblemList& problems, Monitor& monitor)
{
  DomainOptions wanted = options.Domain;
  wanted.GivenSpacing = SpacingAsGiven(input, options, monitor);
  return MakeDomain(input, wanted, problems, monitor);
}

SimplifiedDomain SimplifyDrawing(
  Domain drawing, const BitingMeshOptions& options, ProblemList& problems, PartOfStage& part)
{
  SimplifiedDomain result = Reduce(std::move(drawing), options, problems, part);
  const Id vertices = result.Drawing.NumberOfVertices();
  if (!part.HasStopped() && vertices > options.MaximumNumberOfVertices)
  {
    AddProblem(ProblemCode::TooManyVertices,
      "the input alone has " + std::to_string(vertices) + " vertices, the limit is " +
        std::to_string(options.MaximumNumberOfVertices),
      problems);
  }
  return result;
}

// What is refused anyway is left as it is.
SpacingOptions FollowSegments(SpacingOptions spacing, const Domain& domain, Monitor& monitor)
{
  PartOfStage checking(monitor, 0.0, CheckEnd);
  if (!IsValid(spacing, checking) || checking.HasStopped())
  {
    return spacing;
  }
  spacing.Gradation = spacing.Gradation == 0.0 ? SpacingOptions().Gradation : spacing.Gradation;
  ApplyScale(spacing);
  auto lengths = std::make_shared<SegmentSource>();
  AddLengths(domain, *lengths);
  PartOfStage raising(monitor, CheckEnd, 1.0);
  spacing.Floor =
    IsAsked(spacing) ? MakeFloor(*lengths, domain, spacing.Gradation, raising) : nullptr;
  spacing.Sources.emplace_back(std::move(lengths));
  return spacing;
}

} // namespace biting
