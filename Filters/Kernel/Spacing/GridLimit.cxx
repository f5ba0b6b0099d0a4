// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "GridLimit.h"

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

/// A grid with fewer cells gets more: within them, too, are places that f grows from.
constexpr double FewestCells = 4096.0;

/// Nodes with `parts` for each cell between them.
std::vector<GridAxis::Place> PartsOf(std::size_t nodes, std::size_t parts)
{
  std::vector<GridAxis::Place> places{ { 0, 0.0 } };
  for (std::size_t part = 0; part < parts * (nodes - 1); ++part)
  {
    places.push_back({ part / parts, static_cast<double>(part % parts + 1) / parts });
  }
  return places;
}

std::vector<double> NodesAt(
  const std::vector<GridAxis::Place>& places, const std::vector<double>& nodes)
{
  std::vector<double> refined{ nodes.front() };
  for (std::size_t k = 1; k < places.size(); ++k)
  {
    refined.push_back(Blend(nodes[places[k].Cell], nodes[places[k].Cell + 1], places[k].Weight));
  }
  return refined;
}

/// The same interpolant, on more cells if they are few.
std::shared_ptr<const GridSource> Refined(const std::shared_ptr<const GridSource>& source)
{
  const double cells = static_cast<double>(source->Values.size());
  if (cells >= FewestCells)
  {
    return source;
  }
  const auto parts = static_cast<std::size_t>(std::ceil(std::sqrt(FewestCells / cells)));
  const GridInterpolator coarse(source);
  const std::vector<GridAxis::Place> columns = PartsOf(source->XNodes.size(), parts);
  const std::vector<GridAxis::Place> rows = PartsOf(source->YNodes.size(), parts);
  auto fine = std::make_shared<GridSource>(
    GridSource{ NodesAt(columns, source->XNodes), NodesAt(rows, source->YNodes), {} });
  for (const GridAxis::Place& row : rows)
  {
    for (const GridAxis::Place& column : columns)
    {
      fine->Values.push_back(coarse.At({ column.Cell, row.Cell, column.Weight, row.Weight }));
    }
  }
  return fine;
}

} // namespace

GridLimit::GridLimit(const std::shared_ptr<const GridSource>& source, double gradation,
  const Box2& bounds, const ValueRange& range, Monitor& monitor)
  : Grid(Refined(source), bounds)
  , Gradation(gradation)
  , Range(range)
  , Bound(range, gradation)
{
  Pulse pulse(monitor);
  if (this->FindSteepCells(pulse))
  {
    this->SetGiven(pulse);
    this->Sweep(pulse);
    this->ClassifyCells(pulse);
  }
}

/// Whether there are any: Cells says which.
bool GridLimit::FindSteepCells(Pulse& pulse)
{
  bool isFound = false;
  this->Cells.assign(this->Grid.Columns() * this->Grid.Rows(), Cell::AsGiven);
  for (std::size_t row = 0; row + 1 < this->Grid.Rows() && pulse.Beat(4 * this->Grid.Columns());
       ++row)
  {
    for (std::size_t column = 0; column + 1 < this->Grid.Columns(); ++column)
    {
      if (this->IsSteep(column, row))
      {
        this->Cells[this->NodeAt(column, row)] = Cell::Steep;
        isFound = true;
      }
    }
  }
  pulse.SetFraction(0.2);
  return isFound && !pulse.HasStopped();
}

bool GridLimit::IsSteep(std::size_t column, std::size_t row) const
{
  auto [a, b, c, d] = this->Grid.Corners(column, row);
  for (double* corner : { &a, &b, &c, &d })
  {
    *corner = this->Range(*corner);
  }
  const double width = this->Grid.X(column + 1) - this->Grid.X(column);
  const double height = this->Grid.Y(row + 1) - this->Grid.Y(row);
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

void GridLimit::SetGiven(Pulse& pulse)
{
  this->Nodes.reserve(this->Cells.size());
  for (std::size_t row = 0; row < this->Grid.Rows() && pulse.Beat(this->Grid.Columns()); ++row)
  {
    for (std::size_t column = 0; column < this->Grid.Columns(); ++column)
    {
      this->Nodes.push_back(
        { static_cast<float>(this->Given(column, row)), this->NodeAt(column, row) });
    }
  }
}

void GridLimit::Sweep(Pulse& pulse)
{
  const std::size_t rows = this->Grid.Rows();
  for (std::size_t row = 1; row < rows && pulse.Beat(16 * this->Grid.Columns()); ++row)
  {
    pulse.SetFraction(0.2 + 0.35 * static_cast<double>(row) / static_cast<double>(rows));
    this->SweepRow(row, row - 1);
  }
  for (std::size_t row = rows - 1; row > 0 && pulse.Beat(16 * this->Grid.Columns()); --row)
  {
    pulse.SetFraction(0.9 - 0.35 * static_cast<double>(row) / static_cast<double>(rows));
    this->SweepRow(row - 1, row);
  }
}

void GridLimit::SweepRow(std::size_t row, std::size_t from)
{
  const std::size_t columns = this->Grid.Columns();
  const double across = std::abs(this->Grid.Y(from) - this->Grid.Y(row));
  const std::size_t low = std::min(row, from);
  const auto isSteepAround = [this, row](std::size_t column)
  { return this->IsSteepCell(column, row) || (row > 0 && this->IsSteepCell(column, row - 1)); };
  for (std::size_t column = 0; column < columns; ++column)
  {
    const NodeId to = this->NodeAt(column, row);
    const NodeId beside = this->NodeAt(column, from);
    const Point2 place = this->PlaceOf(column, row);
    const bool isSteepBefore = column > 0 && this->IsSteepCell(column - 1, low);
    const bool isSteepAfter = this->IsSteepCell(column, low);
    if (column > 0)
    {
      const double along = place.X - this->Grid.X(column - 1);
      this->HandOn(beside - 1, to, place, along + across, isSteepBefore);
      this->HandOn(to - 1, to, place, along, isSteepBefore || isSteepAround(column - 1));
    }
    this->HandOn(beside, to, place, across, isSteepBefore || isSteepAfter);
    if (column + 1 < columns)
    {
      const double along = this->Grid.X(column + 1) - place.X;
      this->HandOn(beside + 1, to, place, along + across, isSteepAfter);
    }
  }
  for (std::size_t column = columns - 1; column > 0; --column)
  {
    const NodeId to = this->NodeAt(column - 1, row);
    const Point2 place = this->PlaceOf(column - 1, row);
    this->HandOn(to + 1, to, place, this->Grid.X(column) - place.X, isSteepAround(column - 1));
  }
}

/// What bounds a node that is at most so far `away`, and grows with the gradation, no faster. What
/// bounds itself bounds others only across a steep cell.
void GridLimit::HandOn(NodeId from, NodeId to, const Point2& place, double away, bool isSteep)
{
  const Node& other = this->Nodes[from];
  Node& node = this->Nodes[to];
  if (other.Source != node.Source && (isSteep || other.Source != from) &&
    other.Value - this->Gradation * away < node.Value)
  {
    const auto value = static_cast<float>(this->BoundFrom(other.Source, place));
    if (value < node.Value)
    {
      node = { value, other.Source };
    }
  }
}

/// A side bounds by more than the node itself only where values along it, seen from the node, rise
/// less than the place comes nearer.
double GridLimit::BoundFrom(NodeId source, const Point2& x) const
{
  const auto columns = static_cast<NodeId>(this->Grid.Columns());
  const std::size_t column = source % columns;
  const std::size_t row = source / columns;
  const Point2 offset = x - this->PlaceOf(column, row);
  const double away = Length(offset);
  const double value = this->Grid.Value(column, row);
  const double own = this->Range(value);
  double bound = own + this->Gradation * away;
  const auto look = [&](double along, double across, double length, double end)
  {
    const double rise = own > this->Range.Least ? this->Range.Scale * (end - value) : 0.0;
    if (rise * away < this->Gradation * along * length)
    {
      bound = std::min(bound, this->Bound(along, across, length, value, end));
    }
  };
  if (column > 0)
  {
    const double length = this->Grid.X(column) - this->Grid.X(column - 1);
    look(-offset.X, offset.Y, length, this->Grid.Value(column - 1, row));
  }
  if (column + 1 < this->Grid.Columns())
  {
    const double length = this->Grid.X(column + 1) - this->Grid.X(column);
    look(offset.X, offset.Y, length, this->Grid.Value(column + 1, row));
  }
  if (row > 0)
  {
    const double length = this->Grid.Y(row) - this->Grid.Y(row - 1);
    look(-offset.Y, offset.X, length, this->Grid.Value(column, row - 1));
  }
  if (row + 1 < this->Grid.Rows())
  {
    const double length = this->Grid.Y(row + 1) - this->Grid.Y(row);
    look(offset.Y, offset.X, length, this->Grid.Value(column, row + 1));
  }
  return bound;
}

void GridLimit::ClassifyCells(Pulse& pulse)
{
  const std::size_t columns = this->Grid.Columns();
  std::vector<bool> isOfSteep(this->Nodes.size(), false);
  for (std::size_t row = 0; row < this->Grid.Rows() && pulse.Beat(2 * columns); ++row)
  {
    for (std::size_t column = 0; column < columns; ++column)
    {
      this->ForgetSlight(column, row);
      if (this->IsSteepCell(column, row))
      {
        const NodeId low = this->NodeAt(column, row);
        const NodeId high = this->NodeAt(column, row + 1);
        isOfSteep[low] = isOfSteep[low + 1] = isOfSteep[high] = isOfSteep[high + 1] = true;
      }
    }
  }
  for (std::size_t row = 0; row + 1 < this->Grid.Rows() && pulse.Beat(2 * columns); ++row)
  {
    for (std::size_t column = 0; column + 1 < columns; ++column)
    {
      this->Cells[this->NodeAt(column, row)] = this->KindOf(column, row, isOfSteep);
    }
  }
}

void GridLimit::ForgetSlight(std::size_t column, std::size_t row)
{
  const NodeId own = this->NodeAt(column, row);
  const double given = this->Given(column, row);
  if (this->Nodes[own].Value > (1.0 - SlightShare) * given)
  {
    this->Nodes[own] = { static_cast<float>(given), own };
  }
}

/// What grows from within a steep cell reaches those beside it.
GridLimit::Cell GridLimit::KindOf(
  std::size_t column, std::size_t row, const std::vector<bool>& isOfSteep) const
{
  float least = std::numeric_limits<float>::infinity();
  bool isBounded = false;
  bool isNearSteep = false;
  const NodeId low = this->NodeAt(column, row);
  const NodeId high = this->NodeAt(column, row + 1);
  for (const NodeId corner : { low, low + 1, high, high + 1 })
  {
    least = std::min(least, this->Nodes[corner].Value);
    isBounded = isBounded || this->Nodes[corner].Source != corner;
    isNearSteep = isNearSteep || isOfSteep[corner];
  }
  const double size = std::max(
    this->Grid.X(column + 1) - this->Grid.X(column), this->Grid.Y(row + 1) - this->Grid.Y(row));
  const bool isWide = this->Gradation * size > WidestGrowth * least;
  return isWide && (isBounded || isNearSteep) ? Cell::Wide
    : isBounded                               ? Cell::Small
                                              : Cell::AsGiven;
}

double GridLimit::operator()(const Point2& x) const
{
  const GridInterpolator::Place place = this->Grid.Find(x);
  const double given = this->Range(this->Grid.At(place));
  const Node* low = &this->Nodes[this->NodeAt(place.Column, place.Row)];
  const Node* high = low + this->Grid.Columns();
  switch (this->Cells[this->NodeAt(place.Column, place.Row)])
  {
    case Cell::AsGiven:
      return given;
    case Cell::Small:
      return std::min(given,
        Blend(Blend(low[0].Value, low[1].Value, place.X),
          Blend(high[0].Value, high[1].Value, place.X), place.Y));
    default:
      return this->ValueInWideCell(x, place, given);
  }
}

double GridLimit::ValueInWideCell(
  const Point2& x, const GridInterpolator::Place& place, double given) const
{
  LookedAt<NodeId> looked;
  double least = given;
  for (std::size_t row = place.Row; row <= place.Row + 1; ++row)
  {
    least = this->LowerFromRow(x, row, place.Column, place.Column + 2, looked, least);
  }
  // What grows from beyond may pass between the corners.
  const std::size_t first = place.Column > 0 ? place.Column - 1 : 0;
  const std::size_t last = std::min(place.Column + 3, this->Grid.Columns());
  for (std::size_t row = place.Row > 0 ? place.Row - 1 : 0;
       row < std::min(place.Row + 3, this->Grid.Rows()); ++row)
  {
    least = this->LowerFromRow(x, row, first, last, looked, least);
  }
  return least;
}

/// By what bounds the nodes of a row.
double GridLimit::LowerFromRow(const Point2& x, std::size_t row, std::size_t first,
  std::size_t last, LookedAt<NodeId>& looked, double least) const
{
  for (std::size_t column = first; column < last; ++column)
  {
    const Node& node = this->Nodes[this->NodeAt(column, row)];
    const double away = std::abs(x.X - this->Grid.X(column)) + std::abs(x.Y - this->Grid.Y(row));
    if (node.Value - this->Gradation * away < least && looked.Add(node.Source))
    {
      least = std::min(least, this->BoundFrom(node.Source, x));
    }
  }
  return least;
}

} // namespace biting
