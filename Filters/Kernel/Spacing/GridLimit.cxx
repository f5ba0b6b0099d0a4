// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "GridLimit.h"

#include "../Base/Pulse.h"
#include "GridCells.h"
#include "WideCells.h"

#include <cmath> // for sqrt

namespace biting
{
namespace
{

/// A plane so many times as steep as the gradation is above it along a row, column or diagonal: the
/// inverse of the cosine of 22.5 degrees.
constexpr double SeenByNodes = 1.083;

class GridLimiter
{
public:
  GridLimiter(const GridSource& source, double gradation, ConeCollector& cones, Pulse& pulse)
    : Cells(source, gradation, cones.Values())
    , Cones(cones)
    , Beats(pulse)
    , Columns(Cells.Columns())
    , Rows(Cells.Rows())
  {
  }

  bool HasSteepCell()
  {
    bool isFound = false;
    for (Id row = 0; row < this->Rows && !isFound && this->EndRow(0.1 * row / this->Rows); ++row)
    {
      for (Id column = 0; column < this->Columns; ++column)
      {
        isFound = isFound || this->Cells.IsSteep(column, row);
      }
    }
    return isFound;
  }

  /// Lowers `values`, which are as given.
  bool Limit(std::vector<double>& values)
  {
    this->SetGiven();
    this->FindSlight();
    for (Id row = 0; row < this->Rows && this->EndRow(0.2 + 0.3 * row / this->Rows); ++row)
    {
      this->SweepRow(row, row - 1);
    }
    for (Id row = this->Rows - 1; row >= 0 && this->EndRow(0.8 - 0.3 * row / this->Rows); --row)
    {
      this->SweepRow(row, row + 1);
    }
    if (this->Beats.HasStopped())
    {
      return false;
    }
    WideCells wide(this->Cells, this->Bounds, this->Cones, this->Beats);
    return wide.AddCones() && this->WriteLimits(wide, values);
  }

private:
  /// A row is done; `fraction` of all the work.
  bool EndRow(double fraction)
  {
    this->Beats.SetFraction(fraction);
    return this->Beats.Beat(8 * static_cast<std::size_t>(this->Columns));
  }

  NodeBound& BoundOf(Id column, Id row)
  {
    return this->Bounds[static_cast<std::size_t>(this->Cells.Node(column, row))];
  }

  void SetGiven()
  {
    this->Bounds.reserve(static_cast<std::size_t>(this->Columns) * this->Rows);
    for (Id row = 0; row < this->Rows && this->EndRow(0.1 + 0.05 * row / this->Rows); ++row)
    {
      for (Id column = 0; column < this->Columns; ++column)
      {
        const auto given = static_cast<float>(this->Cells.Given(this->Cells.Node(column, row)));
        this->Bounds.push_back({ given, given, this->OffsetOf(column, row) });
      }
    }
  }

  /// From the first node: in single precision that is as good far from the origin.
  NodeBound::Offset OffsetOf(Id column, Id row) const
  {
    return { static_cast<float>(this->Cells.X(column) - this->Cells.X(0)),
      static_cast<float>(this->Cells.Y(row) - this->Cells.Y(0)) };
  }

  /// Nodes alone see the slope along rows, columns and diagonals only: all of a slope that is above
  /// the gradation by 8 % or more. In cells of a smaller one each corner is bounded from within the
  /// two sides opposite to it, too, again and again.
  void FindSlight()
  {
    this->IsSlight.reserve(this->Bounds.size());
    for (Id row = 0; row < this->Rows && this->EndRow(0.15 + 0.05 * row / this->Rows); ++row)
    {
      for (Id column = 0; column < this->Columns; ++column)
      {
        const bool isCell = column + 1 < this->Columns && row + 1 < this->Rows;
        this->IsSlight.push_back(isCell && this->Cells.IsSteep(column, row) &&
          !this->Cells.IsSteep(column, row, SeenByNodes));
      }
    }
  }

  /// Bounds a node from the sides opposite to it of the cell that lies on the given sides of it.
  void LowerIn(Id column, Id row, Id toColumn, Id toRow)
  {
    const Id low = std::min(column, toColumn);
    if (low < 0 || toColumn >= this->Columns ||
      !this->IsSlight[static_cast<std::size_t>(this->Cells.Node(low, std::min(row, toRow)))])
    {
      return;
    }
    this->LowerFromSide(column, row, toColumn, row, toColumn, toRow);
    this->LowerFromSide(column, row, column, toRow, toColumn, toRow);
  }

  /// Bounds the corner (x, y) from within the side that leads from the corner beside it to the one
  /// across: as for a SegmentCone, the foot is where the side falls with Slope / g = sin of the angle
  /// to the perpendicular.
  void LowerFromSide(Id x, Id y, Id besideX, Id besideY, Id acrossX, Id acrossY)
  {
    const double gradation = this->Cells.Gradation();
    const Point2 beside = this->Cells.Place(besideX, besideY);
    const Point2 side = this->Cells.Place(acrossX, acrossY) - beside;
    const double length = Length(side);
    const double away = Distance(this->Cells.Place(x, y), beside);
    const double from = this->BoundOf(besideX, besideY).Value;
    const double to = this->BoundOf(acrossX, acrossY).Value;
    const double fall = (from - to) / (gradation * length);
    if (!(fall > 0.0 && fall < 1.0))
    {
      return; // the bound is from a corner
    }
    const double foot = away * fall / std::sqrt((1.0 - fall) * (1.0 + fall));
    NodeBound& bound = this->BoundOf(x, y);
    const double base = from - fall * gradation * foot;
    const auto value = static_cast<float>(base + gradation * Length({ away, foot }));
    if (foot < length && value < bound.Value)
    {
      const Point2 place = beside + (foot / length) * side - this->Cells.Place(0, 0);
      bound = { value, static_cast<float>(base),
        { static_cast<float>(place.X), static_cast<float>(place.Y) } };
    }
  }

  void SweepRow(Id row, Id from)
  {
    const bool hasFrom = from >= 0 && from < this->Rows;
    for (Id column = 0; column < this->Columns; ++column)
    {
      for (Id side = -1; hasFrom && side <= 1; ++side)
      {
        this->Lower(column, row, column + side, from);
      }
      this->Lower(column, row, column - 1, row);
      if (hasFrom)
      {
        this->LowerIn(column, row, column - 1, from);
        this->LowerIn(column, row, column + 1, from);
      }
    }
    for (Id column = this->Columns - 2; column >= 0; --column)
    {
      this->Lower(column, row, column + 1, row);
    }
  }

  void Lower(Id column, Id row, Id fromColumn, Id fromRow)
  {
    if (fromColumn < 0 || fromColumn >= this->Columns)
    {
      return;
    }
    NodeBound& bound = this->BoundOf(column, row);
    const NodeBound& from = this->BoundOf(fromColumn, fromRow);
    const float room = bound.Value - from.Base;
    if (!(room > 0.0f))
    {
      return;
    }
    const NodeBound::Offset here = this->OffsetOf(column, row);
    const float x = here.X - from.Place.X;
    const float y = here.Y - from.Place.Y;
    const auto gradation = static_cast<float>(this->Cells.Gradation());
    const float square = gradation * gradation * (x * x + y * y);
    if (square < room * room)
    {
      const float value = from.Base + std::sqrt(square);
      if (value < bound.Value)
      {
        bound = { value, from.Base, from.Place };
      }
    }
  }

  bool WriteLimits(const WideCells& wide, std::vector<double>& values)
  {
    for (Id row = 0; row < this->Rows && this->EndRow(0.95 + 0.05 * row / this->Rows); ++row)
    {
      for (Id column = 0; column < this->Columns; ++column)
      {
        const NodeBound& bound = this->BoundOf(column, row);
        const Id node = this->Cells.Node(column, row);
        if (bound.IsBelow(this->Cells.Given(node)) && !wide.IsNodeOf(column, row))
        {
          values[static_cast<std::size_t>(node)] = bound.Value / this->Cones.Values().Scale;
        }
      }
    }
    return !this->Beats.HasStopped();
  }

  const GridCells Cells;
  ConeCollector& Cones;
  Pulse& Beats;
  const Id Columns;
  const Id Rows;
  std::vector<NodeBound> Bounds;
  std::vector<bool> IsSlight; ///< of each cell: steep, but not so that nodes alone see it
};

/// Nodes at the ends of an interval, beside those that there are.
std::vector<double> Padded(std::vector<double> nodes, double low, double high)
{
  if (low < nodes.front())
  {
    nodes.insert(nodes.begin(), low);
  }
  if (high > nodes.back())
  {
    nodes.push_back(high);
  }
  return nodes;
}

/// A copy that has nodes on the border of the bounds where these are larger, with the values of the
/// nodes beside.
std::shared_ptr<GridSource> Extended(const GridSource& source, const Box2& bounds)
{
  auto grid = std::make_shared<GridSource>();
  grid->XNodes = Padded(source.XNodes, bounds.Low.X, bounds.High.X);
  grid->YNodes = Padded(source.YNodes, bounds.Low.Y, bounds.High.Y);
  const std::size_t columns = source.XNodes.size();
  const std::size_t left = grid->XNodes.front() < source.XNodes.front() ? 1 : 0;
  const std::size_t below = grid->YNodes.front() < source.YNodes.front() ? 1 : 0;
  grid->Values.reserve(grid->XNodes.size() * grid->YNodes.size());
  for (std::size_t row = 0; row < grid->YNodes.size(); ++row)
  {
    const std::size_t from =
      columns * std::min(std::max(row, below) - below, source.YNodes.size() - 1);
    for (std::size_t column = 0; column < grid->XNodes.size(); ++column)
    {
      grid->Values.push_back(
        source.Values[from + std::min(std::max(column, left) - left, columns - 1)]);
    }
  }
  return grid;
}

} // namespace

std::shared_ptr<const GridSource> LimitGrid(const std::shared_ptr<const GridSource>& source,
  double gradation, const Box2& bounds, ConeCollector& cones, Monitor& monitor)
{
  Pulse pulse(monitor);
  const bool isSteep = GridLimiter(*source, gradation, cones, pulse).HasSteepCell();
  if (!isSteep || pulse.HasStopped())
  {
    return pulse.HasStopped() ? nullptr : source;
  }
  const std::shared_ptr<GridSource> limited = Extended(*source, bounds);
  const GridSource given = *limited;
  return GridLimiter(given, gradation, cones, pulse).Limit(limited->Values) ? limited : nullptr;
}

} // namespace biting
