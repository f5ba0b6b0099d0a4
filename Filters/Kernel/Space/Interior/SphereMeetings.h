// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSphereMeetings_h
#define BitingSphereMeetings_h

#include "BallTree.h"
#include "InteriorBites.h"

#include <algorithm> // for find_if, max, sort
#include <cmath>     // for sqrt
#include <cstddef>   // for indices
#include <vector>    // for the arrays

namespace biting
{

/// The places on one sphere where two others meet it, outside of all guards.
///
/// In units of its radius, about its center: another ball meets it in a circle, in the plane
/// u . x = h, and x is within its guard where u . x > g. Two circles meet at
/// x = a u + b v +- c u x v where a + b u.v = h, b + a u.v = k, |x| = 1.
class SphereMeetings
{
public:
  /// Radius in f, for a mean edge length f; and the number of spheres of radius 1 per unit of a
  /// large volume. Both measured.
  static constexpr double BitingConstant = 0.885;
  static constexpr double BitesPerVolume = 1.3;

  explicit SphereMeetings(const std::vector<CubeAxes>& /*axes*/) {}

  /// Whether the place lies in the guard of the ball.
  bool IsGuarded(const GuardedBall& ball, const Point3& place) const
  {
    const Point3 apart = place - ball.Center;
    return Dot(apart, apart) < ball.Guard * ball.Guard;
  }

  void Start(const GuardedBall& ball)
  {
    this->Own = ball;
    this->Circles.clear();
    this->IsHidden = false;
  }

  /// Adds the circle in which another ball, which meets this one, meets the sphere.
  void Add(Id id, const GuardedBall& other)
  {
    const Point3 way = other.Center - this->Own.Center;
    const double way2 = Dot(way, way);
    if (!(way2 > 0.0))
    {
      return;
    }
    const double distance = std::sqrt(way2);
    const double both = way2 + this->Own.Radius * this->Own.Radius;
    const double scale = 0.5 / (distance * this->Own.Radius);
    const double height = scale * (both - other.Radius * other.Radius);
    this->IsHidden = this->IsHidden || height <= -1.0;
    if (height < 1.0)
    {
      const double guard = scale * (both - other.Guard * other.Guard);
      this->Circles.push_back(
        { (1.0 / distance) * way, height, guard, SineOf(height), SineOf(guard), id });
    }
  }

  /// Calls visit(place, a, b) for the meetings of circles of balls a and b for which isParent.
  template <typename IsParent, typename Visit>
  void Find(const IsParent& isParent, const Visit& visit)
  {
    // Large guards first: they hide most places.
    std::sort(this->Circles.begin(), this->Circles.end(),
      [](const Circle& a, const Circle& b)
      { return a.Guard < b.Guard || (a.Guard == b.Guard && a.Ball < b.Ball); });
    this->Hider = 0;
    this->Parents.clear();
    for (const Circle& circle : this->Circles)
    {
      if (!this->IsHidden && isParent(circle.Ball) && !this->IsGuarded(circle))
      {
        this->MeetParents(circle, visit);
        this->Parents.push_back(circle);
      }
    }
  }

private:
  struct Circle
  {
    Point3 Way;
    double Height;
    double Guard;
    double HeightSine; ///< sqrt(1 - Height^2)
    double GuardSine;
    Id Ball;
  };

  static double SineOf(double cosine) { return std::sqrt(std::max(0.0, 1.0 - cosine * cosine)); }

  /// The meetings of a circle with the parents.
  template <typename Visit>
  void MeetParents(const Circle& a, const Visit& visit)
  {
    constexpr double LeastRest = 1e-12; // of parallel planes
    for (const Circle& b : this->Parents)
    {
      const double cosine = Dot(a.Way, b.Way);
      const double rest = 1.0 - cosine * cosine;
      const double rise2 =
        rest - a.Height * a.Height - b.Height * b.Height + 2.0 * cosine * a.Height * b.Height;
      if (!(rise2 >= 0.0 && rest >= LeastRest))
      {
        continue;
      }
      const double scale = 1.0 / rest;
      const Point3 foot = scale * (a.Height - cosine * b.Height) * a.Way +
        scale * (b.Height - cosine * a.Height) * b.Way;
      const Point3 rise = scale * std::sqrt(rise2) * Cross(a.Way, b.Way);
      for (const Point3& place : { foot + rise, foot - rise })
      {
        if (!this->IsGuarded(place))
        {
          visit(this->Own.Center + this->Own.Radius * place, a.Ball, b.Ball);
        }
      }
    }
  }

  /// Whether the circle lies in one guard: the angle between the ways plus the angle of the circle
  /// is less than the angle of the guard.
  bool IsGuarded(const Circle& circle) const
  {
    for (const Circle& other : this->Circles)
    {
      if (other.Guard >= circle.Height)
      {
        return false; // the guards that follow are smaller
      }
      if (Dot(circle.Way, other.Way) >
        other.Guard * circle.Height + other.GuardSine * circle.HeightSine)
      {
        return true;
      }
    }
    return false;
  }

  /// What hid the last place often hides the next.
  bool IsGuarded(const Point3& place)
  {
    const auto isIn = [&place](const Circle& other) { return Dot(place, other.Way) > other.Guard; };
    if (isIn(this->Circles[this->Hider]))
    {
      return true;
    }
    const auto hider = std::find_if(this->Circles.begin(), this->Circles.end(), isIn);
    const bool isFound = hider != this->Circles.end();
    this->Hider = isFound ? static_cast<std::size_t>(hider - this->Circles.begin()) : this->Hider;
    return isFound;
  }

  GuardedBall Own;
  std::vector<Circle> Circles;
  std::vector<Circle> Parents; ///< the circles that lie in no guard
  std::size_t Hider = 0;       ///< the circle whose guard hid the last place
  bool IsHidden = false;       ///< another ball contains the sphere
};

} // namespace biting

#endif
