// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "CutRows.h"

#include <algorithm> // for min, max
#include <cmath>     // for sqrt, round, abs

namespace biting
{

namespace
{

// Of f, and of lengths: what is not seen in a mesh.
constexpr double LevelWithin = 0.005;

} // namespace

double CutRows::FittingPlace(double place, const Box2& part, bool isVertical) const
{
  const Box2 box = this->Within(part);
  Point2 middle = 0.5 * (box.Low + box.High);
  (isVertical ? middle.X : middle.Y) = place;
  const double side = this->SideLength * this->SpacingAt(middle);
  const double wanted = this->IsStraight(isVertical) ? Pair * side : side;
  const Box2& base = this->IsStraight(isVertical) ? this->Bounds : this->Sides;
  const double width = Coordinate(base.High, isVertical) - Coordinate(base.Low, isVertical);
  const double step = width / std::max(1.0, std::round(width / wanted));
  const bool isCut = Coordinate(part.Low, isVertical) > Coordinate(this->Bounds.Low, isVertical);
  const double low = Coordinate(isCut ? box.Low : base.Low, isVertical);
  return low + step * std::round((place - low) / step);
}

// The height of rows follows from how many fill the part; along them sides are as wanted.
double CutRows::StretchOf(const Box2& part) const
{
  const Box2 box = this->Within(part);
  if (!this->IsFirstVertical || !this->IsLevel(box))
  {
    return 1.0;
  }
  const double width =
    Coordinate(box.High, *this->IsFirstVertical) - Coordinate(box.Low, *this->IsFirstVertical);
  const double side = this->SideLength * this->SpacingAt(0.5 * (box.Low + box.High));
  const double rows = 2.0 * std::max(1.0, std::round(width / (Pair * side)));
  const double height = width / (rows * side);
  const double stretch = std::sqrt(height * height + 0.25);
  return std::abs(stretch - 1.0) < LevelWithin ? stretch : 1.0;
}

Box2 CutRows::Within(const Box2& part) const
{
  Box2 box;
  box.Low = { std::max(part.Low.X, this->Bounds.Low.X), std::max(part.Low.Y, this->Bounds.Low.Y) };
  box.High = { std::min(part.High.X, this->Bounds.High.X),
    std::min(part.High.Y, this->Bounds.High.Y) };
  return box;
}

// In the middle and near the corners.
bool CutRows::IsLevel(const Box2& part) const
{
  const Point2 middle = 0.5 * (part.Low + part.High);
  const Point2 toHigh = 0.4 * (part.High - part.Low);
  const Point2 toSide{ toHigh.X, -toHigh.Y };
  const double f = this->SpacingAt(middle);
  const auto isAsThere = [this, f](const Point2& p)
  { return std::abs(this->SpacingAt(p) - f) < LevelWithin * f; };
  return isAsThere(middle + toHigh) && isAsThere(middle - toHigh) && isAsThere(middle + toSide) &&
    isAsThere(middle - toSide);
}

} // namespace biting
