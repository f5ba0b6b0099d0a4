// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "OutlineCover.h"

#include <algorithm> // for min, max, all_of
#include <cmath>     // for abs, sqrt

namespace biting
{

namespace
{

constexpr double Inside = 1.0 - 1e-9; // of a half-width: bites that only touch cover nothing
constexpr double DiagonalOfSquare = 1.41421356237309504880; // of a half-width
constexpr double LeastSlope = 1e-100; // in place of zero, so that quotients are finite or unbounded

// Grows from -1 to 1 with the direction of p, counterclockwise from that against x.
double Turn(const Point2& p)
{
  const double share = 0.5 * p.X / (std::abs(p.X) + std::abs(p.Y));
  return p.Y >= 0.0 ? 0.5 - share : share - 0.5;
}

double AwayFromZero(double slope)
{
  return std::abs(slope) > LeastSlope ? slope : LeastSlope;
}

} // namespace

OutlineCover::OutlineCover(const Bites& bites, Id bite)
  : All(bites)
  , Bite(bite)
  , Axis(bites.IsCircle(bite) ? Point2{ 1.0, 0.0 } : bites.Axes[bite])
  , PerHalfWidth(1.0 / bites.HalfWidths[bite])
{
}

void OutlineCover::Cover(Id other)
{
  const Point2 offset =
    this->PerHalfWidth * (this->All.Centers[other] - this->All.Centers[this->Bite]);
  const Point2 center{ Dot(offset, this->Axis), Cross(this->Axis, offset) };
  const double reach = Inside * this->PerHalfWidth * this->All.HalfWidths[other];
  const bool isCircle = this->All.IsCircle(this->Bite);
  if (this->All.IsCircle(other))
  {
    isCircle ? this->CoverCircleByCircle(center, reach) : this->CoverSquareByCircle(center, reach);
  }
  else if (!isCircle)
  {
    const Point2& axis = this->All.Axes[other];
    this->CoverBySquare(center, { Dot(axis, this->Axis), Cross(this->Axis, axis) }, reach);
  }
}

// A place on a side is inside where it is between two sides of the other square, and between the
// other two.
void OutlineCover::CoverBySquare(const Point2& center, const Point2& axis, double halfWidth)
{
  const double perX = 1.0 / AwayFromZero(axis.X);
  const double perY = 1.0 / AwayFromZero(axis.Y);
  const double reachX = std::abs(perX) * halfWidth;
  const double reachY = std::abs(perY) * halfWidth;
  const double diagonal = DiagonalOfSquare * halfWidth;
  for (int side = 0; side < 4; ++side)
  {
    const bool isVertical = side % 2 == 0;
    const double level = side < 2 ? 1.0 : -1.0;
    const double away = level - (isVertical ? center.X : center.Y);
    if (std::abs(away) >= diagonal)
    {
      continue;
    }
    const double middle = isVertical ? center.Y : center.X;
    const double slope = isVertical ? -away : away;
    const double alongX = middle - slope * axis.Y * perX;
    const double alongY = middle + slope * axis.X * perY;
    this->Add(this->Sides[side], std::max(alongX - reachX, alongY - reachY),
      std::min(alongX + reachX, alongY + reachY));
  }
}

void OutlineCover::CoverSquareByCircle(const Point2& center, double radius)
{
  for (int side = 0; side < 4; ++side)
  {
    const double level = side < 2 ? 1.0 : -1.0;
    const double away = level - (side % 2 == 0 ? center.X : center.Y);
    const double middle = side % 2 == 0 ? center.Y : center.X;
    const double reach = std::sqrt(std::max(0.0, (radius - away) * (radius + away)));
    this->Add(this->Sides[side], middle - reach, middle + reach);
  }
}

void OutlineCover::CoverCircleByCircle(const Point2& center, double radius)
{
  const double distance = Length(center);
  const double along = 0.5 * (distance + (1.0 - radius) * (1.0 + radius) / distance);
  if (!(std::abs(along) < 1.0))
  {
    return;
  }
  const Point2 toward = 1.0 / distance * center;
  const Point2 across = std::sqrt((1.0 - along) * (1.0 + along)) * Perpendicular(toward);
  const double first = Turn(along * toward - across);
  const double last = Turn(along * toward + across);
  if (first < last)
  {
    this->Add(this->Sides[0], first, last);
    return;
  }
  this->Add(this->Sides[0], first, 2.0);
  this->Add(this->Sides[0], -2.0, last);
}

void OutlineCover::Add(Side& side, double low, double high)
{
  if (low < high && low < 1.0 && high > -1.0 && side.Count < Most)
  {
    side.Lows[side.Count] = low;
    side.Highs[side.Count++] = high;
  }
}

bool OutlineCover::IsFull() const
{
  if (this->All.IsCircle(this->Bite))
  {
    return this->IsFull(this->Sides[0]);
  }
  return std::all_of(this->Sides.begin(), this->Sides.end(),
    [this](const Side& side) { return this->IsFull(side); });
}

bool OutlineCover::IsFull(const Side& side) const
{
  double end = -1.0;
  for (double last = -2.0; last < end && end <= 1.0;)
  {
    last = end;
    for (int k = 0; k < side.Count; ++k)
    {
      end = side.Lows[k] < last ? std::max(end, side.Highs[k]) : end;
    }
  }
  return end > 1.0;
}

} // namespace biting
