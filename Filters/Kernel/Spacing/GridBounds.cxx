// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "GridBounds.h"

#include "GridInterpolator.h"
#include "LevelLine.h"

#include <cmath> // for abs

namespace biting
{
namespace
{

/// A cell is about linear where its twist adds no more than this share of f to that.
constexpr double LeastTwist = 0.005;

/// To the place in a cell that bounds most.
constexpr int StepsWithin = 3;

} // namespace

GridBounds::GridBounds(
  std::shared_ptr<const GridSource> source, double gradation, const ValueRange& range)
  : Source(std::move(source))
  , Gradation(gradation)
  , Range(range)
  , Edge(range, gradation)
{
}

double GridBounds::FromSides(
  std::size_t column, std::size_t row, const Point2& x, double limit) const
{
  limit = column > 0 ? this->FromRow(column - 1, row, x, limit) : limit;
  limit = column + 1 < this->Source->XNodes.size() ? this->FromRow(column, row, x, limit) : limit;
  limit = row > 0 ? this->FromColumn(column, row - 1, x, limit) : limit;
  return row + 1 < this->Source->YNodes.size() ? this->FromColumn(column, row, x, limit) : limit;
}

double GridBounds::FromRow(std::size_t column, std::size_t row, const Point2& x, double limit) const
{
  const double* ends = &this->Source->Values[this->NodeAt(column, row)];
  const double start = this->Source->XNodes[column];
  return this->FromSide(x.X - start, x.Y - this->Source->YNodes[row],
    this->Source->XNodes[column + 1] - start, ends[0], ends[1], limit);
}

double GridBounds::FromColumn(
  std::size_t column, std::size_t row, const Point2& x, double limit) const
{
  const double* ends = &this->Source->Values[this->NodeAt(column, row)];
  const double start = this->Source->YNodes[row];
  return this->FromSide(x.Y - start, x.X - this->Source->XNodes[column],
    this->Source->YNodes[row + 1] - start, ends[0], ends[this->Source->XNodes.size()], limit);
}

/// One that is as steep as f may be is bounded by its lower end.
inline double GridBounds::FromSide(
  double along, double across, double length, double start, double end, double limit) const
{
  const double rise = this->Range.Scale * std::abs(end - start);
  const double low = this->Range.Scale * std::min(start, end);
  if (!(rise < this->Gradation * length) && low >= this->Range.Least)
  {
    return limit;
  }
  const double room = limit - this->Range(std::min(start, end));
  const bool isNear = room > 0.0 && length > 0.0 &&
    this->IsNear({ std::max({ -along, along - length, 0.0 }), across }, room);
  return isNear ? std::min(limit, this->Edge(along, across, length, start, end)) : limit;
}

/// Goes to the place that bounds most along one line of the cell, then along the line across it
/// there, and so on: what is bilinear is linear along both.
double GridBounds::FromWithin(
  std::size_t column, std::size_t row, const Point2& x, double limit) const
{
  const double* low = &this->Source->Values[this->NodeAt(column, row)];
  const double* high = low + this->Source->XNodes.size();
  const double twist = this->Range.Scale * std::abs((low[0] - low[1]) + (high[1] - high[0]));
  const double room = limit - this->Range(std::min({ low[0], low[1], high[0], high[1] }));
  const Point2 start{ this->Source->XNodes[column], this->Source->YNodes[row] };
  const Point2 size =
    Point2{ this->Source->XNodes[column + 1], this->Source->YNodes[row + 1] } - start;
  if (!(0.25 * twist > LeastTwist * limit && room > 0.0 && size.X * size.Y > 0.0) ||
    !this->IsNear(this->AwayFrom(column, row, x), room))
  {
    return limit;
  }
  const Point2 offset = x - start;
  Point2 foot = 0.5 * size;
  for (int step = 0; step < StepsWithin; ++step)
  {
    const double up = foot.Y / size.Y;
    foot.X = this->FootOn(
      offset.X, offset.Y - foot.Y, size.X, Blend(low[0], high[0], up), Blend(low[1], high[1], up));
    const double right = foot.X / size.X;
    foot.Y = this->FootOn(offset.Y, offset.X - foot.X, size.Y, Blend(low[0], low[1], right),
      Blend(high[0], high[1], right));
  }
  const double right = foot.X / size.X;
  const double given =
    Blend(Blend(low[0], low[1], right), Blend(high[0], high[1], right), foot.Y / size.Y);
  return std::min(limit, this->Range(given) + this->Gradation * Distance(offset, foot));
}

/// Where on a line values that are linear along it bound most.
double GridBounds::FootOn(
  double along, double across, double length, double start, double end) const
{
  const SegmentCone cone({ 0.0, 0.0 }, { length, 0.0 }, this->Range.Scale * start,
    this->Range.Scale * end, this->Gradation);
  return std::min(std::max(along - cone.From({ along, across }).Away.X, 0.0), length);
}

/// The way from the cell above a node to x, along both axes.
Point2 GridBounds::AwayFrom(std::size_t column, std::size_t row, const Point2& x) const
{
  const std::vector<double>& columns = this->Source->XNodes;
  const std::vector<double>& rows = this->Source->YNodes;
  return { std::max({ columns[column] - x.X, x.X - columns[column + 1], 0.0 }),
    std::max({ rows[row] - x.Y, x.Y - rows[row + 1], 0.0 }) };
}

bool GridBounds::IsNear(const Point2& away, double room) const
{
  return this->Gradation * this->Gradation * Dot(away, away) < room * room;
}

bool GridBounds::HasLine(std::size_t column, std::size_t row) const
{
  const double* low = &this->Source->Values[this->NodeAt(column, row)];
  const double* high = low + this->Source->XNodes.size();
  const auto [least, most] = std::minmax({ low[0], low[1], high[0], high[1] });
  return this->Range.Scale * least < this->Range.Least &&
    this->Range.Least < this->Range.Scale * most;
}

double GridBounds::FromLine(
  std::size_t column, std::size_t row, const Point2& x, double limit) const
{
  if (!this->HasLine(column, row) || !(limit > this->Range.Least) ||
    !this->IsNear(this->AwayFrom(column, row, x), limit - this->Range.Least))
  {
    return limit;
  }
  const double* low = &this->Source->Values[this->NodeAt(column, row)];
  const std::vector<double>& columns = this->Source->XNodes;
  const std::vector<double>& rows = this->Source->YNodes;
  const double* high = low + columns.size();
  const auto above = [this](double value)
  { return std::min(this->Range.Scale * value, GreatestValue) - this->Range.Least; };
  const LevelLine line({ { columns[column], rows[row] }, { columns[column + 1], rows[row + 1] } },
    { above(low[0]), above(low[1]), above(high[1]), above(high[0]) }, this->Gradation);
  return std::min(limit, this->Range.Least + line.Bound(x));
}

} // namespace biting
