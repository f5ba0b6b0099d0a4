// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Quality.h"

#include "../Base/PartOfStage.h"
#include "../Base/Pulse.h"
#include "NearestNeighbors.h"

#include <algorithm> // for min, max
#include <cmath>     // for atan2, abs, sqrt
#include <limits>    // for infinity
#include <utility>   // for move

namespace biting
{

namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr double DegreesPerRadian = 57.295779513082320876798154814105;

// Where steps end, as shares of the time: of all, and of what follows the neighbors.
constexpr double NeighborsEnd = 0.4;
constexpr double TrianglesEnd = 0.5;
constexpr double EdgesEnd = 0.8;

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

void MeasureTriangles(const MeshView& mesh, MeshQuality& quality, Pulse& pulse)
{
  const PulsePart part(pulse, 0.0, TrianglesEnd);
  const std::size_t count = mesh.Corners.size() / 3;
  for (auto* array : { &quality.MinimumAngle, &quality.RadiusEdgeRatio, &quality.AspectRatio })
  {
    GrowInSteps(*array, count, 0.0, pulse);
  }
  quality.SmallestAngle = count > 0 ? Infinity : 0.0;
  pulse.ForEach(count,
    [&mesh, &quality](std::size_t t)
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
    });
}

// The ends of the edge opposite a slot's corner.
struct EdgeEnds
{
  std::size_t Start;
  std::size_t End;
};

EdgeEnds EndsOf(const MeshView& mesh, std::size_t slot)
{
  const std::size_t corner = slot % 3;
  return { static_cast<std::size_t>(mesh.Corners[corner == 2 ? slot - 2 : slot + 1]),
    static_cast<std::size_t>(mesh.Corners[corner == 0 ? slot + 2 : slot - 1]) };
}

// Calls visit(edge, ends) for each edge, numbered in the order in which they are found. An inner
// edge is met at the triangle with the larger id.
template <typename Visit>
void ForEachEdge(const MeshView& mesh, Pulse& pulse, const Visit& visit)
{
  std::size_t edge = 0;
  pulse.ForEach(mesh.Corners.size(),
    [&mesh, &visit, &edge](std::size_t slot)
    {
      if (mesh.Neighbors[slot] < static_cast<Id>(slot / 3))
      {
        visit(edge, EndsOf(mesh, slot));
        ++edge;
      }
    });
}

double LengthOf(const MeshView& mesh, const EdgeEnds& ends)
{
  return Distance(mesh.Points[ends.Start], mesh.Points[ends.End]);
}

double RelativeLength(const MeshView& mesh, std::size_t edge, const EdgeEnds& ends)
{
  const double spacing = mesh.MiddleSpacing
    ? (*mesh.MiddleSpacing)[edge]
    : 0.5 * (mesh.Spacing[ends.Start] + mesh.Spacing[ends.End]);
  return LengthOf(mesh, ends) / spacing;
}

bool IsInBand(double relativeLength)
{
  const double square = relativeLength * relativeLength;
  return square >= 0.5 && square <= 2.0;
}

void MeasureEdges(const MeshView& mesh, MeshQuality& quality, Pulse& pulse)
{
  const PulsePart part(pulse, TrianglesEnd, EdgesEnd);
  double sum = 0.0;
  std::int64_t count = 0;
  std::int64_t countInBand = 0;
  ForEachEdge(mesh, pulse,
    [&mesh, &sum, &count, &countInBand](std::size_t edge, const EdgeEnds& ends)
    {
      const double relativeLength = RelativeLength(mesh, edge, ends);
      sum += relativeLength;
      count += 1;
      countInBand += IsInBand(relativeLength) ? 1 : 0;
    });
  if (count > 0)
  {
    quality.MeanRelativeLength = sum / static_cast<double>(count);
    quality.ShareOfEdgesInBand = static_cast<double>(countInBand) / static_cast<double>(count);
  }
}

void MeasureConformity(const MeshView& mesh, MeshQuality& quality, Pulse& pulse)
{
  const PulsePart part(pulse, EdgesEnd, 1.0);
  const std::size_t count = mesh.Points.size();
  quality.Conformity.resize(count);
  quality.SmallestConformity = count > 0 ? Infinity : 0.0;
  double sum = 0.0;
  pulse.ForEach(count,
    [&mesh, &quality, &sum](std::size_t i)
    {
      const double distance = quality.NearestNeighborDistance[i];
      const double spacing = mesh.Spacing[i];
      quality.Conformity[i] = std::min(distance, spacing) / std::max(distance, spacing);
      quality.SmallestConformity = std::min(quality.SmallestConformity, quality.Conformity[i]);
      sum += quality.Conformity[i];
    });
  quality.MeanConformity = count > 0 ? sum / static_cast<double>(count) : 0.0;
}

} // namespace

MeshQuality MeasureQuality(const MeshView& mesh, Monitor& monitor)
{
  PartOfStage searching(monitor, 0.0, NeighborsEnd);
  std::vector<double> distances =
    NearestNeighborDistances(mesh.Points, mesh.Corners, mesh.Neighbors, searching);
  PartOfStage rest(monitor, NeighborsEnd, 1.0);
  return searching.HasStopped() ? MeshQuality() : MeasureQuality(mesh, std::move(distances), rest);
}

MeshQuality MeasureQuality(
  const MeshView& mesh, std::vector<double> nearestNeighborDistances, Monitor& monitor)
{
  Pulse pulse(monitor);
  MeshQuality quality;
  quality.NumberOfVertices = static_cast<std::int64_t>(mesh.Points.size());
  quality.NumberOfTriangles = static_cast<std::int64_t>(mesh.Corners.size() / 3);
  MeasureTriangles(mesh, quality, pulse);
  MeasureEdges(mesh, quality, pulse);
  quality.NearestNeighborDistance = std::move(nearestNeighborDistances);
  MeasureConformity(mesh, quality, pulse);
  return quality;
}

std::vector<Point2> EdgeMiddles(const MeshView& mesh, Monitor& monitor)
{
  Pulse pulse(monitor);
  std::vector<Point2> middles;
  ForEachEdge(mesh, pulse,
    [&mesh, &middles](std::size_t, const EdgeEnds& ends)
    { middles.push_back(Midpoint(mesh.Points[ends.Start], mesh.Points[ends.End])); });
  return middles;
}

std::vector<double> RelativeLengths(const MeshView& mesh, Monitor& monitor)
{
  Pulse pulse(monitor);
  std::vector<double> lengths;
  ForEachEdge(mesh, pulse,
    [&mesh, &lengths](std::size_t edge, const EdgeEnds& ends)
    { lengths.push_back(RelativeLength(mesh, edge, ends)); });
  return lengths;
}

std::vector<double> AnglesOf(const MeshView& mesh, Monitor& monitor)
{
  Pulse pulse(monitor);
  std::vector<double> angles;
  angles.reserve(mesh.Corners.size());
  pulse.ForEach(mesh.Corners.size(),
    [&mesh, &angles](std::size_t slot)
    {
      const EdgeEnds ends = EndsOf(mesh, slot);
      const Point2& apex = mesh.Points[static_cast<std::size_t>(mesh.Corners[slot])];
      const Point2 first = mesh.Points[ends.Start] - apex;
      const Point2 second = mesh.Points[ends.End] - apex;
      angles.push_back(
        DegreesPerRadian * std::atan2(std::abs(Cross(first, second)), Dot(first, second)));
    });
  return angles;
}

double LargestSlope(const MeshView& mesh, Monitor& monitor)
{
  Pulse pulse(monitor);
  double largest = 0.0;
  ForEachEdge(mesh, pulse,
    [&mesh, &largest](std::size_t, const EdgeEnds& ends)
    {
      const double length = LengthOf(mesh, ends);
      const double rise = std::abs(mesh.Spacing[ends.Start] - mesh.Spacing[ends.End]);
      largest = length > 0.0 ? std::max(largest, rise / length) : largest;
    });
  return largest;
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
