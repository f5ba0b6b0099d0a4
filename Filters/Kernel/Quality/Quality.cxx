// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Quality.h"

#include "NearestNeighbors.h"

#include <algorithm> // for min, max
#include <cmath>     // for atan2, abs, sqrt
#include <limits>    // for infinity

namespace biting
{

namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr double DegreesPerRadian = 57.295779513082320876798154814105;

// A triangle up to motion: its squared sides in ascending order, and twice its area.
struct Shape
{
  double Shortest;
  double Middle;
  double Longest;
  double DoubledArea;
};

Shape ShapeOf(const Point2& a, const Point2& b, const Point2& c)
{
  const Point2 ab = b - a;
  const Point2 ac = c - a;
  const Point2 bc = c - b;
  const double low = std::min(Dot(ab, ab), Dot(ac, ac));
  const double high = std::max(Dot(ab, ab), Dot(ac, ac));
  const double third = Dot(bc, bc);
  return { std::min(low, third), std::max(low, std::min(high, third)), std::max(high, third),
    std::abs(Cross(ab, ac)) };
}

// The smallest angle lies between the two longer sides u and v: tan = |u x v| / u.v. Here u.v, by
// the law of cosines, is a sum without cancellation, as it is at least half the longest square.
double MinimumAngle(const Shape& shape)
{
  const double product = 0.5 * (shape.Longest + (shape.Middle - shape.Shortest));
  return DegreesPerRadian * std::atan2(shape.DoubledArea, product);
}

// R = abc / 4A; the shortest side cancels.
double RadiusEdgeRatio(const Shape& shape)
{
  return shape.DoubledArea > 0.0
    ? std::sqrt(shape.Middle * shape.Longest) / (2.0 * shape.DoubledArea)
    : Infinity;
}

// The smallest circle about an obtuse triangle has the longest side as diameter, about an acute one
// it is the circumcircle. The inscribed circle has the radius 2A / perimeter.
double AspectRatio(const Shape& shape)
{
  if (!(shape.DoubledArea > 0.0))
  {
    return Infinity;
  }
  const double shortest = std::sqrt(shape.Shortest);
  const double middle = std::sqrt(shape.Middle);
  const double longest = std::sqrt(shape.Longest);
  const bool isAcute = shape.Longest < shape.Middle + shape.Shortest;
  const double diameter = isAcute ? shortest * middle * longest / shape.DoubledArea : longest;
  return 0.5 * diameter * (shortest + middle + longest) / shape.DoubledArea;
}

void MeasureTriangles(const MeshView& mesh, MeshQuality& quality)
{
  const std::size_t count = mesh.Corners.size() / 3;
  quality.MinimumAngle.resize(count);
  quality.RadiusEdgeRatio.resize(count);
  quality.AspectRatio.resize(count);
  quality.SmallestAngle = count > 0 ? Infinity : 0.0;
  for (std::size_t t = 0; t < count; ++t)
  {
    const auto place = [&mesh, t](std::size_t corner) -> const Point2&
    { return mesh.Points[static_cast<std::size_t>(mesh.Corners[3 * t + corner])]; };
    const Shape shape = ShapeOf(place(0), place(1), place(2));
    quality.MinimumAngle[t] = MinimumAngle(shape);
    quality.RadiusEdgeRatio[t] = RadiusEdgeRatio(shape);
    quality.AspectRatio[t] = AspectRatio(shape);
    quality.SmallestAngle = std::min(quality.SmallestAngle, quality.MinimumAngle[t]);
    quality.LargestRadiusEdgeRatio =
      std::max(quality.LargestRadiusEdgeRatio, quality.RadiusEdgeRatio[t]);
  }
}

// Length of the edge opposite slot's corner, divided by the mean spacing of its ends.
double RelativeLength(const MeshView& mesh, std::size_t slot)
{
  const std::size_t corner = slot % 3;
  const std::size_t start =
    static_cast<std::size_t>(mesh.Corners[corner == 2 ? slot - 2 : slot + 1]);
  const std::size_t end = static_cast<std::size_t>(mesh.Corners[corner == 0 ? slot + 2 : slot - 1]);
  const double meanSpacing = 0.5 * (mesh.Spacing[start] + mesh.Spacing[end]);
  return Distance(mesh.Points[start], mesh.Points[end]) / meanSpacing;
}

bool IsInBand(double relativeLength)
{
  const double square = relativeLength * relativeLength;
  return square >= 0.5 && square <= 2.0;
}

void MeasureEdges(const MeshView& mesh, MeshQuality& quality)
{
  double sum = 0.0;
  std::int64_t count = 0;
  std::int64_t countInBand = 0;
  for (std::size_t slot = 0; slot < mesh.Corners.size(); ++slot)
  {
    // An inner edge is measured from the triangle with the larger id.
    if (mesh.Neighbors[slot] < static_cast<Id>(slot / 3))
    {
      const double relativeLength = RelativeLength(mesh, slot);
      sum += relativeLength;
      count += 1;
      countInBand += IsInBand(relativeLength) ? 1 : 0;
    }
  }
  if (count > 0)
  {
    quality.MeanRelativeLength = sum / static_cast<double>(count);
    quality.ShareOfEdgesInBand = static_cast<double>(countInBand) / static_cast<double>(count);
  }
}

void MeasureConformity(const MeshView& mesh, MeshQuality& quality)
{
  const std::size_t count = mesh.Points.size();
  quality.Conformity.resize(count);
  quality.SmallestConformity = count > 0 ? Infinity : 0.0;
  double sum = 0.0;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double distance = quality.NearestNeighborDistance[i];
    const double spacing = mesh.Spacing[i];
    quality.Conformity[i] = std::min(distance, spacing) / std::max(distance, spacing);
    quality.SmallestConformity = std::min(quality.SmallestConformity, quality.Conformity[i]);
    sum += quality.Conformity[i];
  }
  quality.MeanConformity = count > 0 ? sum / static_cast<double>(count) : 0.0;
}

} // namespace

MeshQuality MeasureQuality(const MeshView& mesh)
{
  MeshQuality quality;
  quality.NumberOfVertices = static_cast<std::int64_t>(mesh.Points.size());
  quality.NumberOfTriangles = static_cast<std::int64_t>(mesh.Corners.size() / 3);
  MeasureTriangles(mesh, quality);
  MeasureEdges(mesh, quality);
  quality.NearestNeighborDistance =
    NearestNeighborDistances(mesh.Points, mesh.Corners, mesh.Neighbors);
  MeasureConformity(mesh, quality);
  return quality;
}

double MinimumAngle(const Point2& a, const Point2& b, const Point2& c)
{
  return MinimumAngle(ShapeOf(a, b, c));
}

double RadiusEdgeRatio(const Point2& a, const Point2& b, const Point2& c)
{
  return RadiusEdgeRatio(ShapeOf(a, b, c));
}

double AspectRatio(const Point2& a, const Point2& b, const Point2& c)
{
  return AspectRatio(ShapeOf(a, b, c));
}

} // namespace biting
