// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "GridLimit.h"

#include "ExtendedGrid.h"

#include <cmath> // for abs, ilogb, ldexp

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

/// Where f may grow by less than this share of the least value across a cell, its nodes are as good
/// as a line through it.
constexpr double LeastGrowth = 0.005;

/// In cells: with that distance d of a node from a line, places beyond the node are nearer to the
/// line than by way of one of the nodes there by .08 cells at most, by .3 where cells are long, so
/// that f is too high by no more than as many parts in d.
constexpr double LineReach = 20.0;

/// The least value is about 2^-90 of its unit: there is as much room below it as floats need for
/// what is normal, and above it for values 2^217 times as large. Beside what f grows to a smaller
/// one is nothing: then there is room for that.
double UnitOf(const GridSource& source, double gradation, const ValueRange& range)
{
  constexpr int Room = 90;
  constexpr double Nothing = 0x1p-100;
  const double extent =
    source.XNodes.back() - source.XNodes.front() + source.YNodes.back() - source.YNodes.front();
  const double least =
    std::max(range(*std::min_element(source.Values.begin(), source.Values.end())),
      Nothing * gradation * extent);
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
  , Unit(UnitOf(*source, gradation, range))
  , Gradation(gradation / this->Unit)
  , Range(InUnits(range, this->Unit))
  , Bounds(this->Source, this->Gradation, this->Range)
{
  Pulse pulse(monitor);
  GridSweeps sweeps(this->Source->XNodes.size(), this->Source->YNodes.size());
  if (this->FindSteepCells(sweeps, pulse))
  {
    const PulsePart part(pulse, 0.2, 0.9);
    const GridSource& grid = *this->Source;
    sweeps.Run(pulse,
      [this, &grid](std::size_t from, std::size_t to, std::size_t column, std::size_t row) {
        return this->HandOn(from, this->Nodes[to], { grid.XNodes[column], grid.YNodes[row] });
      });
    this->FindLimitedCells(pulse);
  }
  if (pulse.HasStopped())
  {
    this->Nodes.clear();
  }
}

/// Whether there are any. Their nodes hand on what is given.
bool GridLimit::FindSteepCells(GridSweeps& sweeps, Pulse& pulse)
{
  const GridSource& grid = *this->Source;
  for (std::size_t row = 0; row + 1 < grid.YNodes.size() && pulse.Beat(4 * grid.XNodes.size());
       ++row)
  {
    for (std::size_t column = 0; column + 1 < grid.XNodes.size(); ++column)
    {
      if (this->IsSteep(column, row))
      {
        this->AddSteepCell(column, row, sweeps);
      }
    }
  }
  pulse.SetFraction(0.2);
  return !this->Nodes.empty();
}

bool GridLimit::IsSteep(std::size_t column, std::size_t row) const
{
  const double* low = &this->Source->Values[this->NodeAt(column, row)];
  const double* high = &this->Source->Values[this->NodeAt(column, row + 1)];
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

void GridLimit::AddSteepCell(std::size_t column, std::size_t row, GridSweeps& sweeps)
{
  if (this->Nodes.empty())
  {
    this->SetGiven();
  }
  for (const std::size_t low : { row, row + 1 })
  {
    for (const std::size_t left : { column, column + 1 })
    {
      Node& node = this->Nodes[this->NodeAt(left, low)];
      node.Start = std::min(node.Start, node.Value);
      sweeps.Add(left, low);
    }
  }
  const double growth = this->Bounds.GrowthAt(column + 1, row + 1);
  if (growth > LeastGrowth * this->Range.Least && this->Bounds.HasLine(column, row))
  {
    this->AddLine(column, row);
  }
}

/// It bounds the corners that are above.
void GridLimit::AddLine(std::size_t column, std::size_t row)
{
  for (const std::size_t low : { row, row + 1 })
  {
    for (const std::size_t left : { column, column + 1 })
    {
      Node& node = this->Nodes[this->NodeAt(left, low)];
      const auto value = static_cast<float>(this->Bounds.FromLine(
        column, row, { this->Source->XNodes[left], this->Source->YNodes[low] }, node.Value));
      if (value < node.Value)
      {
        node = { value, static_cast<float>(this->Range.Least), { column, row, Kind::LineOfCell } };
      }
    }
  }
}

void GridLimit::SetGiven()
{
  this->Nodes.reserve(this->Source->Values.size());
  for (std::size_t row = 0; row < this->Source->YNodes.size(); ++row)
  {
    for (std::size_t column = 0; column < this->Source->XNodes.size(); ++column)
    {
      this->Nodes.push_back(this->Bounds.Itself(column, row));
      this->Nodes.back().Start = std::numeric_limits<float>::infinity();
    }
  }
}

/// Hands on what bounds one node to another one. What is as given bounds others only from steep
/// cells.
bool GridLimit::HandOn(std::size_t from, Node& node, const Point2& place) const
{
  const Node& other = this->Nodes[from];
  if (other.From == node.From || !(other.Start < node.Value))
  {
    return false;
  }
  Node source = other;
  if (other.From.IsLine())
  {
    const std::size_t columns = this->Source->XNodes.size();
    const Origin itself(from % columns, from / columns, Kind::Node);
    source = this->IsFarFromLine(other, itself) ? Node{ other.Value, other.Value, itself } : other;
  }
  const auto value = static_cast<float>(this->Bounds.From(source, place, node.Value));
  const bool isLower = value < node.Value;
  if (isLower)
  {
    node.Value = value;
    node.Start = source.Start;
    node.From = source.From;
  }
  return isLower;
}

/// Lines take ten times as long as nodes: from afar f grows from the nodes that they bound.
bool GridLimit::IsFarFromLine(const Node& node, const Origin& itself) const
{
  const double growth = std::max(this->Bounds.GrowthAt(node.From.Column() + 1, node.From.Row() + 1),
    this->Bounds.GrowthAt(itself.Column(), itself.Row()));
  return node.Value - this->Range.Least > LineReach * growth;
}

/// What grows from within a steep cell reaches those beside it.
void GridLimit::FindLimitedCells(Pulse& pulse)
{
  this->IsLimited.assign(this->Nodes.size(), false);
  const std::size_t columns = this->Source->XNodes.size();
  for (std::size_t cell = 0; cell + columns + 1 < this->Nodes.size() && pulse.Beat(1); ++cell)
  {
    const Node* low = &this->Nodes[cell];
    const Node* high = low + columns;
    this->IsLimited[cell] = std::min({ low[0].Start, low[1].Start, high[0].Start, high[1].Start }) <
      std::numeric_limits<float>::infinity();
  }
}

double GridLimit::operator()(const Point2& x) const
{
  const GridInterpolator::Place place = this->Given.Find(x);
  const double given = this->Range(this->Given.At(place));
  const std::size_t cell = this->NodeAt(place.Column, place.Row);
  if (!this->IsLimited[cell])
  {
    return this->Unit * given;
  }
  const Node* low = &this->Nodes[cell];
  const Node* high = low + this->Source->XNodes.size();
  const float least = std::min({ low[0].Value, low[1].Value, high[0].Value, high[1].Value });
  const double growth = this->Bounds.GrowthAt(place.Column + 1, place.Row + 1);
  if (growth > WidestGrowth * least)
  {
    return this->Unit * this->ValueInWideCell(x, place, given);
  }
  return this->Unit *
    std::min(given,
      Blend(Blend(low[0].Value, low[1].Value, place.X),
        Blend(high[0].Value, high[1].Value, place.X), place.Y));
}

/// By what bounds its corners, first, and the nodes around them: what grows from beyond may pass
/// between the corners.
double GridLimit::ValueInWideCell(
  const Point2& x, const GridInterpolator::Place& place, double given) const
{
  LookedAt<std::uint64_t> looked;
  double least = given;
  this->BoundByLine(place.Column, place.Row, x, looked, least);
  for (const std::size_t around : { 0u, 1u })
  {
    const std::size_t left = place.Column > around ? place.Column - around : 0;
    const std::size_t right = std::min(place.Column + 2 + around, this->Source->XNodes.size());
    const std::size_t below = place.Row > around ? place.Row - around : 0;
    const std::size_t above = std::min(place.Row + 2 + around, this->Source->YNodes.size());
    for (std::size_t row = below; row < above; ++row)
    {
      for (std::size_t column = left; column < right; ++column)
      {
        Node node = this->Nodes[this->NodeAt(column, row)];
        if (node.Start < least && node.From.IsLine())
        {
          this->BoundByLines(node.From, x, looked, least);
        }
        else if (node.Start < least && looked.Add(node.From.Key()))
        {
          least = std::min(least, this->Bounds.From(node, x, least));
        }
      }
    }
  }
  return least;
}

/// The lines of neighboring cells, too, are parts of one: nodes at their common end have one of
/// them.
void GridLimit::BoundByLines(
  const Origin& from, const Point2& x, LookedAt<std::uint64_t>& looked, double& least) const
{
  const std::size_t column = from.Column();
  const std::size_t row = from.Row();
  this->BoundByLine(column, row, x, looked, least);
  this->BoundByLine(column > 0 ? column - 1 : column, row, x, looked, least);
  this->BoundByLine(column + 1, row, x, looked, least);
  this->BoundByLine(column, row > 0 ? row - 1 : row, x, looked, least);
  this->BoundByLine(column, row + 1, x, looked, least);
}

/// If there is such a cell, and it has a line.
void GridLimit::BoundByLine(std::size_t column, std::size_t row, const Point2& x,
  LookedAt<std::uint64_t>& looked, double& least) const
{
  if (column + 1 < this->Source->XNodes.size() && row + 1 < this->Source->YNodes.size() &&
    this->Bounds.HasLine(column, row) && looked.Add(Origin(column, row, Kind::LineOfCell).Key()))
  {
    least = std::min(least, this->Bounds.FromLine(column, row, x, least));
  }
}

} // namespace biting
