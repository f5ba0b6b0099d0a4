// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SegmentExtension.h"

#include "SourceSlopes.h"

#include <limits>  // for infinity
#include <utility> // for swap

namespace biting
{
namespace
{

SegmentCone MakeCone(Point2 start, Point2 end, double startValue, double endValue, double gradation)
{
  if (endValue < startValue)
  {
    std::swap(start, end);
    std::swap(startValue, endValue);
  }
  SegmentCone cone;
  cone.Start = start;
  cone.Value = startValue;
  const double length = Distance(start, end);
  const double steepness = (endValue - startValue) / (gradation * length);
  if (steepness < 1.0)
  {
    cone.Direction = { (end.X - start.X) / length, (end.Y - start.Y) / length };
    cone.Length = length;
    cone.Slope = steepness * gradation;
    cone.Lean = steepness / std::sqrt((1.0 - steepness) * (1.0 + steepness));
  }
  return cone;
}

double UsedGradation(const SegmentSource& source, double gradation)
{
  const double slope = gradation > 0.0 ? gradation : LargestSlope(source);
  return slope > 0.0 ? slope : SpacingOptions().Gradation;
}

} // namespace

SegmentExtension MakeExtension(const SegmentSource& source, double gradation)
{
  SegmentExtension extension;
  extension.Gradation = UsedGradation(source, gradation);
  extension.Cones.reserve(source.Segments.size() / 2);
  for (std::size_t first = 0; first + 1 < source.Segments.size(); first += 2)
  {
    const auto a = static_cast<std::size_t>(source.Segments[first]);
    const auto b = static_cast<std::size_t>(source.Segments[first + 1]);
    extension.Cones.push_back(MakeCone(
      source.Points[a], source.Points[b], source.Values[a], source.Values[b], extension.Gradation));
  }
  return extension;
}

double SegmentExtension::operator()(const Point2& x) const
{
  double least = std::numeric_limits<double>::infinity();
  for (const SegmentCone& cone : this->Cones)
  {
    least = std::min(least, cone(x, this->Gradation));
  }
  return least;
}

} // namespace biting
