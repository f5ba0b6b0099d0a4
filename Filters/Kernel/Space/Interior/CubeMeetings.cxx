// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "CubeMeetings.h"

#include <algorithm> // for any_of, max, min, min_element, stable_sort
#include <cmath>     // for abs, sqrt

namespace biting
{

namespace
{

/// Places that near are one, in half sides; and so far beyond sides there are meetings, too.
constexpr double Rounding = 1e-6;

const CubeAxes WorldAxes{ { { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, { 0.0, 0.0, 1.0 } } };

/// Axes at a vertex whose facets have these normals: the first is an axis; that of another plane,
/// or else that of the world which is most at right angles to the first, is nearly one.
CubeAxes AxesOf(const Point3& first, const Point3& second)
{
  constexpr double OtherCosine = 0.77; // of 40 degrees: another plane
  const Point3 across = std::abs(Dot(first, second)) < OtherCosine
    ? second
    : *std::min_element(WorldAxes.begin(), WorldAxes.end(),
        [&first](const Point3& a, const Point3& b)
        { return std::abs(Dot(a, first)) < std::abs(Dot(b, first)); });
  const Point3 third = Cross(first, across);
  const Point3 unit = 1.0 / Length(third) * third;
  return { { first, Cross(unit, first), unit } };
}

/// The part of a line, from Begin to End, in units of its direction.
struct LinePart
{
  double Begin = -Infinity;
  double End = Infinity;

  /// Cuts off where |value + slope t| is more than `most`.
  void Cut(double value, double slope, double most)
  {
    constexpr double Parallel = 1e-12;
    if (std::abs(slope) > Parallel)
    {
      const double a = (-most - value) / slope;
      const double b = (most - value) / slope;
      this->Begin = std::max(this->Begin, std::min(a, b));
      this->End = std::min(this->End, std::max(a, b));
    }
    else if (std::abs(value) > most)
    {
      this->End = -Infinity;
    }
  }
};

} // namespace

std::vector<CubeAxes> AxesOfBoundary(const BodyBoundary& boundary)
{
  // Of each vertex the normal of its first facet, and that of the facet that is turned most to it.
  std::vector<Point3> first(boundary.Centers.size());
  std::vector<Point3> second(boundary.Centers.size());
  for (std::size_t slot = 0; slot < boundary.Facets.size(); ++slot)
  {
    const auto corner = [&boundary, slot](std::size_t k)
    { return static_cast<std::size_t>(boundary.Facets[slot - slot % 3 + k]); };
    const Point3& origin = boundary.Centers[corner(0)];
    const Point3 normal =
      Cross(boundary.Centers[corner(1)] - origin, boundary.Centers[corner(2)] - origin);
    const double length = Length(normal);
    const Point3 unit = length > 0.0 ? 1.0 / length * normal : WorldAxes[2];
    const std::size_t at = corner(slot % 3);
    if (first[at] == Point3())
    {
      first[at] = second[at] = unit;
    }
    else if (std::abs(Dot(unit, first[at])) < std::abs(Dot(second[at], first[at])))
    {
      second[at] = unit;
    }
  }
  std::vector<CubeAxes> axes{ WorldAxes };
  axes.reserve(first.size() + 1);
  for (std::size_t k = 0; k < first.size(); ++k)
  {
    axes.push_back(first[k] == Point3() ? WorldAxes : AxesOf(first[k], second[k]));
  }
  return axes;
}

bool CubeMeetings::IsGuarded(const GuardedBall& ball, const Point3& place) const
{
  const Point3 apart = place - ball.Center;
  if (ball.Frame == NoId)
  {
    return Dot(apart, apart) < ball.Guard * ball.Guard;
  }
  bool isIn = true;
  for (const Point3& axis : this->Axes[static_cast<std::size_t>(ball.Frame)])
  {
    isIn = isIn && std::abs(Dot(apart, axis)) < ball.Guard;
  }
  return isIn;
}

void CubeMeetings::Start(const GuardedBall& cube)
{
  this->Own = cube;
  this->HalfSide = HalfSideShare * cube.Radius;
  this->Others.clear();
}

void CubeMeetings::Add(Id /*id*/, const GuardedBall& other)
{
  const Point3 way = other.Center - this->Own.Center;
  // Of cubes with the same axes half a side, else at most half the diagonal.
  const double reach =
    this->HalfSide + (other.Frame == this->Own.Frame ? HalfSideShare : 1.0) * other.Radius;
  bool mayMeet = true;
  for (const Point3& axis : this->Axes[static_cast<std::size_t>(this->Own.Frame)])
  {
    mayMeet = mayMeet && std::abs(Dot(way, axis)) < reach;
  }
  if (mayMeet)
  {
    this->Others.push_back({ other, Dot(way, way) });
  }
}

void CubeMeetings::FindAll()
{
  // The nearest ones have most of what they have to hide.
  std::stable_sort(this->Others.begin(), this->Others.end(),
    [](const Other& a, const Other& b) { return a.Distance2 < b.Distance2; });
  this->Meetings.clear();
  const CubeAxes& axes = this->Axes[static_cast<std::size_t>(this->Own.Frame)];
  for (std::size_t d = 0; d < 3; ++d)
  {
    for (const double height : { -this->HalfSide, this->HalfSide })
    {
      this->FindOn({ this->Own.Center + height * axes[d], axes[(d + 1) % 3], axes[(d + 2) % 3] });
    }
  }
}

void CubeMeetings::FindOn(const Face& face)
{
  const double h = this->HalfSide;
  const std::array<Point2, 4> corners{ { { -h, -h }, { h, -h }, { h, h }, { -h, h } } };
  this->Sides.clear();
  for (std::size_t k = 0; k < 4; ++k)
  {
    this->AddSide(face, { corners[k], corners[(k + 1) % 4] });
  }
  for (const Other& other : this->Others)
  {
    if (other.Ball.Frame != NoId)
    {
      this->CutCube(face, other.Ball);
    }
  }
  for (std::size_t j = 0; j < this->Sides.size(); ++j)
  {
    const Side& side = this->Sides[j];
    this->Keep(face, side.Tail);
    this->Keep(face, side.Head);
    for (std::size_t k = 0; k < j; ++k)
    {
      this->CrossSides(face, side, this->Sides[k]);
    }
  }
}

/// Each of its six planes has a line in the plane of the face: a x + b y = c.
void CubeMeetings::CutCube(const Face& face, const GuardedBall& other)
{
  constexpr double Parallel = 1e-9;
  const CubeAxes& axes = this->Axes[static_cast<std::size_t>(other.Frame)];
  const Point3 way = face.Origin - other.Center;
  const double halfSide = HalfSideShare * other.Radius;
  for (std::size_t d = 0; d < 3; ++d)
  {
    const Point2 slope{ Dot(axes[d], face.U), Dot(axes[d], face.V) };
    const double slope2 = Dot(slope, slope);
    for (int sign = -1; sign <= 1 && slope2 > Parallel; sign += 2)
    {
      const Point2 start = (sign * halfSide - Dot(axes[d], way)) / slope2 * slope;
      const Point2 along = 1.0 / std::sqrt(slope2) * Perpendicular(slope);
      LinePart part;
      part.Cut(start.X, along.X, this->HalfSide);
      part.Cut(start.Y, along.Y, this->HalfSide);
      for (const std::size_t e : { (d + 1) % 3, (d + 2) % 3 })
      {
        const Point2 other2{ Dot(axes[e], face.U), Dot(axes[e], face.V) };
        part.Cut(Dot(axes[e], way) + Dot(other2, start), Dot(other2, along), halfSide);
      }
      if (part.Begin < part.End)
      {
        this->AddSide(face, { start + part.Begin * along, start + part.End * along });
      }
    }
  }
}

void CubeMeetings::AddSide(const Face& face, const Side& side)
{
  const Point3 tail = face.At(side.Tail);
  const Point3 head = face.At(side.Head);
  if (!std::any_of(this->Others.begin(), this->Others.end(),
        [this, &tail, &head](const Other& other)
        { return this->IsGuarded(other.Ball, tail) && this->IsGuarded(other.Ball, head); }))
  {
    this->Sides.push_back(side);
  }
}

void CubeMeetings::CrossSides(const Face& face, const Side& a, const Side& b)
{
  const Point2 wayA = a.Head - a.Tail;
  const Point2 wayB = b.Head - b.Tail;
  const Point2 between = b.Tail - a.Tail;
  const double turn = Cross(wayA, wayB);
  const double partA = Cross(between, wayB) / turn;
  const double partB = Cross(between, wayA) / turn;
  if (turn != 0.0 && partA >= 0.0 && partA <= 1.0 && partB >= 0.0 && partB <= 1.0)
  {
    this->Keep(face, a.Tail + partA * wayA);
  }
}

void CubeMeetings::Keep(const Face& face, const Point2& place)
{
  const double most = (1.0 + Rounding) * this->HalfSide;
  const Point3 inSpace = face.At(place);
  const auto hasIt = [this, &inSpace](const Other& other)
  { return this->IsGuarded(other.Ball, inSpace); };
  const auto isNear = [this, &inSpace](const Point3& meeting)
  {
    const Point3 apart = inSpace - meeting;
    const double near = Rounding * this->HalfSide;
    return Dot(apart, apart) <= near * near;
  };
  if (std::abs(place.X) <= most && std::abs(place.Y) <= most &&
    std::none_of(this->Others.begin(), this->Others.end(), hasIt) &&
    std::none_of(this->Meetings.begin(), this->Meetings.end(), isNear))
  {
    this->Meetings.push_back(inSpace);
  }
}

} // namespace biting
