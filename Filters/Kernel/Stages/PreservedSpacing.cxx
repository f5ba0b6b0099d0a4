// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "PreservedSpacing.h"

#include "../Base/PartOfStage.h"
#include "../Base/Pulse.h"
#include "../Spacing/SegmentCone.h"

#include <algorithm> // for min, transform
#include <limits>    // for the largest number
#include <memory>    // for sources
#include <utility>   // for move

namespace biting
{

namespace
{

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
