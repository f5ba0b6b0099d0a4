// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "GridLimit.h"

#include "ExtendedGrid.h"
#include "SourceSlopes.h"

#include <cmath> // for abs, sqrt

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

/// What is bounded by less than this share of itself is left as given.
constexpr double SlightShare = 0.003;

/// A side of width w lets f be lower than its ends do by g w^2 / (8 d) at most, at a distance d of a
/// cell or more: its nearer end is at most w / 2 from the foot. That is not looked at where it is
/// below this share of f at the side, and below a share of what f grows by, 1 / (8 * 6^2), that is less than the
/// SteepnessMargin: else what is a little steeper in a direction between those of nodes would not be
/// bounded.
constexpr double SideShare = 0.009;
constexpr double SideReach = 6.0;

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

GridLimit::GridLimit(const std::shared_ptr<const GridSource>& source, double gradation,
  const Box2& bounds, const ValueRange& range, Monitor& monitor)
  : Source(ExtendedGrid(source, bounds))
  , Given(this->Source)
  , Gradation(gradation)
  , Range(range)
  , Bound(range, gradation)
  , ColumnGrowth(GrowthBeside(this->Source->XNodes, gradation))
  , RowGrowth(GrowthBeside(this->Source->YNodes, gradation))
  , SquaredGradation(gradation * gradation)
{
  Pulse pulse(monitor);
  GridSweeps sweeps(this->Source->XNodes.size(), this->Source->YNodes.size());
  if (this->FindSteepCells(sweeps, pulse))
  {
    const PulsePart part(pulse, 0.2, 0.9);
    const GridSource& grid = *this->Source;
    sweeps.Run(pulse,
      [this, &grid](std::size_t from, std::size_t to, std::size_t column, std::size_t row)
      {
        return this->HandOn(
          this->Nodes[from], this->Nodes[to], { grid.XNodes[column], grid.YNodes[row] });
      });
    this->ClassifyCells(sweeps, pulse);
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
  GridSlopes slopes(grid);
  const double most = this->Gradation / this->Range.Scale;
  for (std::size_t row = 0; row + 1 < grid.YNodes.size() && pulse.Beat(4 * grid.XNodes.size());
       ++row)
  {
    const std::vector<double>& squares = slopes.SquaresOfRow(row);
    const bool hasHeight = grid.YNodes[row] < grid.YNodes[row + 1];
    for (std::size_t column = 0; column + 1 < grid.XNodes.size(); ++column)
    {
      const bool mayBe = squares[column] > most * most || !hasHeight ||
        !(grid.XNodes[column] < grid.XNodes[column + 1]);
      if (mayBe && this->IsSteep(column, row))
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
  const double a = this->Range(low[0]);
  const double b = this->Range(low[1]);
  const double c = this->Range(high[0]);
  const double d = this->Range(high[1]);
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
    isAbove(0.0, alongY) || added > SteepnessMargin * std::min({ a, b, c, d });
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
      node.Start = node.Value;
      sweeps.Add(left, low);
    }
  }
}

void GridLimit::SetGiven()
{
  const std::vector<double>& x = this->Source->XNodes;
  const std::vector<double>& y = this->Source->YNodes;
  this->GentleSides.assign(this->Source->Values.size(), 0);
  for (std::size_t row = 0; row < y.size(); ++row)
  {
    for (std::size_t column = 1; column < x.size(); ++column)
    {
      const std::size_t node = this->NodeAt(column, row);
      this->FindGentleSides(node - 1, node, x[column] - x[column - 1], ToRight, ToLeft);
    }
    for (std::size_t column = 0; row > 0 && column < x.size(); ++column)
    {
      const std::size_t node = this->NodeAt(column, row);
      this->FindGentleSides(node - x.size(), node, y[row] - y[row - 1], Up, Down);
    }
  }
  this->Nodes.reserve(this->Source->Values.size());
  for (std::size_t row = 0; row < y.size(); ++row)
  {
    for (std::size_t column = 0; column < x.size(); ++column)
    {
      this->Nodes.push_back(this->AsGiven(column, row));
    }
  }
}

/// One that is steeper is bounded by its lower end; but the least value may go on for a while.
void GridLimit::FindGentleSides(
  std::size_t node, std::size_t other, double length, unsigned toOther, unsigned back)
{
  const double value = this->Source->Values[node];
  const double otherValue = this->Source->Values[other];
  const bool isGentle = this->Range.Scale * std::abs(value - otherValue) < this->Gradation * length;
  const auto sideOf = [this, isGentle, length](double start, unsigned side)
  { return isGentle || (this->IsLeast(start) && length > 0.0) ? side : 0u; };
  this->GentleSides[node] |= sideOf(value, toOther);
  this->GentleSides[other] |= sideOf(otherValue, back);
}

/// Hands on what bounds one node to another one. What is as given bounds others only from steep
/// cells.
bool GridLimit::HandOn(const Node& other, Node& node, const Point2& place) const
{
  if (other.From == node.From || !(other.Start < node.Value))
  {
    return false;
  }
  Node source = other;
  const auto value = static_cast<float>(this->BoundFrom(source, place, node.Value, Sides::IfNear));
  const bool isLower = value < node.Value;
  if (isLower)
  {
    node.Value = value;
    node.Start = source.Start;
    node.From = source.From;
  }
  return isLower;
}

/// What the sides around the node that bounds `source` allow at x; where that is not below `limit`,
/// it may be any value that is not. The source becomes the end of these sides that is nearest to
/// what bounds x.
double GridLimit::BoundFrom(Node& source, const Point2& x, double limit, Sides sides) const
{
  const Point2 offset = x - this->PlaceOf(source.From);
  const double squared = this->SquaredGradation * Dot(offset, offset);
  const double start = source.Start;
  const double width =
    std::max(this->ColumnGrowth[source.From.Column()], this->RowGrowth[source.From.Row()]);
  const double most = width * width / (8.0 * SideShare);
  const bool hasSides = source.From.HasSides() &&
    (sides == Sides::Always || squared < SideReach * SideReach * width * width ||
      start * start * squared < most * most);
  const double room = limit - start + (hasSides ? 2.0 * width : 0.0);
  if (!(squared < room * room))
  {
    return limit;
  }
  const double bound = start + std::sqrt(squared);
  return hasSides ? this->BoundFromSides(source, x, bound) : bound;
}

/// A side bounds by more than its node only where values along it, seen from the node, rise less
/// than the place comes nearer.
double GridLimit::BoundFromSides(Node& source, const Point2& x, double own) const
{
  const std::size_t columns = this->Source->XNodes.size();
  const std::size_t node = this->NodeAt(source.From.Column(), source.From.Row());
  const double start = this->Source->Values[node];
  const bool isLeast = this->IsLeast(start);
  const double grown = own - static_cast<double>(source.Start);
  const Point2 offset = x - this->PlaceOf(source.From);
  const unsigned gentle = this->GentleSides[node];
  double bound = own;
  std::size_t nearest = node;
  const auto look =
    [&](const double* nodes, std::ptrdiff_t toEnd, double along, double across, std::size_t endNode)
  {
    const double end = this->Source->Values[endNode];
    const double rise = isLeast ? 0.0 : this->Range.Scale * (end - start);
    const double length = std::abs(nodes[toEnd] - nodes[0]);
    if (rise * grown < this->SquaredGradation * along * length)
    {
      const double found = this->Bound(along, across, length, start, end);
      nearest = found < bound ? endNode : nearest;
      bound = std::min(bound, found);
    }
  };
  const double* xNode = &this->Source->XNodes[source.From.Column()];
  const double* yNode = &this->Source->YNodes[source.From.Row()];
  if ((gentle & ToLeft) != 0)
  {
    look(xNode, -1, -offset.X, offset.Y, node - 1);
  }
  if ((gentle & ToRight) != 0)
  {
    look(xNode, 1, offset.X, offset.Y, node + 1);
  }
  if ((gentle & Down) != 0)
  {
    look(yNode, -1, -offset.Y, offset.X, node - columns);
  }
  if ((gentle & Up) != 0)
  {
    look(yNode, 1, offset.Y, offset.X, node + columns);
  }
  if (nearest != node)
  {
    const Node end = this->Itself(nearest % columns, nearest / columns);
    const Point2 away = x - this->PlaceOf(end.From);
    source = end.Start + this->Gradation * Length(away) < own ? end : source;
  }
  return bound;
}

void GridLimit::ClassifyCells(const GridSweeps& sweeps, Pulse& pulse)
{
  const std::size_t columns = this->Source->XNodes.size();
  const std::size_t rows = this->Source->YNodes.size();
  for (std::size_t row = 0; row < rows && pulse.Beat(2 * columns); ++row)
  {
    const GridSweeps::Stretch stretch = sweeps.OfRows(row, row);
    for (std::size_t column = stretch.First; column < stretch.End; ++column)
    {
      this->ForgetSlight(column, row);
    }
  }
  this->Cells.assign(this->Nodes.size(), Cell::AsGiven);
  for (std::size_t row = 0; row + 1 < rows && pulse.Beat(2 * columns); ++row)
  {
    const GridSweeps::Stretch stretch = sweeps.OfRows(row, row + 1);
    for (std::size_t column = stretch.First > 0 ? stretch.First - 1 : 0;
         column < std::min(stretch.End, columns - 1); ++column)
    {
      this->Cells[this->NodeAt(column, row)] = this->KindOf(column, row);
    }
  }
}

void GridLimit::ForgetSlight(std::size_t column, std::size_t row)
{
  Node& node = this->Nodes[this->NodeAt(column, row)];
  const Node given = this->AsGiven(column, row);
  if (node.Value > (1.0 - SlightShare) * given.Value && std::isfinite(node.Start))
  {
    node = this->Itself(column, row);
  }
}

/// What grows from within a steep cell reaches those beside it.
GridLimit::Cell GridLimit::KindOf(std::size_t column, std::size_t row) const
{
  float least = std::numeric_limits<float>::infinity();
  float start = least;
  bool isBounded = false;
  for (const std::size_t y : { row, row + 1 })
  {
    for (const std::size_t x : { column, column + 1 })
    {
      const Node& node = this->Nodes[this->NodeAt(x, y)];
      least = std::min(least, node.Value);
      start = std::min(start, node.Start);
      isBounded = isBounded || node.From.Column() != x || node.From.Row() != y;
    }
  }
  const double width = this->Source->XNodes[column + 1] - this->Source->XNodes[column];
  const double height = this->Source->YNodes[row + 1] - this->Source->YNodes[row];
  const bool isWide = this->Gradation * std::max(width, height) > WidestGrowth * least;
  return isWide && std::isfinite(start) ? Cell::Wide : isBounded ? Cell::Small : Cell::AsGiven;
}

double GridLimit::operator()(const Point2& x) const
{
  const GridInterpolator::Place place = this->Given.Find(x);
  const double given = this->Range(this->Given.At(place));
  const std::size_t low = this->NodeAt(place.Column, place.Row);
  const std::size_t high = this->NodeAt(place.Column, place.Row + 1);
  switch (this->Cells[low])
  {
    case Cell::AsGiven:
      return given;
    case Cell::Small:
      return std::min(given,
        Blend(Blend(this->Nodes[low].Value, this->Nodes[low + 1].Value, place.X),
          Blend(this->Nodes[high].Value, this->Nodes[high + 1].Value, place.X), place.Y));
    default:
      return this->ValueInWideCell(x, place, given);
  }
}

double GridLimit::ValueInWideCell(
  const Point2& x, const GridInterpolator::Place& place, double given) const
{
  LookedAt<std::size_t> looked;
  double least = given;
  for (std::size_t row = place.Row; row <= place.Row + 1; ++row)
  {
    least = this->LowerFromRow(x, row, place.Column, place.Column + 2, looked, least);
  }
  // What grows from beyond may pass between the corners.
  const std::size_t first = place.Column > 0 ? place.Column - 1 : 0;
  const std::size_t last = std::min(place.Column + 3, this->Source->XNodes.size());
  for (std::size_t row = place.Row > 0 ? place.Row - 1 : 0;
       row < std::min(place.Row + 3, this->Source->YNodes.size()); ++row)
  {
    least = this->LowerFromRow(x, row, first, last, looked, least);
  }
  return least;
}

/// By what bounds the nodes of a row.
double GridLimit::LowerFromRow(const Point2& x, std::size_t row, std::size_t first,
  std::size_t last, LookedAt<std::size_t>& looked, double least) const
{
  for (std::size_t column = first; column < last; ++column)
  {
    Node node = this->Nodes[this->NodeAt(column, row)];
    if (node.Start < least && looked.Add(this->NodeAt(node.From.Column(), node.From.Row())))
    {
      least = std::min(least, this->BoundFrom(node, x, least, Sides::Always));
    }
  }
  return least;
}

} // namespace biting
