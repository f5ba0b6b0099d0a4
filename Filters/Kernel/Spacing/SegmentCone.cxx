// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SegmentCone.h"

#include "SourceSlopes.h"

#include <limits> // for infinity

namespace biting
{

namespace
{

/// The slope with which the smallest value grows to the largest one over a distance of itself.
double SlopeWithinAnEdge(const SegmentSource& source)
{
  double least = std::numeric_limits<double>::infinity();
  double most = 0.0;
  for (const Id point : source.Segments)
  {
    const double value = source.Values[static_cast<std::size_t>(point)];
    least = std::min(least, value);
    most = std::max(most, value);
  }
  return (most - least) / least;
}

} // namespace

SegmentCone::SegmentCone(
  const Point2& start, const Point2& end, double startValue, double endValue, double gradation)
{
  const bool isRising = !(endValue < startValue);
  const Point2& low = isRising ? start : end;
  const Point2& high = isRising ? end : start;
  const double rise = std::abs(endValue - startValue);
  this->Start = low;
  this->Value = std::min(startValue, endValue);
  const double length = Distance(start, end);
  const double steepness = rise / (gradation * length);
  if (steepness < 1.0)
  {
    this->Direction = { (high.X - low.X) / length, (high.Y - low.Y) / length };
    this->Length = length;
    this->Slope = steepness * gradation;
    this->Lean = steepness / std::sqrt((1.0 - steepness) * (1.0 + steepness));
  }
}

std::vector<SegmentCone> MakeCones(
  const SegmentSource& source, double scale, double gradation, Pulse& pulse)
{
  std::vector<SegmentCone> cones;
  cones.reserve(source.Segments.size() / 2);
  for (std::size_t first = 0; first + 1 < source.Segments.size() && pulse.Beat(); first += 2)
  {
    const auto a = static_cast<std::size_t>(source.Segments[first]);
    const auto b = static_cast<std::size_t>(source.Segments[first + 1]);
    cones.emplace_back(source.Points[a], source.Points[b], scale * source.Values[a],
      scale * source.Values[b], gradation);
  }
  return cones;
}

std::vector<SegmentCone> ConesBelow(const std::vector<SegmentCone>& cones,
  const std::function<double(const Point2&)>& most, Pulse& pulse)
{
  constexpr int Parts = 4;
  std::vector<SegmentCone> below;
  for (std::size_t k = 0; k < cones.size() && pulse.Beat(16); ++k)
  {
    const SegmentCone& cone = cones[k];
    const int parts = cone.Length > 0.0 ? Parts : 0;
    bool isBelow = false;
    for (int part = 0; part <= parts && !isBelow; ++part)
    {
      const double along = cone.Length * part / Parts;
      isBelow = cone.Value + cone.Slope * along < most(cone.Start + along * cone.Direction);
    }
    if (isBelow)
    {
      below.push_back(cone);
    }
  }
  return below;
}

double SlopeOfCones(const SegmentSource& source, double gradation)
{
  const double slope =
    gradation > 0.0 ? gradation : std::min(LargestSlope(source), SlopeWithinAnEdge(source));
  return slope > 0.0 ? slope : SpacingOptions().Gradation;
}

} // namespace biting
