// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "BorderRays.h"

#include <algorithm> // for min, max
#include <cmath>     // for abs, isfinite

namespace biting
{
namespace
{

/// A gradation above this one counts as this one, as nobody sees such slopes on a part of f.
constexpr double LargestSeenGradation = 1.0;

/// How exact lengths are: shares of f / g, and of themselves.
constexpr double EndPrecision = 0.003;
constexpr double EndShare = 0.01;

/// Steps to the length of a ray, and to one between two edges.
constexpr int LengthSteps = 32;
constexpr int CrossingSteps = 40;
constexpr double GrowthOfBall = 8.0;

/// How far an empty ball may reach over the border: shares of its radius and of coordinates.
constexpr double EmptyBall = 1e-10;
constexpr double RoundingOfPlaces = 1e-14;

} // namespace

BorderRays::BorderRays(const TriangleInterpolator& field, const Box2& bounds, double gradation,
  const ValueRange& range, Pulse& pulse)
  : Field(field)
  , Traced(bounds)
  , SeenGradation(std::min(gradation, LargestSeenGradation))
  , Range(range)
  , Beats(pulse)
{
  this->Traced.Grow(bounds.Diagonal());
}

/// How far it is along a unit vector to the end of the traced box; 0 where that is behind.
double BorderRays::Reach(const Point2& start, const Point2& direction) const
{
  const auto along = [](double from, double slope, double low, double high)
  {
    const double end = slope > 0.0 ? high : low;
    return slope == 0.0 ? Infinity : (end - from) / slope;
  };
  const double reach =
    std::min(along(start.X, direction.X, this->Traced.Low.X, this->Traced.High.X),
      along(start.Y, direction.Y, this->Traced.Low.Y, this->Traced.High.Y));
  return std::isfinite(reach) ? std::max(reach, 0.0) : 0.0;
}

/// By which lengths of a ray may differ.
double BorderRays::RoomOf(const BorderRay& ray, double length) const
{
  return std::max(
    std::min(EndPrecision * this->UnitOf(ray.Spacing), EndShare * length), SameLength * length);
}

void BorderRays::LookBeyond(BorderRay& ray, const BorderEdge* far) const
{
  this->Compare(ray, this->EndAt(ray, far).Value);
}

void BorderRays::Compare(BorderRay& ray, double value) const
{
  const double own = this->Range(ray.Value);
  const double beyond = this->Range(value);
  ray.Spacing = std::min(own, beyond);
  ray.IsJump = std::max(own, beyond) > (1.0 + LeastJump) * ray.Spacing;
}

NearestValue BorderRays::EndAt(const BorderRay& ray, const BorderEdge* far) const
{
  return far ? TouchOf(ray.Foot, ray.Direction, *far)
             : NearestValue{ this->Reach(ray.Foot, ray.Direction), ray.Value, ray.Foot };
}

bool BorderRays::IsBeyond(const BorderEdge* far, const BorderRay& ray) const
{
  return this->EndAt(ray, far).Distance <= ray.Length + 2.0 * this->RoomOf(ray, ray.Length);
}

void BorderRays::Extend(BorderRay& ray, double likely, const BorderEdge* far) const
{
  const Point2& foot = ray.Foot;
  const double reach = this->Reach(foot, ray.Direction);
  ray.Length = std::min(likely, reach);
  ray.Far = likely < reach ? far : nullptr;
  for (int step = 0; ray.Length > 0.0 && step < LengthSteps && this->Beats.Beat(64); ++step)
  {
    const NearestValue nearest = this->Field.NearestOfBorder(ray.End(), { ray.Length, 0.0, foot });
    const double room =
      EmptyBall * ray.Length + RoundingOfPlaces * (std::abs(foot.X) + std::abs(foot.Y));
    if (nearest.Distance >= ray.Length - room)
    {
      if (ray.Far || ray.Length == reach)
      {
        return;
      }
      ray.Length = std::min(GrowthOfBall * ray.Length, reach);
      continue;
    }
    const double before = ray.Length;
    const NearestValue touch = TouchOf(foot, ray.Direction, *nearest.Edge);
    ray.Length = std::min(touch.Distance, before);
    ray.Far = nearest.Edge;
    this->Compare(ray, touch.Value);
    if (before - ray.Length <= this->RoomOf(ray, before))
    {
      return;
    }
  }
}

BorderRay BorderRays::FindEnd(BorderRay ray, double likely, const BorderEdge* far) const
{
  const double reach = this->Reach(ray.Foot, ray.Direction);
  ray.Spacing = this->Range(ray.Value);
  const Point2 aside = ray.Foot + SameLength * std::min(likely, reach) * ray.Direction;
  ray.IsCovered = this->Field.HasOverlaps() && this->Field.Covers(aside);
  if (ray.IsCovered)
  {
    return ray;
  }
  this->Extend(ray, likely, far);
  this->LookBeyond(ray, ray.Far);
  if (ray.Length < reach && !ray.IsJump)
  {
    const double margin =
      std::max(1000.0 * SameLength * ray.Length, 2.0 * EndPrecision * this->UnitOf(ray.Spacing));
    const double beyond = std::min(ray.Length + margin, reach);
    const NearestValue nearest = this->Field.NearestOfBorder(
      ray.Foot + beyond * ray.Direction, { beyond, ray.Value, ray.Foot });
    this->Compare(ray, nearest.Value);
  }
  return ray;
}

BorderRay BorderRays::FindCrossing(
  const BorderFront& front, const BorderRay& a, const BorderRay& b) const
{
  double low = a.Share;
  double high = b.Share;
  for (int step = 0;; ++step)
  {
    BorderRay middle = front.At(0.5 * (low + high));
    middle.Spacing = std::min(a.Spacing, b.Spacing);
    const double first = this->EndAt(middle, a.Far).Distance;
    const double second = this->EndAt(middle, b.Far).Distance;
    const double least = std::min(first, second);
    if (step == CrossingSteps || std::abs(first - second) <= 0.5 * this->RoomOf(middle, least))
    {
      return this->FindEnd(middle, least, first <= second ? a.Far : b.Far);
    }
    (first <= second ? low : high) = middle.Share;
  }
}

void BorderRays::EndAtOnce(BorderRay& ray, const BorderEdge* far) const
{
  const NearestValue end = this->EndAt(ray, far);
  ray.Length = std::min(end.Distance, this->Reach(ray.Foot, ray.Direction));
  ray.Far = far;
  this->Compare(ray, end.Value);
}

} // namespace biting
