// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "LevelLine.h"

#include <algorithm> // for min, max
#include <cmath>     // for sqrt

namespace biting
{

/// Beside the line values that are as large as fill values would leave nothing but rounding. They
/// count as so many times what rises with the slope across the cell.
constexpr double LargestRise = 1e6;

LevelLine::LevelLine(const Box2& cell, const std::array<double, 4>& values, double slope)
  : Cell(cell)
  , Values(values)
  , Slope(slope)
{
  for (double& value : this->Values)
  {
    value = std::min(value, LargestRise * slope * cell.Diagonal());
  }
}

/// The line leads from side to side of the cell, as a hyperbola does: between points of it that are
/// found by halving it is nearly straight.
double LevelLine::Bound(const Point2& x) const
{
  std::array<Point2, 4> crossings;
  std::size_t count = 0;
  for (std::size_t corner = 0; corner < 4; ++corner)
  {
    const std::size_t next = (corner + 1) % 4;
    const double here = this->Values[corner];
    const double there = this->Values[next];
    if ((here < 0.0) != (there < 0.0))
    {
      const Point2 start = this->CornerAt(corner);
      crossings[count++] = start + (here / (here - there)) * (this->CornerAt(next) - start);
    }
  }
  double bound = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k + (count == 2 ? 1 : 0) < count; ++k)
  {
    bound = std::min(bound, this->BoundFromPart(crossings[k], crossings[(k + 1) % count], x, 2));
  }
  return bound;
}

Point2 LevelLine::CornerAt(std::size_t corner) const
{
  return { corner == 1 || corner == 2 ? this->Cell.High.X : this->Cell.Low.X,
    corner >= 2 ? this->Cell.High.Y : this->Cell.Low.Y };
}

/// The nearest point of the line on the ways to corners on its other side. Along these, what is
/// bilinear is quadratic.
Point2 LevelLine::TowardsCorners(const Point2& place) const
{
  const double here = this->At(place).Value;
  Point2 nearest = place;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t corner = 0; corner < 4; ++corner)
  {
    const double there = this->Values[corner];
    if ((there < 0.0) != (here < 0.0))
    {
      const Point2 way = this->CornerAt(corner) - place;
      const double square = 2.0 * (here + there - 2.0 * this->At(place + 0.5 * way).Value);
      const double linear = there - here - square;
      const double root = std::sqrt(std::max(linear * linear - 4.0 * square * here, 0.0));
      const double divisor = here < 0.0 ? -linear - root : root - linear;
      const double along = divisor != 0.0 ? std::min(2.0 * here / divisor, 1.0) : 0.0;
      nearest = along * Length(way) < least ? place + along * way : nearest;
      least = std::min(least, along * Length(way));
    }
  }
  return nearest;
}

/// Between two points of the line, after so many halvings.
double LevelLine::BoundFromPart(
  const Point2& start, const Point2& end, const Point2& x, int halvings) const
{
  if (halvings > 0)
  {
    const Point2 middle = this->TowardsCorners(Midpoint(start, end));
    return std::min(this->BoundFromPart(start, middle, x, halvings - 1),
      this->BoundFromPart(middle, end, x, halvings - 1));
  }
  const Point2 way = end - start;
  const double length = Dot(way, way);
  const double along = length > 0.0 ? Dot(x - start, way) / length : 0.0;
  const Point2 foot = this->AlongGradient(start + std::min(std::max(along, 0.0), 1.0) * way);
  const Point2 place = this->AlongGradient(foot + this->AlongLine(foot, x - foot));
  return std::min(this->BoundFromPlace(foot, x), this->BoundFromPlace(place, x));
}

double LevelLine::BoundFromPlace(const Point2& place, const Point2& x) const
{
  return std::max(this->At(place).Value, 0.0) + this->Slope * Distance(x, place);
}

/// The part of an offset that leads along the line.
Point2 LevelLine::AlongLine(const Point2& place, const Point2& offset) const
{
  const Point2 gradient = this->At(place).Gradient;
  const double square = Dot(gradient, gradient);
  return square > 0.0 ? offset - (Dot(offset, gradient) / square) * gradient : Point2{};
}

/// Within the cell, after two steps of Newton's method towards the line.
Point2 LevelLine::AlongGradient(Point2 place) const
{
  for (int step = 0; step < 2; ++step)
  {
    place = this->Inside(place);
    const Local local = this->At(place);
    const double square = Dot(local.Gradient, local.Gradient);
    place = square > 0.0 ? place - (local.Value / square) * local.Gradient : place;
  }
  return this->Inside(place);
}

Point2 LevelLine::Inside(const Point2& place) const
{
  return { std::min(std::max(this->Cell.Low.X, place.X), this->Cell.High.X),
    std::min(std::max(this->Cell.Low.Y, place.Y), this->Cell.High.Y) };
}

LevelLine::Local LevelLine::At(const Point2& place) const
{
  const auto& [a, b, c, d] = this->Values;
  const double width = this->Cell.Width();
  const double height = this->Cell.Height();
  if (!(width * height > 0.0))
  {
    return { 0.0, {} };
  }
  const double u = (place.X - this->Cell.Low.X) / width;
  const double v = (place.Y - this->Cell.Low.Y) / height;
  const double below = (1.0 - u) * a + u * b;
  const double above = (1.0 - u) * d + u * c;
  return { (1.0 - v) * below + v * above,
    { ((1.0 - v) * (b - a) + v * (c - d)) / width, (above - below) / height } };
}

} // namespace biting
