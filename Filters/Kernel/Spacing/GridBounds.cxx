// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "GridBounds.h"

#include "LevelLine.h"

#include <cmath> // for abs, sqrt

namespace biting
{
namespace
{

/// A side of width w lets f be lower than its ends do by g w^2 / (8 d) at most, at a distance d of
/// a cell or more: its nearer end is at most w / 2 from the foot. That is not looked at where it is
/// below this share of f at the side, and below a share of what f grows by, 1 / (8 * 6^2), that is
/// less than the SteepnessMargin: else what is a little steeper in a direction between those of
/// nodes would not be bounded.
constexpr double SideShare = 0.009;
constexpr double SideReach = 6.0;

/// Of what f may fall by along a side. With a slope of s g, f is lower than the lower end allows by
/// (1 - s^2)^1.5 g w^2 / (2 d) at most, which is less than half of what level sides make.
constexpr double SteepestFall = 0.7;

/// A point of a level side at w from the node makes f lower by g w^2 / (d + h) at a distance d from
/// the node and h from the side, which is less than this share of g w^2 / d where h is above d / 3.
/// Nearer to a side its ends are other nodes.
constexpr double ShareOfSides = 0.75;

/// What a side lowers f by less than to this share of it is not looked at.
constexpr double LeastChange = 0.999;

/// How much f may grow across the wider one of the cells beside each node.
std::vector<double> GrowthBeside(const std::vector<double>& nodes, double gradation)
{
  std::vector<double> growth(nodes.size(), 0.0);
  for (std::size_t node = 1; node < nodes.size(); ++node)
  {
    growth[node] = gradation * (nodes[node] - nodes[node - 1]);
    growth[node - 1] = std::max(growth[node - 1], growth[node]);
  }
  return growth;
}

} // namespace

GridBounds::GridBounds(
  std::shared_ptr<const GridSource> source, double gradation, const ValueRange& range)
  : Source(std::move(source))
  , Gradation(gradation)
  , SquaredGradation(gradation * gradation)
  , Range(range)
  , Edge(range, gradation)
  , ColumnGrowth(GrowthBeside(this->Source->XNodes, gradation))
  , RowGrowth(GrowthBeside(this->Source->YNodes, gradation))
{
}

/// Whether what is given reaches the least value within a cell.
bool GridBounds::HasLine(std::size_t column, std::size_t row) const
{
  const double* low = &this->Source->Values[this->NodeAt(column, row)];
  const double* high = &this->Source->Values[this->NodeAt(column, row + 1)];
  const auto [least, most] = std::minmax({ low[0], low[1], high[0], high[1] });
  return this->Range.Scale * least < this->Range.Least &&
    this->Range.Least < this->Range.Scale * most;
}

/// How far it is to the nearest point of a cell, along x and along y.
Point2 GridBounds::ToCell(std::size_t column, std::size_t row, const Point2& x) const
{
  const std::vector<double>& columns = this->Source->XNodes;
  const std::vector<double>& rows = this->Source->YNodes;
  return { std::max({ columns[column] - x.X, x.X - columns[column + 1], 0.0 }),
    std::max({ rows[row] - x.Y, x.Y - rows[row + 1], 0.0 }) };
}

/// The line along which what is given reaches the least value.
double GridBounds::FromLine(
  std::size_t column, std::size_t row, const Point2& x, double limit) const
{
  const double room = limit - this->Range.Least;
  const Point2 away = this->ToCell(column, row, x);
  if (!(this->SquaredGradation * Dot(away, away) < room * room))
  {
    return limit;
  }
  const std::vector<double>& columns = this->Source->XNodes;
  const std::vector<double>& rows = this->Source->YNodes;
  const double* low = &this->Source->Values[this->NodeAt(column, row)];
  const double* high = &this->Source->Values[this->NodeAt(column, row + 1)];
  const auto above = [this](double value)
  { return std::min(this->Range.Scale * value, GreatestValue) - this->Range.Least; };
  const LevelLine line({ { columns[column], rows[row] }, { columns[column + 1], rows[row + 1] } },
    { above(low[0]), above(low[1]), above(high[1]), above(high[0]) }, this->Gradation);
  return this->Range.Least + line.Bound(x);
}

/// What the sides around the node that bounds `source` allow at x; where that is not below `limit`,
/// it may be any value that is not. The source becomes the end of these sides that is nearest to
/// what bounds x.
double GridBounds::From(Node& source, const Point2& x, double limit) const
{
  if (source.From.IsLine())
  {
    return this->FromLine(source.From.Column(), source.From.Row(), x, limit);
  }
  const Point2 offset = x - this->PlaceOf(source.From);
  const double squared = this->SquaredGradation * Dot(offset, offset);
  const double start = source.Start;
  const double width =
    std::max(this->ColumnGrowth[source.From.Column()], this->RowGrowth[source.From.Row()]);
  const double most = width * width / (8.0 * SideShare);
  const bool hasSides = source.From.HasSides() &&
    (squared < SideReach * SideReach * width * width || start * start * squared < most * most);
  const double room = limit - start + (hasSides ? width : 0.0);
  if (!(squared < room * room))
  {
    return limit;
  }
  const double grown = std::sqrt(squared);
  const bool mayBeLower =
    hasSides && (start + grown - LeastChange * limit) * grown < ShareOfSides * width * width;
  return mayBeLower ? this->FromSides(source, x, start + grown) : start + grown;
}

/// A side bounds by more than its node only where values along it, seen from the node, rise less
/// than the place comes nearer.
double GridBounds::FromSides(Node& source, const Point2& x, double own) const
{
  const double start = this->GivenAt(source.From.Column(), source.From.Row());
  const double grown = own - static_cast<double>(source.Start);
  const Point2 offset = x - this->PlaceOf(source.From);
  double bound = own;
  Side best{};
  for (const Side& side : this->SidesOf(source.From.Column(), source.From.Row()))
  {
    const Point2 toEnd{ side.Width, side.Height };
    const double rise = this->Rise(start, side);
    const bool mayBeLower = rise * grown < this->SquaredGradation * Dot(offset, toEnd);
    if (mayBeLower && this->IsGentle(rise, side) && !this->IsFalling(rise, side))
    {
      const double length = std::abs(side.Width + side.Height);
      const double found = this->Edge(Dot(offset, toEnd) / length, Cross(offset, toEnd) / length,
        length, start, this->GivenAt(side.Column, side.Row));
      best = found < bound ? side : best;
      bound = std::min(bound, found);
    }
  }
  const Point2 fromEnd = offset - Point2{ best.Width, best.Height };
  if (bound < own &&
    this->Range(this->GivenAt(best.Column, best.Row)) + this->Gradation * Length(fromEnd) < own)
  {
    source = this->Itself(best.Column, best.Row);
  }
  return bound;
}

std::array<GridBounds::Side, 4> GridBounds::SidesOf(std::size_t column, std::size_t row) const
{
  const std::vector<double>& x = this->Source->XNodes;
  const std::vector<double>& y = this->Source->YNodes;
  const std::size_t left = column > 0 ? column - 1 : column;
  const std::size_t right = column + 1 < x.size() ? column + 1 : column;
  const std::size_t below = row > 0 ? row - 1 : row;
  const std::size_t above = row + 1 < y.size() ? row + 1 : row;
  return { { { left, row, x[left] - x[column], 0.0 }, { right, row, x[right] - x[column], 0.0 },
    { column, below, 0.0, y[below] - y[row] }, { column, above, 0.0, y[above] - y[row] } } };
}

/// Along a side from its start.
double GridBounds::Rise(double start, const Side& side) const
{
  return this->Range.Scale * (this->GivenAt(side.Column, side.Row) - start);
}

/// One that is steeper is bounded by its lower end.
bool GridBounds::IsGentle(double rise, const Side& side) const
{
  return std::abs(rise) < this->Gradation * std::abs(side.Width + side.Height);
}

/// Then its lower end, which is another node, is about as good.
bool GridBounds::IsFalling(double rise, const Side& side) const
{
  return rise < -SteepestFall * this->Gradation * std::abs(side.Width + side.Height);
}

/// As IsGentle says of its sides, without these: each node is asked once.
bool GridBounds::HasGentleSides(std::size_t column, std::size_t row) const
{
  const std::vector<double>& x = this->Source->XNodes;
  const std::vector<double>& y = this->Source->YNodes;
  const double* value = &this->Source->Values[this->NodeAt(column, row)];
  const auto isGentle = [this, value](const double* end, double length)
  { return this->Range.Scale * std::abs(*end - *value) < this->Gradation * length; };
  return (column > 0 && isGentle(value - 1, x[column] - x[column - 1])) ||
    (column + 1 < x.size() && isGentle(value + 1, x[column + 1] - x[column])) ||
    (row > 0 && isGentle(value - x.size(), y[row] - y[row - 1])) ||
    (row + 1 < y.size() && isGentle(value + x.size(), y[row + 1] - y[row]));
}

} // namespace biting
