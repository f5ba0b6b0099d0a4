// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "JumpsOutside.h"

#include "../Base/Tasks.h"

#include <array> // for samples
#include <cmath> // for abs

namespace biting
{
namespace
{

/// The size of squares that are not cut, as a share of the least value in them: f is off by what it
/// grows on a quarter of that.
constexpr double LastSize = 0.7;

/// By less, as a share of the least value, values are linear.
constexpr double Slight = 0.02;

/// Squares along each side of the bounds before any is cut; each is a task.
constexpr std::size_t TasksAlong = 8;

constexpr int DeepestCut = 20;

/// Of each task: then squares are not cut any more.
constexpr std::size_t MostPoints = 1 << 18;

/// Looks at a square, and those it is cut into.
class JumpSearch
{
public:
  struct Sample
  {
    Point2 At;
    double Value = 0.0;
    bool IsInside = true;
  };

  JumpSearch(
    const TriangleInterpolator& source, const SteepRule& rule, SegmentSource& points, Pulse& pulse)
    : Source(source)
    , Rule(rule)
    , Points(points)
    , Beats(pulse)
  {
  }

  void LookAt(const Box2& square)
  {
    const auto sample = [this, &square](double x, double y) {
      return this->Take(square.Low + Point2{ x * square.Width(), y * square.Height() });
    };
    this->LookAt({ sample(0.0, 0.0), sample(1.0, 0.0), sample(0.0, 1.0), sample(1.0, 1.0) }, 0);
  }

private:
  using Corners = std::array<Sample, 4>; // lower left, lower right, upper left, upper right
  using Samples = std::array<Sample, 9>; // row by row

  void LookAt(const Corners& corners, int depth)
  {
    const Samples samples = this->SamplesOf(corners);
    const Box2 box{ corners[0].At, corners[3].At };
    const double size = std::max(box.Width(), box.Height());
    double least = Infinity;
    bool isInside = true;
    for (const Sample& sample : samples)
    {
      least = std::min(least, sample.Value);
      isInside = isInside && sample.IsInside;
    }
    const bool isAtBorder = this->IsAtBorder(box);
    if ((isInside && !isAtBorder) || !this->Beats.Beat(256))
    {
      return;
    }
    const double last = DistanceOfPoints(LastSize, this->Rule.Slope) * least;
    const bool isCoarse = isAtBorder && size > 2.0 * last;
    if (size > last && (isCoarse || IsBent(samples, Slight * least)) && depth < DeepestCut &&
      this->Points.Points.size() < MostPoints)
    {
      for (const std::size_t first : { 0u, 1u, 3u, 4u })
      {
        this->LookAt({ samples[first], samples[first + 1], samples[first + 3], samples[first + 4] },
          depth + 1);
      }
      return;
    }
    this->AddLow(samples);
  }

  Sample Take(const Point2& place) const
  {
    const std::optional<double> inside = this->Source.ValueInside(place);
    return { place, this->Rule.Range(inside ? *inside : this->Source.ValueOutside(place)),
      inside.has_value() };
  }

  Samples SamplesOf(const Corners& corners) const
  {
    const auto between = [this, &corners](std::size_t a, std::size_t b)
    { return this->Take(Midpoint(corners[a].At, corners[b].At)); };
    return { corners[0], between(0, 1), corners[1], between(0, 2), between(0, 3), between(1, 3),
      corners[2], between(2, 3), corners[3] };
  }

  /// Within half of its size.
  bool IsAtBorder(Box2 box) const
  {
    box.Grow(0.5 * std::max(box.Width(), box.Height()));
    return !this->Source.BorderEdges().AllOf(box, [](const BorderEdge&) { return false; });
  }

  /// Whether a sample is not the mean of two opposite ones.
  static bool IsBent(const Samples& samples, double tolerance)
  {
    constexpr std::size_t Lines[8][3] = { { 0, 1, 2 }, { 3, 4, 5 }, { 6, 7, 8 }, { 0, 3, 6 },
      { 1, 4, 7 }, { 2, 5, 8 }, { 0, 4, 8 }, { 2, 4, 6 } };
    for (const auto& line : Lines)
    {
      const double mean = 0.5 * (samples[line[0]].Value + samples[line[2]].Value);
      if (std::abs(mean - samples[line[1]].Value) > tolerance)
      {
        return true;
      }
    }
    return false;
  }

  /// Samples that are lower than another one by more than the slope, and no other one than them.
  void AddLow(const Samples& samples)
  {
    for (const Sample& own : samples)
    {
      bool isLow = false;
      bool isHigh = false;
      for (const Sample& other : samples)
      {
        const double most = this->Rule.Slope * Distance(own.At, other.At);
        isLow = isLow || other.Value > own.Value + most;
        isHigh = isHigh || own.Value > other.Value + most;
      }
      if (isLow && !isHigh)
      {
        this->Points.Add(own.At, own.At, own.Value, own.Value);
      }
    }
  }

  const TriangleInterpolator& Source;
  const SteepRule& Rule;
  SegmentSource& Points;
  Pulse& Beats;
};

/// From a border point that is lower than its neighbors a valley of low values extends outward, as
/// thin as its edges are short: along the normals of its edges, and halfway between these. Points
/// along it are listed as long as they are below what the border point allows there.
class BorderRays
{
public:
  BorderRays(const TriangleInterpolator& source, const SteepRule& rule, SegmentSource& points)
    : Source(source)
    , Rule(rule)
    , Points(points)
  {
  }

  void List(Pulse& pulse)
  {
    const std::vector<BorderEdge>& edges = this->Source.BorderEdges().Items();
    std::vector<Point2> normals;
    normals.reserve(edges.size());
    for (const BorderEdge& edge : edges)
    {
      pulse.Beat(16);
      normals.push_back(this->OutwardOf(edge));
      this->Note(edge, edge.StartId, edge.StartValue - edge.EndValue, normals.back());
      this->Note(edge, edge.EndId, edge.EndValue - edge.StartValue, normals.back());
    }
    for (std::size_t k = 0; k < edges.size() && pulse.Beat(64); ++k)
    {
      this->ListFrom(edges[k].Start, edges[k].StartId, edges[k].StartValue, normals[k]);
      this->ListFrom(edges[k].End, edges[k].EndId, edges[k].EndValue, normals[k]);
    }
  }

private:
  struct Vertex
  {
    Point2 Outward; ///< the sum of its edges' normals
    bool IsLow = false;
    bool IsHigh = false;
  };

  Point2 OutwardOf(const BorderEdge& edge) const
  {
    constexpr double Slightly = 1e-3;
    const Point2 along = edge.End - edge.Start;
    const Point2 normal = (1.0 / Length(along)) * Perpendicular(along);
    const Point2 beside = Midpoint(edge.Start, edge.End) + Slightly * Perpendicular(along);
    return this->Source.ValueInside(beside) ? -1.0 * normal : normal;
  }

  void Note(const BorderEdge& edge, Id id, double rise, const Point2& normal)
  {
    const auto vertex = static_cast<std::size_t>(id);
    this->Vertices.resize(std::max(this->Vertices.size(), vertex + 1));
    const double most = this->Rule.Slope * Distance(edge.Start, edge.End);
    const double scaled = this->Rule.Range.Scale * rise;
    this->Vertices[vertex].Outward = this->Vertices[vertex].Outward + normal;
    this->Vertices[vertex].IsLow |= scaled < -most;
    this->Vertices[vertex].IsHigh |= scaled > most;
  }

  void ListFrom(const Point2& place, Id id, double value, const Point2& normal)
  {
    Vertex& vertex = this->Vertices[static_cast<std::size_t>(id)];
    if (vertex.IsLow && !vertex.IsHigh)
    {
      this->ListAlong(place, this->Rule.Range(value), normal);
      const double length = Length(vertex.Outward);
      if (length > 0.0)
      {
        this->ListAlong(place, this->Rule.Range(value), (1.0 / length) * vertex.Outward);
      }
      vertex.Outward = {}; // once
    }
  }

  void ListAlong(const Point2& from, double least, const Point2& direction)
  {
    double value = least;
    double way = 0.0;
    while (value < least + this->Rule.Slope * way || way == 0.0)
    {
      way += DistanceOfPoints(0.5 * LastSize, this->Rule.Slope) * value;
      const Point2 place = from + way * direction;
      if (!this->Rule.Bounds.Contains(place) || this->Source.ValueInside(place))
      {
        return;
      }
      value = this->Rule.Range(this->Source.ValueOutside(place));
      if (value < least + this->Rule.Slope * way)
      {
        this->Points.Add(place, place, value, value);
      }
    }
  }

  const TriangleInterpolator& Source;
  const SteepRule& Rule;
  SegmentSource& Points;
  std::vector<Vertex> Vertices; ///< of the source's points
};

} // namespace

void AddJumpsOutside(
  const TriangleInterpolator& source, const SteepRule& rule, SegmentSource& edges, Pulse& pulse)
{
  const Point2 size = (1.0 / TasksAlong) * (rule.Bounds.High - rule.Bounds.Low);
  std::array<SegmentSource, TasksAlong * TasksAlong> parts;
  DoTasks(pulse, parts.size(),
    [&source, &rule, &parts, &size](std::size_t k, Monitor& monitor)
    {
      Pulse own(monitor);
      const Point2 low = rule.Bounds.Low +
        Point2{ static_cast<double>(k % TasksAlong) * size.X,
          static_cast<double>(k / TasksAlong) * size.Y };
      JumpSearch(source, rule, parts[k], own).LookAt({ low, low + size });
    });
  BorderRays(source, rule, edges).List(pulse);
  for (const SegmentSource& part : parts)
  {
    edges.Add(part);
  }
}

} // namespace biting
