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

/// The size of squares that are not cut, as a share of the least value in them. Samples are half of
/// that apart, and f off by what it grows on half of this: about 5 % for a slope of .3.
constexpr double LastSize = 0.7;

/// Beside a border squares are cut down to this, where their samples show nothing.
constexpr double SizeAtBorder = 1.4;

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
    const bool isCoarse = isAtBorder && size > SizeAtBorder * least;
    if (size > LastSize * least && (isCoarse || IsBent(samples, Slight * least)) &&
      depth < DeepestCut && this->Points.Points.size() < MostPoints)
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

/// From the lower end of a steep border edge its value extends along the edge's normal, on a strip
/// that may be as thin as the edge is short. That is a segment of one value: it ends where another
/// border is nearer.
class BorderRays
{
public:
  BorderRays(const TriangleInterpolator& source, const SteepRule& rule, SegmentSource& rays)
    : Source(source)
    , Rule(rule)
    , Rays(rays)
  {
  }

  void AddOf(const BorderEdge& edge)
  {
    const double length = Distance(edge.Start, edge.End);
    const double start = this->Rule.Range(edge.StartValue);
    const double end = this->Rule.Range(edge.EndValue);
    if (std::abs(end - start) > this->Rule.Slope * length && length > 0.0)
    {
      const Point2& low = start < end ? edge.Start : edge.End;
      const double value = std::min(start, end);
      const Point2 normal = (1.0 / length) * Perpendicular(edge.End - edge.Start);
      for (const Point2& direction : { normal, -1.0 * normal })
      {
        const double reach = this->ReachOf(low, direction, FirstStep * std::min(length, value));
        if (this->Rule.Slope * reach > Slight * value)
        {
          this->Rays.Add(low, low + reach * direction, value, value);
        }
      }
    }
  }

private:
  static constexpr double FirstStep = 0.1;

  /// 0 where the triangle lies on that side. By doubling, then by halving.
  double ReachOf(const Point2& low, const Point2& direction, double step) const
  {
    if (this->Source.ValueInside(low + step * direction))
    {
      return 0.0;
    }
    double reach = 0.0;
    while (
      this->IsNearest(low, direction, step) && this->Rule.Bounds.Contains(low + reach * direction))
    {
      reach = step;
      step *= 2.0;
    }
    for (int halving = 0; halving < 3; ++halving)
    {
      const double middle = 0.5 * (reach + step);
      (this->IsNearest(low, direction, middle) ? reach : step) = middle;
    }
    return reach;
  }

  bool IsNearest(const Point2& low, const Point2& direction, double step) const
  {
    constexpr double NearerThanRounding = 1.0 - 1e-6;
    const double known = NearerThanRounding * step;
    return !(
      Nearest(this->Source.BorderEdges(), low + step * direction, { known, 0.0 }).Distance < known);
  }

  const TriangleInterpolator& Source;
  const SteepRule& Rule;
  SegmentSource& Rays;
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
  BorderRays rays(source, rule, edges);
  for (const BorderEdge& edge : source.BorderEdges().Items())
  {
    pulse.Beat(64);
    rays.AddOf(edge);
  }
  for (const SegmentSource& part : parts)
  {
    edges.Add(part);
  }
}

} // namespace biting
