// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "BiteOutline.h"

#include <algorithm> // for sort
#include <cmath>     // for sqrt, acos
#include <utility>   // for pair

namespace biting
{

namespace
{

constexpr double RightAngle = 1.57079632679489661923; // in radians
constexpr int NumberOfProbes = 64;
constexpr double BoxMargin = 1e-12;     // of a half-width: far above the rounding of a place
constexpr double AxisTolerance = 1e-12; // of a unit vector: the rounding of one direction

// Squares with these axes have parallel sides.
bool AreParallel(const Point2& a, const Point2& b)
{
  return std::min(std::abs(Cross(a, b)), std::abs(Dot(a, b))) <= AxisTolerance;
}

std::array<Point2, NumberOfProbes> MakeProbes()
{
  constexpr double Step = 2.0 * 3.14159265358979323846 / NumberOfProbes;
  std::array<Point2, NumberOfProbes> probes;
  for (int k = 0; k < NumberOfProbes; ++k)
  {
    probes[k] = { std::cos((k + 0.5) * Step), std::sin((k + 0.5) * Step) };
  }
  return probes;
}

// The probes that point against `normal`.
std::uint64_t ProbesAgainst(const Point2& normal)
{
  static const std::array<Point2, NumberOfProbes> Probes = MakeProbes();
  std::uint64_t mask = 0;
  for (int k = 0; k < NumberOfProbes; ++k)
  {
    mask |= static_cast<std::uint64_t>(Dot(Probes[k], normal) < 0.0) << k;
  }
  return mask;
}

// The side of the square about the origin that lies in the direction of p.
int SideOf(const Point2& p)
{
  return std::abs(p.X) >= std::abs(p.Y) ? (p.X > 0.0 ? 0 : 2) : (p.Y > 0.0 ? 1 : 3);
}

// Where the ray to p meets that side of the square with half-width 1.
double PlaceOnSide(int side, const Point2& p)
{
  return side % 2 == 0 ? p.Y / std::abs(p.X) : p.X / std::abs(p.Y);
}

// Half the arc of a circle that each side of a square cuts off, in radians; negative: none.
using CutOff = std::array<double, 4>;

// What is left of the circle between the arc of `side` and the next one counterclockwise: angles
// from the normal of `side`, ascending where there is any.
std::pair<double, double> LeftBehind(const CutOff& arcs, int side)
{
  int turns = 1;
  while (arcs[(side + turns) % 4] < 0.0 && turns < 4)
  {
    ++turns;
  }
  double from = arcs[side];
  double to = turns * RightAngle - arcs[(side + turns) % 4];
  for (int k = turns; k < 4; ++k)
  {
    const double arc = arcs[(side + k) % 4];
    from = arc < 0.0 ? from : std::max(from, (k - 4) * RightAngle + arc);
    to = arc < 0.0 ? to : std::min(to, k * RightAngle - arc);
  }
  return { from, std::min(to, 4 * RightAngle - arcs[side]) };
}

// Clips [low, high] to where |offset + t slope| < halfWidth.
void ClipToOpenSlab(double offset, double slope, double halfWidth, double& low, double& high)
{
  if (slope == 0.0)
  {
    high = std::abs(offset) < halfWidth ? high : low;
    return;
  }
  const double first = (-halfWidth - offset) / slope;
  const double second = (halfWidth - offset) / slope;
  low = std::max(low, std::min(first, second));
  high = std::min(high, std::max(first, second));
}

} // namespace

void BiteOutline::Begin(const Bites& bites, Id bite)
{
  this->Center = bites.Centers[bite];
  this->IsCircle = bites.IsCircle(bite);
  this->Axis = this->IsCircle ? Point2{ 1.0, 0.0 } : bites.Axes[bite];
  this->HalfWidth = bites.HalfWidths[bite];
  for (std::vector<Interval>& side : this->Covered)
  {
    side.clear();
  }
}

void BiteOutline::Cover(const Bites& bites, Id other)
{
  const Point2 offset = bites.Centers[other] - this->Center;
  const Point2 center{ Dot(offset, this->Axis), Cross(this->Axis, offset) };
  if (bites.IsCircle(other))
  {
    this->CoverByCircle(center, bites.HalfWidths[other]);
    return;
  }
  this->CoverBySquare(center, bites.Axes[other], bites.HalfWidths[other]);
}

void BiteOutline::CoverBySquare(const Point2& center, const Point2& axis, double halfWidth)
{
  const Point2 turned{ Dot(axis, this->Axis), Cross(this->Axis, axis) };
  if (this->IsCircle)
  {
    this->CoverCircleBySquare(center, turned, halfWidth);
  }
  else if (AreParallel(axis, this->Axis))
  {
    this->CoverAligned(center, halfWidth);
  }
  else
  {
    this->CoverTurned(center, turned, halfWidth);
  }
}

void BiteOutline::CoverByCircle(const Point2& center, double radius)
{
  if (this->IsCircle)
  {
    this->CoverCircleByCircle(center, radius);
  }
  else
  {
    this->CoverSquareByCircle(center, radius);
  }
}

void BiteOutline::CoverAligned(const Point2& center, double halfWidth)
{
  if (std::abs(this->HalfWidth - center.X) < halfWidth)
  {
    this->Add(0, center.Y - halfWidth, center.Y + halfWidth);
  }
  if (std::abs(this->HalfWidth - center.Y) < halfWidth)
  {
    this->Add(1, center.X - halfWidth, center.X + halfWidth);
  }
  if (std::abs(this->HalfWidth + center.X) < halfWidth)
  {
    this->Add(2, center.Y - halfWidth, center.Y + halfWidth);
  }
  if (std::abs(this->HalfWidth + center.Y) < halfWidth)
  {
    this->Add(3, center.X - halfWidth, center.X + halfWidth);
  }
}

void BiteOutline::CoverTurned(const Point2& center, const Point2& axis, double halfWidth)
{
  for (int side = 0; side < 4; ++side)
  {
    const double level = side < 2 ? this->HalfWidth : -this->HalfWidth;
    const bool isVertical = side % 2 == 0;
    const Point2 middle = isVertical ? Point2{ level, 0.0 } : Point2{ 0.0, level };
    const Point2 direction = isVertical ? Point2{ 0.0, 1.0 } : Point2{ 1.0, 0.0 };
    const Point2 offset = middle - center;
    double low = -this->HalfWidth;
    double high = this->HalfWidth;
    ClipToOpenSlab(Dot(offset, axis), Dot(direction, axis), halfWidth, low, high);
    ClipToOpenSlab(Cross(axis, offset), Cross(axis, direction), halfWidth, low, high);
    this->Add(side, low, high);
  }
}

void BiteOutline::CoverSquareByCircle(const Point2& center, double radius)
{
  for (int side = 0; side < 4; ++side)
  {
    const double level = side < 2 ? this->HalfWidth : -this->HalfWidth;
    const double away = level - (side % 2 == 0 ? center.X : center.Y);
    const double middle = side % 2 == 0 ? center.Y : center.X;
    const double reach = std::sqrt(std::max(0.0, (radius - away) * (radius + away)));
    this->Add(side, middle - reach, middle + reach);
  }
}

// Each side of the square cuts off an arc about its normal. Between neighbouring arcs the circle is
// covered.
void BiteOutline::CoverCircleBySquare(const Point2& center, const Point2& axis, double halfWidth)
{
  const Point2 normals[4] = { axis, Perpendicular(axis), -1.0 * axis, -1.0 * Perpendicular(axis) };
  CutOff arcs;
  bool isCut = false;
  for (int side = 0; side < 4; ++side)
  {
    const double level = (halfWidth + Dot(center, normals[side])) / this->HalfWidth;
    arcs[side] = level < 1.0 ? std::acos(std::max(level, -1.0)) : -1.0;
    isCut = isCut || level < 1.0;
  }
  if (!isCut)
  {
    this->CoverAll();
    return;
  }
  for (int side = 0; side < 4; ++side)
  {
    const auto [from, to] = LeftBehind(arcs, side);
    if (arcs[side] >= 0.0 && from < to)
    {
      const Point2& normal = normals[side];
      this->AddArc(std::cos(from) * normal + std::sin(from) * Perpendicular(normal),
        std::cos(to) * normal + std::sin(to) * Perpendicular(normal));
    }
  }
}

void BiteOutline::CoverCircleByCircle(const Point2& center, double radius)
{
  const double r = this->HalfWidth;
  const double distance = Length(center);
  if (distance + r < radius)
  {
    this->CoverAll();
    return;
  }
  const double along =
    distance > 0.0 ? 0.5 * (distance + (r - radius) * (r + radius) / distance) : r;
  if (std::abs(along) < r)
  {
    const Point2 toward = 1.0 / distance * center;
    const Point2 across = std::sqrt((r - along) * (r + along)) * Perpendicular(toward);
    this->AddArc(along * toward - across, along * toward + across);
  }
}

void BiteOutline::CoverAll()
{
  for (int side = 0; side < 4; ++side)
  {
    this->Add(side, -2.0 * this->HalfWidth, 2.0 * this->HalfWidth);
  }
}

// The arc counterclockwise between two points of the circle. Places grow counterclockwise on sides
// 0 and 3.
void BiteOutline::AddArc(const Point2& first, const Point2& last)
{
  const auto add = [this](int side, double from, double to)
  {
    const double sign = side % 3 == 0 ? 1.0 : -1.0;
    this->Add(side, this->HalfWidth * std::min(sign * from, sign * to),
      this->HalfWidth * std::max(sign * from, sign * to));
  };
  const auto turn = [](int side, double place) { return side % 3 == 0 ? place : -place; };
  const int firstSide = SideOf(first);
  const int lastSide = SideOf(last);
  const double from = turn(firstSide, PlaceOnSide(firstSide, first));
  const double to = turn(lastSide, PlaceOnSide(lastSide, last));
  constexpr double Beyond = 2.0; // of a corner, which is at 1
  if (firstSide == lastSide && from < to)
  {
    add(firstSide, from, to);
    return;
  }
  add(firstSide, from, Beyond);
  for (int side = (firstSide + 1) % 4; side != lastSide; side = (side + 1) % 4)
  {
    add(side, -Beyond, Beyond);
  }
  add(lastSide, -Beyond, to);
}

void BiteOutline::Add(int side, double low, double high)
{
  if (low < high && low < this->HalfWidth && high > -this->HalfWidth)
  {
    this->Covered[side].push_back({ low, high });
  }
}

void BiteOutline::Finish()
{
  for (int side = 0; side < 4; ++side)
  {
    this->FindGaps(side);
  }
}

void BiteOutline::FindGaps(int side)
{
  std::vector<Interval>& covered = this->Covered[side];
  std::vector<Interval>& gaps = this->Uncovered[side];
  gaps.clear();
  std::sort(covered.begin(), covered.end(),
    [](const Interval& a, const Interval& b)
    { return a.Low < b.Low || (a.Low == b.Low && a.High < b.High); });
  double end = -this->HalfWidth;
  for (const Interval& interval : covered)
  {
    if (interval.Low > end)
    {
      gaps.push_back({ end, interval.Low });
    }
    end = std::max(end, interval.High);
  }
  if (end < this->HalfWidth)
  {
    gaps.push_back({ end, this->HalfWidth });
  }
}

bool BiteOutline::IsHiddenWithin(const Box2& box) const
{
  for (int side = 0; side < 4; ++side)
  {
    for (const Interval& gap : this->Uncovered[side])
    {
      const Interval part = this->PartWithin(side, gap, box);
      if (part.Low < part.High)
      {
        return false;
      }
    }
  }
  return true;
}

BiteOutline::Interval BiteOutline::PartWithin(int side, const Interval& gap, const Box2& box) const
{
  const double margin = BoxMargin * this->HalfWidth;
  if (this->IsCircle)
  {
    return this->ArcWithin(side, gap, box);
  }
  const Point2 origin = this->At(side, 0.0) - box.Center();
  const Point2 direction = side % 2 == 0 ? Perpendicular(this->Axis) : this->Axis;
  Interval part{ gap.Low - margin, gap.High + margin };
  ClipToOpenSlab(origin.X, direction.X, 0.5 * box.Width() + margin, part.Low, part.High);
  ClipToOpenSlab(origin.Y, direction.Y, 0.5 * box.Height() + margin, part.Low, part.High);
  return part;
}

// All of the arc, or nothing where the disc over its chord, in which it lies, is outside of the
// box.
BiteOutline::Interval BiteOutline::ArcWithin(int side, const Interval& gap, const Box2& box) const
{
  const Point2 first = this->At(side, gap.Low);
  const Point2 last = this->At(side, gap.High);
  Box2 hull = Box2::Around(first, last);
  hull.Grow(0.5 * Distance(first, last) + BoxMargin * this->HalfWidth);
  return hull.Meets(box) ? gap : Interval{ gap.High, gap.Low };
}

Point2 BiteOutline::At(int side, double place) const
{
  const double level = side < 2 ? this->HalfWidth : -this->HalfWidth;
  Point2 local = side % 2 == 0 ? Point2{ level, place } : Point2{ place, level };
  if (this->IsCircle)
  {
    local = this->HalfWidth / Length(local) * local;
  }
  return this->Center + local.X * this->Axis + local.Y * Perpendicular(this->Axis);
}

void DirectionMask::Add(const Bites& bites, Id bite, const Point2& p, double slack)
{
  static const std::array<std::uint64_t, 4> Aligned = { ProbesAgainst({ 1.0, 0.0 }),
    ProbesAgainst({ 0.0, 1.0 }), ProbesAgainst({ -1.0, 0.0 }), ProbesAgainst({ 0.0, -1.0 }) };
  const Point2 offset = p - bites.Centers[bite];
  if (bites.IsCircle(bite))
  {
    this->AddCircle(offset, Depth(bites, bite, p), slack);
    return;
  }
  const Point2& axis = bites.Axes[bite];
  const Point2 normals[4] = { axis, Perpendicular(axis), -1.0 * axis, -1.0 * Perpendicular(axis) };
  const bool isAligned = IsAxisAligned(bites, bite) && axis.X > 0.0;
  std::uint64_t mask = ~std::uint64_t{ 0 };
  for (int side = 0; side < 4; ++side)
  {
    const double depth = bites.HalfWidths[bite] - Dot(offset, normals[side]);
    if (depth < -slack)
    {
      return;
    }
    if (depth <= slack)
    {
      mask &= isAligned ? Aligned[side] : ProbesAgainst(normals[side]);
    }
  }
  this->Covered |= mask;
}

void DirectionMask::AddCircle(const Point2& offset, double depth, double slack)
{
  if (depth >= -slack)
  {
    this->Covered |= depth <= slack ? ProbesAgainst(offset) : ~std::uint64_t{ 0 };
  }
}

} // namespace biting
