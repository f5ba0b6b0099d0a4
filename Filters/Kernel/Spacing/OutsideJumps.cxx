// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "OutsideJumps.h"

#include "../Base/Pulse.h"
#include "JumpSquares.h"

#include <algorithm> // for min, max
#include <cmath>     // for ceil

namespace biting
{
namespace
{

/// Perpendiculars along an edge: so many f / g apart, but no more than so many.
constexpr double FootDistance = 0.1;
constexpr double MostFeet = 16.0;

/// Ends of neighboring perpendiculars that are farther apart than so many times their feet or their
/// lengths may have anything between them.
constexpr double LargestStep = 4.0;

/// Steps to the length of a perpendicular, and the room for rounding in comparing lengths.
constexpr int LengthSteps = 16;
constexpr double SameLength = 1e-6;

/// Where a perpendicular ends, and the value along it.
struct RayEnd
{
  Point2 Foot;
  Point2 Place;
  double Spacing = 0.0;
  bool IsLow = false; ///< f is larger beyond
};

class PerpendicularFinder
{
public:
  PerpendicularFinder(const TriangleInterpolator& field, const Box2& bounds, double gradation,
    ConeCollector& cones, Monitor& monitor)
    : Field(field)
    , Bounds(bounds)
    , Gradation(gradation)
    , SeenGradation(std::min(gradation, LargestSeenGradation))
    , Cones(cones)
    , Beats(monitor)
  {
  }

  bool Run()
  {
    for (const BorderEdge& edge : this->Field.BorderEdges())
    {
      const double length = Distance(edge.Start, edge.End);
      if (!this->Beats.Beat() || !(length > 0.0))
      {
        continue;
      }
      const Point2 normal = (1.0 / length) * Perpendicular(edge.End - edge.Start);
      for (double side : { -1.0, 1.0 })
      {
        if (this->LeavesTriangles(Midpoint(edge.Start, edge.End), side * normal, length))
        {
          this->AddPerpendicular(edge, side * normal);
          this->AddEnds(edge, side * normal);
        }
      }
    }
    AddJumpSquares(this->Field, this->Bounds, this->Gradation, this->Cones, this->Beats);
    return !this->Beats.HasStopped();
  }

private:
  /// Whether a direction leads from the border to the outside, within the bounds.
  bool LeavesTriangles(const Point2& start, const Point2& direction, double length) const
  {
    const double step = std::min(SameLength * length, 0.5 * this->Reach(start, direction));
    return step > 0.0 && this->Field.Nearest(start + step * direction).Distance > 0.0;
  }

  /// How far it is along a unit vector to the end of the bounds; 0 where that is behind.
  double Reach(const Point2& start, const Point2& direction) const
  {
    const auto along = [](double from, double slope, double low, double high)
    {
      const double end = slope > 0.0 ? high : low;
      return slope == 0.0 ? std::numeric_limits<double>::infinity() : (end - from) / slope;
    };
    const double reach =
      std::min(along(start.X, direction.X, this->Bounds.Low.X, this->Bounds.High.X),
        along(start.Y, direction.Y, this->Bounds.Low.Y, this->Bounds.High.Y));
    return std::isfinite(reach) ? std::max(reach, 0.0) : 0.0;
  }

  /// How far along a unit vector a point of the border stays the nearest one: a ball that touches
  /// it there shrinks until no other point is within (after Ma, Bae and Choi 2012). It begins with
  /// a `likely` length, and as large as the bounds where that is too short.
  double LengthAlong(const Point2& start, const Point2& direction, double likely = 0.0)
  {
    const double reach = this->Reach(start, direction);
    bool isWhole = !(likely > 0.0 && likely < reach);
    double length = isWhole ? reach : likely;
    for (int step = 0; step < LengthSteps && this->Beats.Beat(64); ++step)
    {
      const NearestValue nearest =
        this->Field.Nearest(start + length * direction, { length, 0.0, start });
      const Point2 within = nearest.Foot - start;
      const bool isEmpty = nearest.Distance >= (1.0 - SameLength) * length;
      if (isEmpty && isWhole)
      {
        return length;
      }
      length = isEmpty ? reach : 0.5 * Dot(within, within) / Dot(within, direction);
      isWhole = true;
    }
    return length;
  }

  /// From the lower end of a steep edge.
  void AddPerpendicular(const BorderEdge& edge, const Point2& normal)
  {
    const ValueRange& range = this->Cones.Values();
    const bool isRising = edge.StartValue < edge.EndValue;
    const Point2& lowEnd = isRising ? edge.Start : edge.End;
    const Point2& highEnd = isRising ? edge.End : edge.Start;
    const double low = range.Scale * std::min(edge.StartValue, edge.EndValue);
    const double high = range.Scale * std::max(edge.StartValue, edge.EndValue);
    const bool isSteep = high - low > this->Gradation * Distance(lowEnd, highEnd);
    if (isSteep && low < range.Most && high > range.Least)
    {
      const double weight = std::max(0.0, (range.Least - low) / (high - low));
      const Point2 start = lowEnd + weight * (highEnd - lowEnd);
      const Point2 end = start + this->LengthAlong(start, normal) * normal;
      this->Cones.AddSegment(start, end, std::max(low, range.Least), std::max(low, range.Least));
    }
  }

  /// The jumps before an edge.
  void AddEnds(const BorderEdge& edge, const Point2& normal)
  {
    const double least = this->Cones.Values()(std::min(edge.StartValue, edge.EndValue));
    const double length = Distance(edge.Start, edge.End);
    const double feet =
      std::min(std::ceil(length * this->SeenGradation / (FootDistance * least)), MostFeet);
    RayEnd last;
    for (double foot = 0.0; foot <= feet && !this->Beats.HasStopped(); foot += 1.0)
    {
      const double weight = foot / feet;
      const Point2 start = edge.Start + weight * (edge.End - edge.Start);
      const double value = (1.0 - weight) * edge.StartValue + weight * edge.EndValue;
      const RayEnd next = this->FindEnd(start, value, normal, Distance(last.Place, last.Foot));
      this->Connect(last, next, foot > 0.0);
      last = next;
    }
  }

  /// `lastLength` is that of a perpendicular beside it.
  RayEnd FindEnd(const Point2& foot, double value, const Point2& direction, double lastLength)
  {
    const double reach = this->Reach(foot, direction);
    const double length = this->LengthAlong(foot, direction, 2.0 * lastLength);
    RayEnd end;
    end.Foot = foot;
    end.Place = foot + length * direction;
    end.Spacing = this->Cones.Values()(value);
    if (length > 0.0 && length < reach)
    {
      const double beyond = std::min((1.0 + 1000.0 * SameLength) * length, reach);
      const NearestValue nearest =
        this->Field.Nearest(foot + beyond * direction, { beyond, value, foot });
      end.IsLow = this->Cones.Values()(nearest.Value) > (1.0 + LeastJump) * end.Spacing;
    }
    return end;
  }

  void Connect(const RayEnd& last, const RayEnd& next, bool hasLast)
  {
    const double step = Distance(last.Place, next.Place);
    const double usual = std::max(Distance(last.Foot, next.Foot),
      0.25 * std::min(Distance(last.Place, last.Foot), Distance(next.Place, next.Foot)));
    if (hasLast && last.IsLow && next.IsLow && step <= LargestStep * usual)
    {
      this->Cones.AddSegment(last.Place, next.Place, last.Spacing, next.Spacing);
    }
    else if (next.IsLow)
    {
      this->Cones.AddPoint(next.Place, next.Spacing);
    }
  }

  const TriangleInterpolator& Field;
  const Box2& Bounds;
  const double Gradation;
  const double SeenGradation;
  ConeCollector& Cones;
  Pulse Beats;
};

} // namespace

bool AddOutsideJumps(const TriangleInterpolator& field, const Box2& bounds, double gradation,
  ConeCollector& cones, Monitor& monitor)
{
  return !(bounds.Diagonal() > 0.0) ||
    PerpendicularFinder(field, bounds, gradation, cones, monitor).Run();
}

} // namespace biting
