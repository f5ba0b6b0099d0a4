// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Quality.h"

#include "../Base/Monitor.h"
#include "../Base/Numbers.h"
#include "../Base/Pulse.h"
#include "../Base/Tasks.h"

#include <algorithm> // for min, max
#include <array>     // for a list of arrays
#include <atomic>    // for what threads share
#include <cmath>     // for atan, atan2, abs, sqrt

namespace biting
{

namespace
{

// Where the triangles end, as a share of the time.
constexpr double TrianglesEnd = 0.8;

// The least of the values told for each of `count` vertices, infinite at first; from several
// threads.
class LeastValues
{
public:
  LeastValues(std::size_t count, Pulse& pulse)
    : Values(count)
  {
    ForEachAtOnce(pulse, count, [this](std::size_t k) { this->Values[k] = Infinity; });
  }

  double operator[](std::size_t k) const { return this->Values[k].load(std::memory_order_relaxed); }

  void Lower(Id vertex, double value)
  {
    std::atomic<double>& least = this->Values[vertex];
    double known = least.load(std::memory_order_relaxed);
    while (value < known && !least.compare_exchange_weak(known, value, std::memory_order_relaxed))
    {
    }
  }

private:
  std::vector<std::atomic<double>> Values;
};

// A triangle up to motion: its squared sides in ascending order, and twice its area.
struct Shape
{
  double Shortest;
  double Middle;
  double Longest;
  double DoubledArea;
};

// The squared lengths of the sides opposite each corner.
std::array<double, 3> SquaredSides(const Point2& a, const Point2& b, const Point2& c)
{
  const Point2 ab = b - a;
  const Point2 ac = c - a;
  const Point2 bc = c - b;
  return { Dot(bc, bc), Dot(ac, ac), Dot(ab, ab) };
}

Shape ShapeOf(const std::array<double, 3>& squares, double doubledArea)
{
  const double low = std::min(squares[1], squares[2]);
  const double high = std::max(squares[1], squares[2]);
  return { std::min(low, squares[0]), std::max(low, std::min(high, squares[0])),
    std::max(high, squares[0]), std::abs(doubledArea) };
}

Shape ShapeOf(const Point2& a, const Point2& b, const Point2& c)
{
  return ShapeOf(SquaredSides(a, b, c), Cross(b - a, c - a));
}

// The smallest angle lies between the two longer sides u and v: tan = |u x v| / u.v. Here u.v, by
// the law of cosines, is a sum without cancellation, as it is at least half the longest square.
double MinimumAngle(const Shape& shape)
{
  const double product = 0.5 * (shape.Longest + (shape.Middle - shape.Shortest));
  return product > 0.0 ? DegreesPerRadian * std::atan(shape.DoubledArea / product) : 0.0;
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

void MakeRoom(MeshQuality& quality)
{
  const auto triangles = static_cast<std::size_t>(quality.NumberOfTriangles);
  const auto vertices = static_cast<std::size_t>(quality.NumberOfVertices);
  quality.MinimumAngle.resize(triangles);
  quality.RadiusEdgeRatio.resize(triangles);
  quality.AspectRatio.resize(triangles);
  quality.Conformity.resize(vertices);
  quality.NearestNeighborDistance.resize(vertices);
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

// Whether the edge opposite a slot's corner is counted there.
bool IsCounted(const MeshView& mesh, std::size_t slot)
{
  return mesh.Neighbors[slot] < static_cast<Id>(slot / 3);
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
      if (IsCounted(mesh, slot))
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

double WantedLength(const MeshView& mesh, std::size_t edge, const EdgeEnds& ends)
{
  return mesh.MiddleSpacing ? (*mesh.MiddleSpacing)[edge]
                            : 0.5 * (mesh.Spacing[ends.Start] + mesh.Spacing[ends.End]);
}

// 0 where it has no length.
double SlopeOf(const MeshView& mesh, const EdgeEnds& ends, double length)
{
  const double rise = std::abs(mesh.Spacing[ends.Start] - mesh.Spacing[ends.End]);
  return length > 0.0 ? rise / length : 0.0;
}

bool IsInBand(double relativeLength)
{
  const double square = relativeLength * relativeLength;
  return square >= 0.5 && square <= 2.0;
}

void AddEdge(
  const MeshView& mesh, const EdgeEnds& ends, double length, double wanted, QualitySums& sum)
{
  const double relativeLength = length / wanted;
  sum.RelativeLengths.Add(relativeLength);
  sum.Edges += 1;
  sum.EdgesInBand += IsInBand(relativeLength) ? 1 : 0;
  sum.LargestSlope = std::max(sum.LargestSlope, SlopeOf(mesh, ends, length));
}

// The spacing at the middles is in the order of the edges, which only counting tells.
QualitySums SumNumberedEdges(const MeshView& mesh, Pulse& pulse)
{
  QualitySums sum;
  ForEachEdge(mesh, pulse,
    [&mesh, &sum](std::size_t edge, const EdgeEnds& ends)
    { AddEdge(mesh, ends, LengthOf(mesh, ends), WantedLength(mesh, edge, ends), sum); });
  return sum;
}

// The edges that are counted at a triangle.
void AddEdges(const MeshView& mesh, std::size_t triangle, const std::array<double, 3>& squares,
  QualitySums& sum)
{
  for (std::size_t k = 0; k < 3; ++k)
  {
    const std::size_t slot = 3 * triangle + k;
    if (IsCounted(mesh, slot))
    {
      const EdgeEnds ends = EndsOf(mesh, slot);
      AddEdge(mesh, ends, std::sqrt(squares[k]), WantedLength(mesh, 0, ends), sum);
    }
  }
}

// Tells the squared length of each side to its ends.
QualitySums SumTriangles(
  const MeshView& mesh, MeshQuality& quality, LeastValues& shortest, Pulse& pulse)
{
  return SumAtOnce(pulse, mesh.Corners.size() / 3, QualitySums(),
    [&mesh, &quality, &shortest](QualitySums& sum, std::size_t t)
    {
      const auto place = [&mesh, t](std::size_t corner) -> const Point2&
      { return mesh.Points[mesh.Corners[3 * t + corner]]; };
      const std::array<double, 3> squares = SquaredSides(place(0), place(1), place(2));
      const Shape shape = ShapeOf(squares, Cross(place(1) - place(0), place(2) - place(0)));
      for (std::size_t k = 0; k < 3; ++k)
      {
        shortest.Lower(
          mesh.Corners[3 * t + k], std::min(squares[(k + 1) % 3], squares[(k + 2) % 3]));
      }
      quality.MinimumAngle[t] = MinimumAngle(shape);
      quality.RadiusEdgeRatio[t] = RadiusEdgeRatio(shape);
      quality.AspectRatio[t] = AspectRatio(shape);
      if (!mesh.CountsTriangle(t))
      {
        return;
      }
      sum.Triangles += 1;
      sum.SmallestAngle = std::min(sum.SmallestAngle, quality.MinimumAngle[t]);
      sum.LargestRadiusEdgeRatio = std::max(sum.LargestRadiusEdgeRatio, quality.RadiusEdgeRatio[t]);
      if (!mesh.MiddleSpacing)
      {
        AddEdges(mesh, t, squares, sum);
      }
    });
}

// With all edges, as their ends are at hand.
void MeasureTriangles(
  const MeshView& mesh, MeshQuality& quality, LeastValues& shortest, Pulse& pulse)
{
  const PulsePart part(pulse, 0.0, TrianglesEnd);
  if (pulse.HasStopped() || mesh.Corners.empty())
  {
    return;
  }
  quality.Sums.Join(SumTriangles(mesh, quality, shortest, pulse));
  if (mesh.MiddleSpacing)
  {
    quality.Sums.Join(SumNumberedEdges(mesh, pulse));
  }
}

void MeasureConformity(
  const MeshView& mesh, MeshQuality& quality, const LeastValues& shortest, Pulse& pulse)
{
  const PulsePart part(pulse, TrianglesEnd, 1.0);
  const std::size_t count = mesh.Points.size();
  if (count == 0 || pulse.HasStopped())
  {
    return;
  }
  quality.Sums.Join(SumAtOnce(pulse, count, QualitySums(),
    [&mesh, &quality, &shortest](QualitySums& sum, std::size_t i)
    {
      const double distance = std::sqrt(shortest[i]);
      quality.NearestNeighborDistance[i] = distance;
      const double spacing = mesh.Spacing[i];
      quality.Conformity[i] = std::min(distance, spacing) / std::max(distance, spacing);
      if (mesh.CountsVertex(i))
      {
        sum.Vertices += 1;
        sum.SmallestConformity = std::min(sum.SmallestConformity, quality.Conformity[i]);
        sum.Conformities.Add(quality.Conformity[i]);
      }
    }));
}

// Of the slopes along edges.
struct Steepest
{
  double Slope = 0.0;

  void Join(const Steepest& other) { this->Slope = std::max(this->Slope, other.Slope); }
};

} // namespace

void MeshQuality::Conclude(const QualitySums& sums)
{
  const auto share = [](double sum, std::int64_t count)
  { return count > 0 ? sum / static_cast<double>(count) : 0.0; };
  this->Sums = sums;
  this->NumberOfVertices = sums.Vertices;
  this->NumberOfTriangles = sums.Triangles;
  this->SmallestAngle = sums.Triangles > 0 ? sums.SmallestAngle : 0.0;
  this->LargestRadiusEdgeRatio = sums.LargestRadiusEdgeRatio;
  this->SmallestConformity = sums.Vertices > 0 ? sums.SmallestConformity : 0.0;
  this->MeanConformity = share(sums.Conformities.Value(), sums.Vertices);
  this->MeanRelativeLength = share(sums.RelativeLengths.Value(), sums.Edges);
  this->LargestSlope = sums.LargestSlope;
  this->ShareOfEdgesInBand = share(static_cast<double>(sums.EdgesInBand), sums.Edges);
}

MeshQuality MeasureQuality(const MeshView& mesh, Monitor& monitor)
{
  Pulse pulse(monitor);
  MeshQuality quality;
  quality.NumberOfVertices = static_cast<std::int64_t>(mesh.Points.size());
  quality.NumberOfTriangles = static_cast<std::int64_t>(mesh.Corners.size() / 3);
  MakeRoom(quality);
  LeastValues shortest(mesh.Points.size(), pulse);
  MeasureTriangles(mesh, quality, shortest, pulse);
  MeasureConformity(mesh, quality, shortest, pulse);
  quality.Conclude(quality.Sums);
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
    { lengths.push_back(LengthOf(mesh, ends) / WantedLength(mesh, edge, ends)); });
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
      const Point2& apex = mesh.Points[mesh.Corners[slot]];
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
  const auto largest = SumAtOnce(pulse, mesh.Corners.size(), Steepest(),
    [&mesh](Steepest& sum, std::size_t slot)
    {
      if (IsCounted(mesh, slot))
      {
        const EdgeEnds ends = EndsOf(mesh, slot);
        sum.Slope = std::max(sum.Slope, SlopeOf(mesh, ends, LengthOf(mesh, ends)));
      }
    });
  return largest.Slope;
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
