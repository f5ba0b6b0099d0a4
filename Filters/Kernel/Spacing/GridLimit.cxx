// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "GridLimit.h"

#include "../Base/Numbers.h"
#include "../Base/Tasks.h"
#include "ExtendedGrid.h"
#include "GridPasses.h"
#include "Plateaus.h"

#include <algorithm> // for find, min_element
#include <array>     // for distances
#include <cmath>     // for abs, ilogb, ldexp, sqrt

namespace biting
{
namespace
{

/// A cell is steep where its mean gradient or one of its sides is above the gradation by more than
/// this share of it, or where its twist adds more than this share of f to what is linear. Otherwise
/// a field that somebody has limited already would be limited again, cell by cell: the gradient at
/// a corner of a cell of a distance function exceeds that of the function itself.
constexpr double SteepnessMargin = 0.005;

/// Cells across which f may grow by more than this share of itself are wide: between nodes around
/// one that f grows from, linear values are too high by up to .15 of that.
constexpr double WidestGrowth = 0.09;

/// In wide cells whatever f grows from is looked at within so many of their larger extent around a
/// point: what f is, in multiples of what it may grow by across a cell, times the reach is this,
/// within limits. From beyond, f grows by way of a node there; with half a cell beside the straight
/// way and r cells off, the detour is 1 / (8 r) cells at most. By as much f may be too high, and no
/// more than that is taken off where values between nodes are lower: on a ridge they are so by half
/// a cell.
constexpr double LeastReach = 1.0;
constexpr double LargestReach = 4.0;
constexpr double ReachTimesMultiple = 16.0;

/// But no more columns or rows than that on either side: where there are more, cells are long, here
/// or beside, and LongCells knows what is along them.
constexpr std::size_t MostNearby = 16;

/// Across the short sides of long cells f grows by less than this share of itself, so that what is
/// beside these cells, or between their short sides, does not count: of the latter, lines of the
/// least value are more than nodes tell.
constexpr double NarrowestGrowth = 0.01;
constexpr double NarrowestWithLines = 0.005;

/// Nodes that are lowered less than to this share are as given.
constexpr float LeastChange = 0.999f;

/// Within reach of a place in a cell, and the ends of that.
GridLimit::Nearby Around(
  const std::vector<double>& nodes, std::size_t cell, double place, double reach)
{
  std::size_t first = cell;
  while (first > 0 && cell - first < MostNearby && place - nodes[first - 1] < reach)
  {
    --first;
  }
  std::size_t last = cell + 1;
  while (last + 1 < nodes.size() && last - cell <= MostNearby && nodes[last + 1] - place < reach)
  {
    ++last;
  }
  return { first, last, cell - first == MostNearby || last - cell > MostNearby };
}

/// The least value is about 2^-30 of its unit: there is room below it for what floats add to it,
/// squared, and above it for the square of what f grows to. Beside that a least value that is
/// smaller still is nothing: then there is room for that.
double UnitOf(const GridSource& source, double gradation, double leastValue)
{
  constexpr int Room = 30;
  constexpr double Nothing = 0x1p-80;
  const double extent =
    source.XNodes.back() - source.XNodes.front() + source.YNodes.back() - source.YNodes.front();
  const double least = std::max(leastValue, Nothing * gradation * extent);
  return std::ldexp(
    1.0, std::min(std::ilogb(least) + Room, std::numeric_limits<double>::max_exponent - 1));
}

/// Of what floats can be.
ValueRange InUnits(const ValueRange& range, double unit)
{
  constexpr double greatest = std::numeric_limits<float>::max();
  return { range.Scale / unit, range.Least / unit, std::min(range.Most / unit, greatest) };
}

} // namespace

GridLimit::GridLimit(const std::shared_ptr<const GridSource>& source, double gradation,
  const Box2& bounds, const ValueRange& range, Monitor& monitor)
  : Source(ExtendedGrid(source, bounds))
  , Given(this->Source)
  , Least(*std::min_element(this->Source->Values.begin(), this->Source->Values.end()))
  , Unit(UnitOf(*this->Source, gradation, range(this->Least)))
  , Gradation(gradation / this->Unit)
  , Range(InUnits(range, this->Unit))
  , Bounds(this->Source, this->Gradation, this->Range)
  , HasLines(range.Scale * this->Least < range.Least)
{
  Pulse pulse(monitor);
  const Marks steep = this->FindSteepCells(pulse);
  if (!steep.empty())
  {
    Marks changed = this->SetValues(steep, pulse);
    if (this->HasLines)
    {
      LowerBesidePlateaus(*this->Source, this->Range, this->Gradation, this->Values, pulse);
    }
    const PulsePart part(pulse, 0.2, 0.9);
    if (RunGridPasses(
          this->Source->XNodes, this->Source->YNodes, this->Gradation, this->Values, pulse))
    {
      this->FindLimitedCells(changed, pulse);
      this->Long.emplace(*this->Source, this->Range, this->Gradation, this->Bounds, this->Values);
    }
  }
  if (pulse.HasStopped())
  {
    this->Values.clear();
  }
}

/// By the node above and right of each, with as many more as the corners of a cell are apart; none
/// where no cell is steep.
GridLimit::Marks GridLimit::FindSteepCells(Pulse& pulse) const
{
  const PulsePart part(pulse, 0.0, 0.15);
  const std::size_t columns = this->Source->XNodes.size();
  const std::size_t rows = this->Source->YNodes.size() - 1;
  Marks steep(this->Source->Values.size() + columns + 1, 0);
  Marks areIn(rows, 0);
  ForRowsAtOnce(pulse, rows, columns,
    [&](std::size_t firstRow, std::size_t lastRow)
    {
      for (std::size_t row = firstRow; row < lastRow; ++row)
      {
        for (std::size_t column = 0; column + 1 < columns; ++column)
        {
          if (this->IsSteep(column, row))
          {
            steep[this->Bounds.NodeAt(column + 1, row + 1)] = 1;
            areIn[row] = 1;
          }
        }
      }
    });
  const bool areAny = std::find(areIn.begin(), areIn.end(), 1) != areIn.end();
  return areAny ? steep : Marks();
}

bool GridLimit::IsSteep(std::size_t column, std::size_t row) const
{
  const double* low = &this->Source->Values[this->Bounds.NodeAt(column, row)];
  const double* high = &this->Source->Values[this->Bounds.NodeAt(column, row + 1)];
  const double least = this->Range.Scale * std::min({ low[0], low[1], high[0], high[1] });
  const double greatest = this->Range.Scale * std::max({ low[0], low[1], high[0], high[1] });
  if (!(greatest > this->Range.Least && least < this->Range.Most))
  {
    return false;
  }
  // f is clamped between corners, not at them: until there it is as steep as what is given.
  const double a = std::min(this->Range.Scale * low[0], GridBounds::GreatestValue);
  const double b = std::min(this->Range.Scale * low[1], GridBounds::GreatestValue);
  const double c = std::min(this->Range.Scale * high[0], GridBounds::GreatestValue);
  const double d = std::min(this->Range.Scale * high[1], GridBounds::GreatestValue);
  const double width = this->Source->XNodes[column + 1] - this->Source->XNodes[column];
  const double height = this->Source->YNodes[row + 1] - this->Source->YNodes[row];
  const double most = (1.0 + SteepnessMargin) * this->Gradation;
  const double both = most * width * height;
  const double alongX = std::max(std::abs(b - a), std::abs(d - c));
  const double alongY = std::max(std::abs(c - a), std::abs(d - b));
  if (!(both > 0.0))
  {
    return alongX > most * width || alongY > most * height;
  }
  const auto isAbove = [both, width, height](double riseX, double riseY)
  {
    const Point2 slope{ riseX * height, riseY * width };
    return Dot(slope, slope) > both * both;
  };
  if (!isAbove(alongX, alongY))
  {
    return false;
  }
  const double added = 0.25 * std::abs(a - b - c + d);
  return isAbove(0.5 * (b - a + d - c), 0.5 * (c - a + d - b)) || isAbove(alongX, 0.0) ||
    isAbove(0.0, alongY) || added > SteepnessMargin * std::max(least, this->Range.Least);
}

inline float GridLimit::GivenAt(std::size_t node) const
{
  return static_cast<float>(this->Range(this->Source->Values[node]));
}

/// The nodes that steep cells have.
GridLimit::Marks GridLimit::SetValues(const Marks& steep, Pulse& pulse)
{
  const PulsePart part(pulse, 0.15, 0.2);
  const std::size_t columns = this->Source->XNodes.size();
  this->Values.resize(this->Source->Values.size());
  Marks areCorners(this->Values.size(), 0);
  ForEachAtOnce(pulse, this->Values.size(),
    [this, &steep, &areCorners, columns](std::size_t node)
    {
      this->Values[node] = this->GivenAt(node);
      areCorners[node] = static_cast<char>(
        steep[node] | steep[node + 1] | steep[node + columns] | steep[node + columns + 1]);
      if (this->HasLines && areCorners[node] != 0)
      {
        this->LowerToLines(steep, node);
      }
    });
  return areCorners;
}

/// The line within a steep cell bounds its corners that are above.
void GridLimit::LowerToLines(const Marks& steep, std::size_t node)
{
  const GridSource& grid = *this->Source;
  const std::size_t columns = grid.XNodes.size();
  const Point2 place{ grid.XNodes[node % columns], grid.YNodes[node / columns] };
  for (const std::size_t high : { node, node + 1, node + columns, node + columns + 1 })
  {
    if (steep[high] != 0)
    {
      this->Values[node] = static_cast<float>(
        this->Bounds.FromLine(high % columns - 1, high / columns - 1, place, this->Values[node]));
    }
  }
}

/// Those with a corner that is lowered, or that a steep cell has: what grows from within that
/// reaches the cells beside it.
void GridLimit::FindLimitedCells(Marks& changed, Pulse& pulse)
{
  static_assert(StepsPerTask % 64 == 0, "no two tasks may write bits of one word");
  ForEachAtOnce(pulse, changed.size(),
    [this, &changed](std::size_t node)
    { changed[node] |= this->Values[node] < LeastChange * this->GivenAt(node); });
  const std::size_t columns = this->Source->XNodes.size();
  const std::size_t cells = changed.size() - columns - 1;
  this->IsLimited.assign(changed.size(), false);
  ForEachAtOnce(pulse, cells,
    [this, &changed, columns](std::size_t cell)
    {
      this->IsLimited[cell] = (changed[cell] | changed[cell + 1] | changed[cell + columns] |
                                changed[cell + columns + 1]) != 0;
    });
}

double GridLimit::operator()(const Point2& x) const
{
  const GridInterpolator::Place place = this->Given.Find(x);
  const double given = this->Range(this->Given.At(place));
  const std::size_t cell = this->Bounds.NodeAt(place.Column, place.Row);
  if (!this->IsLimited[cell])
  {
    return this->Unit * given;
  }
  const GridSource& grid = *this->Source;
  const auto [narrow, size] =
    std::minmax({ grid.XNodes[place.Column + 1] - grid.XNodes[place.Column],
      grid.YNodes[place.Row + 1] - grid.YNodes[place.Row] });
  const float* low = &this->Values[cell];
  const float* high = low + grid.XNodes.size();
  const double least = std::min({ low[0], low[1], high[0], high[1] });
  const double interpolated =
    Blend(Blend(low[0], low[1], place.X), Blend(high[0], high[1], place.X), place.Y);
  if (this->Gradation * size <= WidestGrowth * least)
  {
    return this->Unit * std::min(given, interpolated);
  }
  const double multiple = least / (this->Gradation * size);
  const double reach = std::min(std::max(LeastReach, ReachTimesMultiple / multiple), LargestReach);
  const Nearby columns = Around(grid.XNodes, place.Column, x.X, reach * size);
  const Nearby rows = Around(grid.YNodes, place.Row, x.Y, reach * size);
  double near = rows.AreCut ? this->Long->BoundAlongY(place, x, reach * size, given) : given;
  near = columns.AreCut ? this->Long->BoundAlongX(place, x, reach * size, near) : near;
  const double narrowest = this->HasLines ? NarrowestWithLines : NarrowestGrowth;
  if (!(rows.AreCut || columns.AreCut) || this->Gradation * narrow > narrowest * near)
  {
    near = this->FromNearby(columns, rows, x, this->Gradation * size, near);
    near = this->FromCellsAround(place, x, near);
  }
  const double detour = multiple > reach ? this->Gradation * size / (8.0 * reach) : 0.0;
  return this->Unit * std::min(near, std::max(interpolated, near - detour));
}

/// From within the cell of a place, the nearest one beside it along x, along y, and that between.
double GridLimit::FromCellsAround(
  const GridInterpolator::Place& place, const Point2& x, double limit) const
{
  const std::size_t columns = this->Source->XNodes.size() - 1;
  const std::size_t rows = this->Source->YNodes.size() - 1;
  const std::size_t firstColumn = place.Column - (place.X < 0.5 && place.Column > 0 ? 1 : 0);
  const std::size_t firstRow = place.Row - (place.Y < 0.5 && place.Row > 0 ? 1 : 0);
  for (std::size_t row = firstRow; row < std::min(firstRow + 2, rows); ++row)
  {
    for (std::size_t column = firstColumn; column < std::min(firstColumn + 2, columns); ++column)
    {
      limit = this->Bounds.FromWithin(column, row, x, limit);
    }
  }
  return limit;
}

/// From nodes, sides and lines. What f grows by across a cell is `growth`.
/// At a distance d from the nearer one of its ends, a side of width w allows less than these by
/// g w^2 / (4 d) at most.
double GridLimit::FromNearby(
  const Nearby& columns, const Nearby& rows, const Point2& x, double growth, double limit) const
{
  constexpr std::size_t Most = 2 * MostNearby + 2;
  std::array<float, Most> squares; // of what f grows by on the way to columns
  std::array<float, Most * Most> growths;
  for (std::size_t column = columns.First; column <= columns.Last; ++column)
  {
    const double across = this->Gradation * (this->Source->XNodes[column] - x.X);
    squares[column - columns.First] = static_cast<float>(across * across);
  }
  auto least = static_cast<float>(limit);
  for (std::size_t row = rows.First; row <= rows.Last; ++row)
  {
    const double up = this->Gradation * (this->Source->YNodes[row] - x.Y);
    const auto square = static_cast<float>(up * up);
    const float* values = &this->Values[this->Bounds.NodeAt(columns.First, row)];
    float* growthOf = &growths[(row - rows.First) * Most];
    for (std::size_t k = 0; k <= columns.Last - columns.First; ++k)
    {
      growthOf[k] = std::sqrt(square + squares[k]);
      least = std::min(least, values[k] + growthOf[k]);
    }
  }
  limit = std::min(limit, static_cast<double>(least));
  const auto lower = static_cast<float>(0.25 * growth * growth);
  for (std::size_t row = rows.First; row <= rows.Last; ++row)
  {
    for (std::size_t column = columns.First; column <= columns.Last; ++column)
    {
      const float grown = growths[(row - rows.First) * Most + column - columns.First];
      if ((this->Values[this->Bounds.NodeAt(column, row)] + grown - least) * grown < lower)
      {
        limit = this->Bounds.FromSides(column, row, x, limit);
      }
      if (this->HasLines && column < columns.Last && row < rows.Last)
      {
        limit = this->Bounds.FromLine(column, row, x, limit);
      }
    }
  }
  return limit;
}

} // namespace biting
