// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "OutlineCover.h"

#include <cmath> // for abs, sqrt

namespace biting
{

namespace
{

// Of a half-width: bites that only touch cover nothing, nor does rounding to single precision, by
// which the ends of intervals are those of bites that differ by a few times 6e-8.
constexpr double Inside = 1.0 - 1e-5;
constexpr double LeastSlope = 1e-20; // far below rounding: keeps quotients finite

using Lanes = std::array<float, 4>; // one value for each side

// The outward normals of the sides, and which of the sides these are.
constexpr Lanes NormalX = { 1.0f, 0.0f, -1.0f, 0.0f };
constexpr Lanes NormalY = { 0.0f, 1.0f, 0.0f, -1.0f };
constexpr Lanes Even = { 1.0f, 0.0f, 1.0f, 0.0f };
constexpr Lanes Odd = { 0.0f, 1.0f, 0.0f, 1.0f };

constexpr float Piece = 2.0f / 63.0f;

// Comparisons without a branch.
float Greater(float a, float b)
{
  return a > b ? a : b;
}

float Less(float a, float b)
{
  return a < b ? a : b;
}

// A place between -1 and 1 in units of pieces, from the first; 0 or 63 beyond.
float InPieces(float place)
{
  constexpr float Half = 31.5f;
  return Less(Greater(Half * place + Half, 0.0f), 63.0f);
}

// The first ones of 63 pieces.
std::uint64_t PiecesBefore(float count)
{
  return (std::uint64_t{ 1 } << static_cast<int>(count)) - 1;
}

// Those that lie whole between two places.
std::uint64_t PiecesBetween(float low, float high)
{
  return PiecesBefore(high) & ~PiecesBefore(low);
}

// Grows from -1 to 1 with the direction of p, counterclockwise from that against x.
float Turn(float x, float y)
{
  const float share = 0.5f * x / (std::abs(x) + std::abs(y));
  return y >= 0.0f ? 0.5f - share : share - 0.5f;
}

double AwayFromZero(double slope)
{
  return slope + LeastSlope;
}

} // namespace

OutlineCover::OutlineCover(const Bites& bites, Id bite)
  : All(bites)
  , Bite(bite)
  , Axis(bites.IsCircle(bite) ? Point2{ 1.0, 0.0 } : bites.Axes[bite])
  , PerHalfWidth(1.0 / bites.HalfWidths[bite])
{
  if (bites.IsCircle(bite))
  {
    this->Covered = { 0, AllPieces, AllPieces, AllPieces };
  }
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
// other two. In the frame of each side, which is turned by a quarter from one to the next: the side
// at x = 1, places growing with y.
void OutlineCover::CoverBySquare(const Point2& center, const Point2& axis, double halfWidth)
{
  const float axisX = static_cast<float>(AwayFromZero(axis.X));
  const float axisY = static_cast<float>(AwayFromZero(axis.Y));
  const float reach = static_cast<float>(halfWidth);
  const float x = static_cast<float>(center.X);
  const float y = static_cast<float>(center.Y);
  const float first = axisX / axisY;
  const float second = axisY / axisX;
  const float reachX = std::abs(reach / axisX);
  const float reachY = std::abs(reach / axisY);
  Lanes lows;
  Lanes highs;
  for (int side = 0; side < 4; ++side)
  {
    const float away = 1.0f - NormalX[side] * x - NormalY[side] * y;
    const float middle = NormalX[side] * y - NormalY[side] * x;
    const float one = middle - away * (Even[side] * first - Odd[side] * second);
    const float two = middle + away * (Even[side] * second - Odd[side] * first);
    const float oneReach = Even[side] * reachY + Odd[side] * reachX;
    const float twoReach = Even[side] * reachX + Odd[side] * reachY;
    lows[side] = InPieces(Greater(one - oneReach, two - twoReach) + Piece);
    highs[side] = InPieces(Less(one + oneReach, two + twoReach));
  }
  for (int side = 0; side < 4; ++side)
  {
    this->Covered[side] |= PiecesBetween(lows[side], highs[side]);
  }
}

void OutlineCover::CoverSquareByCircle(const Point2& center, double radius)
{
  const float x = static_cast<float>(center.X);
  const float y = static_cast<float>(center.Y);
  const float reach = static_cast<float>(radius);
  for (int side = 0; side < 4; ++side)
  {
    const float away = 1.0f - NormalX[side] * x - NormalY[side] * y;
    const float middle = NormalX[side] * y - NormalY[side] * x;
    const float half = std::sqrt(Greater((reach - away) * (reach + away), 0.0f));
    this->Covered[side] |= PiecesBetween(InPieces(middle - half + Piece), InPieces(middle + half));
  }
}

// The places u of the circle with u . center > along.
void OutlineCover::CoverCircleByCircle(const Point2& center, double radius)
{
  const float x = static_cast<float>(center.X);
  const float y = static_cast<float>(center.Y);
  const float square = x * x + y * y;
  const float along = 0.5f * (square + static_cast<float>((1.0 - radius) * (1.0 + radius)));
  const float rest = square - along * along;
  const float half = std::sqrt(Greater(rest, 0.0f));
  const float first = Turn(along * x + half * y, along * y - half * x);
  const float last = Turn(along * x - half * y, along * y + half * x);
  const std::uint64_t beyond = AllPieces * static_cast<std::uint64_t>(last < first);
  const std::uint64_t from = ~PiecesBefore(InPieces(first + Piece));
  const std::uint64_t to = PiecesBefore(InPieces(last));
  const std::uint64_t arc = (from & to) | (beyond & (from | to));
  this->Covered[0] |= arc & (AllPieces * static_cast<std::uint64_t>(rest > 0.0f));
}

} // namespace biting
