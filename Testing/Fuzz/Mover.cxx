// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Mover.h"

#include "Base/Numbers.h"

#include <algorithm> // for max, transform
#include <cmath>     // for abs, nextafter
#include <limits>    // for poison

namespace biting
{

void Mover::Move(Places& places)
{
  if (this->Numbers.OneIn(3))
  {
    const Turn turn = Turn::OfHalfTangent(2.0 * this->Numbers.Unit() - 1.0);
    std::transform(places.begin(), places.end(), places.begin(), turn);
  }
  if (this->Numbers.OneIn(16))
  {
    this->Scale(places, 1.0, this->Numbers.Power(-40, 0));
  }
  if (this->Numbers.OneIn(4))
  {
    const double factor = this->Numbers.Power(-30, 30);
    this->Scale(places, factor, factor);
  }
  if (this->Numbers.OneIn(4))
  {
    this->Shift(places);
  }
  if (this->Numbers.OneIn(4))
  {
    this->Shake(places);
  }
  if (this->Numbers.OneIn(100))
  {
    this->Poison(places);
  }
}

void Mover::Shake(Places& places)
{
  const int kind = this->Numbers.Below(4);
  for (Point2& place : places)
  {
    place.X = this->Shaken(place.X, kind);
    place.Y = this->Shaken(place.Y, kind);
  }
}

/// By a few ulp, or a part of the coordinate that is small.
double Mover::Shaken(double coordinate, int kind)
{
  if (kind == 3)
  {
    return coordinate * (1.0 + this->Numbers.Power(-50, -20));
  }
  for (int ulps = this->Numbers.Below(2 + 4 * kind); ulps > 0; --ulps)
  {
    coordinate = std::nextafter(coordinate, kind == 0 ? Infinity : -Infinity);
  }
  return coordinate;
}

/// By up to a million sizes.
void Mover::Shift(Places& places)
{
  double size = 0.0;
  for (const Point2& place : places)
  {
    size = std::max({ size, std::abs(place.X), std::abs(place.Y) });
  }
  const Point2 shift{ size * this->Numbers.Power(-4, 20), -size * this->Numbers.Power(-4, 20) };
  for (Point2& place : places)
  {
    place = place + shift;
  }
}

void Mover::Scale(Places& places, double factorX, double factorY)
{
  for (Point2& place : places)
  {
    place = { factorX * place.X, factorY * place.Y };
  }
}

void Mover::Poison(Places& places)
{
  const double poisons[] = { std::numeric_limits<double>::quiet_NaN(), Infinity, -Infinity, 1e80,
    1e-80, -1e-310, 1e308, 1e69 };
  if (places.empty())
  {
    return;
  }
  Point2& place =
    places[static_cast<std::size_t>(this->Numbers.Below(static_cast<int>(places.size())))];
  (this->Numbers.OneIn(2) ? place.X : place.Y) = poisons[this->Numbers.Below(8)];
}

} // namespace biting
