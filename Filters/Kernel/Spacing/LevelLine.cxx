// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "LevelLine.h"

#include <algorithm> // for min, max
#include <cmath>     // for abs, sqrt

namespace biting
{

/// Beside the line values that are as large as fill values would leave nothing but rounding. They
/// count as so many times what rises with the slope across the cell.
constexpr double LargestRise = 1e6;

/// Of the line between two sides of the cell: then it is nearly straight.
constexpr int Halvings = 3;

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
    bound =
      std::min(bound, this->BoundFromPart(crossings[k], crossings[(k + 1) % count], x, Halvings));
  }
  return bound;
}

Point2 LevelLine::CornerAt(std::size_t corner) const
{
  return { corner == 1 || corner == 2 ? this->Cell.High.X : this->Cell.Low.X,
    corner >= 2 ? this->Cell.High.Y : this->Cell.Low.Y };
}

/// Between two points of the line, after so many halvings.
double LevelLine::BoundFromPart(
  const Point2& start, const Point2& end, const Point2& x, int halvings) const
{
  if (halvings > 0)
  {
    const Point2 middle = this->MiddleOf(start, end);
    return std::min(this->BoundFromPart(start, middle, x, halvings - 1),
      this->BoundFromPart(middle, end, x, halvings - 1));
  }
  const Point2 way = end - start;
  const double length = Dot(way, way);
  const double along = length > 0.0 ? Dot(x - start, way) / length : 0.0;
  const Point2 place = this->AlongAxis(start + std::min(std::max(along, 0.0), 1.0) * way);
  return std::max(this->At(place).Value, 0.0) + this->Slope * Distance(x, place);
}

/// The middles of parallel chords of a hyperbola lie on a line, which meets it between their ends.
/// Where its asymptotes are along x and y, that line has the direction of the chord, mirrored. It
/// does so in the box of the chord; where the chord is along an axis rounding would lead out of it.
Point2 LevelLine::MiddleOf(const Point2& start, const Point2& end) const
{
  const Point2 middle = Midpoint(start, end);
  const Point2 way{ end.X - start.X, start.Y - end.Y };
  const double here = this->At(middle).Value;
  const double ahead = this->At(middle + way).Value;
  const double behind = this->At(middle - way).Value;
  const double linear = 0.5 * (ahead - behind);
  const double square = 0.5 * (ahead + behind) - here;
  const double root = std::sqrt(std::max(linear * linear - 4.0 * square * here, 0.0));
  const double divisor = linear < 0.0 ? linear - root : linear + root;
  const double step = std::abs(divisor) > 0.0 ? -2.0 * here / divisor : 0.0;
  return middle + std::min(std::max(step, -0.5), 0.5) * way;
}

/// To the line, by the shorter way along x or y: there what is bilinear is linear. Within the cell.
Point2 LevelLine::AlongAxis(const Point2& place) const
{
  const auto& [value, gradient] = this->At(place);
  const bool alongX = std::abs(gradient.X) > std::abs(gradient.Y);
  const double slope = alongX ? gradient.X : gradient.Y;
  const double step = std::abs(slope) > 0.0 ? -value / slope : 0.0;
  const Point2 moved = place + (alongX ? Point2{ step, 0.0 } : Point2{ 0.0, step });
  return { std::min(std::max(this->Cell.Low.X, moved.X), this->Cell.High.X),
    std::min(std::max(this->Cell.Low.Y, moved.Y), this->Cell.High.Y) };
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
