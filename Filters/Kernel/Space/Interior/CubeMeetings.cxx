// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "CubeMeetings.h"

#include <algorithm> // for any_of, max, min, sort
#include <cmath>     // for abs, sqrt

namespace biting
{

namespace
{

/// Places that near are one, in half sides; and so far beyond sides there are meetings, too.
constexpr double Rounding = 1e-6;

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

bool CubeMeetings::IsGuarded(
  const GuardedBall& ball, const std::vector<CubeAxes>& axes, const Point3& place)
{
  const Point3 apart = place - ball.Center;
  if (ball.Frame == NoId)
  {
    return Dot(apart, apart) < ball.Guard * ball.Guard;
  }
  bool isIn = true;
  for (const Point3& axis : axes[static_cast<std::size_t>(ball.Frame)])
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

void CubeMeetings::Add(const GuardedBall& other)
{
  const Point3 way = other.Center - this->Own.Center;
  const double way2 = Dot(way, way);
  const double reach = this->Own.Radius + other.Radius;
  bool mayMeet = way2 < reach * reach;
  for (const Point3& axis : this->Axes[static_cast<std::size_t>(this->Own.Frame)])
  {
    mayMeet = mayMeet && std::abs(Dot(way, axis)) < this->HalfSide + this->HalfWidth(other, axis);
  }
  if (mayMeet)
  {
    this->Others.push_back({ other, way2 });
  }
}

double CubeMeetings::HalfWidth(const GuardedBall& ball, const Point3& direction) const
{
  if (ball.Frame == NoId)
  {
    return ball.Radius;
  }
  double width = 0.0;
  for (const Point3& axis : this->Axes[static_cast<std::size_t>(ball.Frame)])
  {
    width += HalfSideShare * ball.Radius * std::abs(Dot(axis, direction));
  }
  return width;
}

const std::vector<Point3>& CubeMeetings::Find()
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
  return this->Meetings;
}

void CubeMeetings::FindOn(const Face& face)
{
  const double h = this->HalfSide;
  const std::array<Point2, 4> corners{ { { -h, -h }, { h, -h }, { h, h }, { -h, h } } };
  this->Sides.clear();
  this->Disks.clear();
  for (std::size_t k = 0; k < 4; ++k)
  {
    this->AddSide(face, { corners[k], corners[(k + 1) % 4] });
  }
  for (const Other& other : this->Others)
  {
    if (other.Ball.Frame != NoId)
    {
      this->CutCube(face, other);
      continue;
    }
    const Point3 way = other.Ball.Center - face.Origin;
    const Point2 foot{ Dot(way, face.U), Dot(way, face.V) };
    const double height2 = Dot(way, way) - Dot(foot, foot);
    const double radius2 = other.Ball.Radius * other.Ball.Radius - height2;
    if (radius2 > 0.0)
    {
      this->Disks.push_back({ foot, radius2 });
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
    for (const Disk& disk : this->Disks)
    {
      this->CrossCircle(face, disk, side);
    }
  }
  for (std::size_t j = 0; j < this->Disks.size(); ++j)
  {
    for (std::size_t k = 0; k < j; ++k)
    {
      this->CrossCircles(face, this->Disks[j], this->Disks[k]);
    }
  }
}

/// Each of its six planes has a line in the plane of the face: a x + b y = c.
void CubeMeetings::CutCube(const Face& face, const Other& other)
{
  constexpr double Parallel = 1e-9;
  const CubeAxes& axes = this->Axes[static_cast<std::size_t>(other.Ball.Frame)];
  const Point3 way = face.Origin - other.Ball.Center;
  const double halfSide = HalfSideShare * other.Ball.Radius;
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
        [this, &tail, &head](const Other& other) {
          return IsGuarded(other.Ball, this->Axes, tail) && IsGuarded(other.Ball, this->Axes, head);
        }))
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

void CubeMeetings::CrossCircle(const Face& face, const Disk& disk, const Side& side)
{
  const Point2 way = side.Head - side.Tail;
  const Point2 away = side.Tail - disk.Center;
  const double way2 = Dot(way, way);
  const double half = Dot(away, way) / way2;
  const double rest = half * half - (Dot(away, away) - disk.Radius2) / way2;
  for (const double sign : { -1.0, 1.0 })
  {
    const double part = -half + sign * std::sqrt(std::max(0.0, rest));
    if (rest >= 0.0 && part >= 0.0 && part <= 1.0)
    {
      this->Keep(face, side.Tail + part * way);
    }
  }
}

void CubeMeetings::CrossCircles(const Face& face, const Disk& a, const Disk& b)
{
  const Point2 way = b.Center - a.Center;
  const double way2 = Dot(way, way);
  const double part = 0.5 * (1.0 + (a.Radius2 - b.Radius2) / way2);
  const double rise2 = a.Radius2 / way2 - part * part;
  for (const double sign : { -1.0, 1.0 })
  {
    if (rise2 >= 0.0)
    {
      const Point2 rise = sign * std::sqrt(rise2) * Perpendicular(way);
      this->Keep(face, a.Center + part * way + rise);
    }
  }
}

void CubeMeetings::Keep(const Face& face, const Point2& place)
{
  const double most = (1.0 + Rounding) * this->HalfSide;
  const Point3 inSpace = face.At(place);
  const auto hasIt = [this, &inSpace](const Other& other)
  { return IsGuarded(other.Ball, this->Axes, inSpace); };
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
