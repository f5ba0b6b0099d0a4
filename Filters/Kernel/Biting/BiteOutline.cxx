// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "BiteOutline.h"

#include <algorithm> // for sort

namespace biting
{

namespace
{

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

// Clips [low, high] to where |offset + t slope| < halfWidth.
void ClipToSlab(double offset, double slope, double halfWidth, double& low, double& high)
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
  this->Axis = bites.Axes[bite];
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
  const double halfWidth = bites.HalfWidths[other];
  const Point2& axis = bites.Axes[other];
  if (AreParallel(axis, this->Axis))
  {
    this->CoverAligned(center, halfWidth);
    return;
  }
  this->CoverTurned(center, { Dot(axis, this->Axis), Cross(this->Axis, axis) }, halfWidth);
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
    ClipToSlab(Dot(offset, axis), Dot(direction, axis), halfWidth, low, high);
    ClipToSlab(Cross(axis, offset), Cross(axis, direction), halfWidth, low, high);
    this->Add(side, low, high);
  }
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
  const Point2 origin = this->At(side, 0.0) - box.Center();
  const Point2 direction = side % 2 == 0 ? Perpendicular(this->Axis) : this->Axis;
  Interval part{ gap.Low - margin, gap.High + margin };
  ClipToSlab(origin.X, direction.X, 0.5 * box.Width() + margin, part.Low, part.High);
  ClipToSlab(origin.Y, direction.Y, 0.5 * box.Height() + margin, part.Low, part.High);
  return part;
}

Point2 BiteOutline::At(int side, double place) const
{
  const double level = side < 2 ? this->HalfWidth : -this->HalfWidth;
  const Point2 local = side % 2 == 0 ? Point2{ level, place } : Point2{ place, level };
  return this->Center + local.X * this->Axis + local.Y * Perpendicular(this->Axis);
}

void DirectionMask::Add(const Bites& bites, Id bite, const Point2& p, double slack)
{
  static const std::array<std::uint64_t, 4> Aligned = { ProbesAgainst({ 1.0, 0.0 }),
    ProbesAgainst({ 0.0, 1.0 }), ProbesAgainst({ -1.0, 0.0 }), ProbesAgainst({ 0.0, -1.0 }) };
  const Point2 offset = p - bites.Centers[bite];
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

} // namespace biting
