// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "GridInterpolator.h"

#include "../Base/BoxTree.h"
#include "../Base/Numbers.h"
#include "../Base/Tasks.h"

#include <algorithm> // for min, max, none_of
#include <cmath>     // for isnan
#include <cstdint>   // for marks
#include <limits>    // for nodes that have no value yet
#include <utility>   // for move

namespace biting
{
namespace
{

/// A node of a grid that has a value.
struct GivenNode
{
  Point2 At;
  double Value;

  // For a BoxTree.
  Box2 Box() const { return Box2::Around(this->At, this->At); }
  double Least() const { return 0.0; }
};

/// With the value of the nearest node in each hole. A neighbor of that node is a hole, too: the one
/// towards the hole is nearer.
std::shared_ptr<const GridSource> WithoutHoles(
  const std::shared_ptr<const GridSource>& source, Pulse& pulse)
{
  const std::vector<double>& values = source->Values;
  if (std::none_of(values.begin(), values.end(), [](double value) { return std::isnan(value); }))
  {
    return source;
  }
  const std::size_t columns = source->XNodes.size();
  const auto placeOf = [&source, columns](std::size_t node) {
    return Point2{ source->XNodes[node % columns], source->YNodes[node / columns] };
  };
  const auto isHole = [&values](std::size_t node)
  { return node < values.size() && std::isnan(values[node]); };
  std::vector<GivenNode> given;
  for (std::size_t node = 0; node < values.size() && pulse.Beat(1); ++node)
  {
    if (!isHole(node) &&
      (isHole(node + 1) || isHole(node - 1) || isHole(node + columns) || isHole(node - columns)))
    {
      given.push_back({ placeOf(node), values[node] });
    }
  }
  const BoxTree<GivenNode> tree(std::move(given), pulse);
  auto filled = std::make_shared<GridSource>(*source);
  ForEachAtOnce(pulse, values.size(),
    [&isHole, &placeOf, &tree, &filled](std::size_t node)
    {
      double nearest = isHole(node) ? Infinity : 0.0;
      const Point2 place = placeOf(node);
      tree.Search(place, 1.0, nearest,
        [&place, &nearest, &filled, node](const GivenNode& other, double)
        {
          const double distance = Distance(place, other.At);
          filled->Values[node] = distance < nearest ? other.Value : filled->Values[node];
          nearest = std::min(distance, nearest);
          return nearest;
        });
    });
  return filled;
}

/// An axis whose first and last nodes are there twice where they do not reach `low` and `high`; two
/// nodes at least.
std::vector<double> ReachingAxis(std::vector<double> nodes, double low, double high)
{
  if (low < nodes.front())
  {
    nodes.insert(nodes.begin(), low);
  }
  if (high > nodes.back() || nodes.size() == 1)
  {
    nodes.push_back(std::max(nodes.back(), high));
  }
  return nodes;
}

/// The same spacing on a grid that reaches over `bounds`.
std::shared_ptr<const GridSource> ReachingOver(
  const std::shared_ptr<const GridSource>& source, const Box2& bounds)
{
  const std::vector<double>& xs = source->XNodes;
  const std::vector<double>& ys = source->YNodes;
  GridSource reaching{ ReachingAxis(xs, bounds.Low.X, bounds.High.X),
    ReachingAxis(ys, bounds.Low.Y, bounds.High.Y), {} };
  const std::size_t columns = reaching.XNodes.size();
  const std::size_t rows = reaching.YNodes.size();
  if (columns == xs.size() && rows == ys.size())
  {
    return source;
  }
  reaching.Values.reserve(columns * rows);
  const std::size_t left = reaching.XNodes.front() < xs.front() ? 1 : 0;
  const std::size_t below = reaching.YNodes.front() < ys.front() ? 1 : 0;
  for (std::size_t node = 0; node < columns * rows; ++node)
  {
    const std::size_t column = std::max(node % columns, left) - left;
    const std::size_t row = std::max(node / columns, below) - below;
    reaching.Values.push_back(
      source->Values[std::min(column, xs.size() - 1) + std::min(row, ys.size() - 1) * xs.size()]);
  }
  return std::make_shared<const GridSource>(std::move(reaching));
}

/// Cell i lies between nodes i and i + 1; Weight in [0, 1] is that of node i + 1.
struct PlaceOnAxis
{
  std::size_t Cell;
  double Weight;
};

/// The nearest place on the axis. Constant cost where nodes are evenly spaced, else logarithmic.
PlaceOnAxis FindOnAxis(const std::vector<double>& nodes, double coordinate)
{
  const std::size_t cells = nodes.size() - 1;
  const double share = (coordinate - nodes.front()) / (nodes.back() - nodes.front());
  const double guess = std::min(std::max(0.0, share), 1.0) * static_cast<double>(cells);
  std::size_t cell = std::min(static_cast<std::size_t>(guess), cells - 1);
  if (!(nodes[cell] <= coordinate && coordinate < nodes[cell + 1]))
  {
    const auto above = std::upper_bound(nodes.begin() + 1, nodes.end() - 1, coordinate);
    cell = static_cast<std::size_t>(above - nodes.begin()) - 1;
  }
  const double width = nodes[cell + 1] - nodes[cell];
  const double weight = width > 0.0 ? (coordinate - nodes[cell]) / width : 0.0;
  return { cell, std::min(std::max(0.0, weight), 1.0) };
}

double Blend(double low, double high, double weight)
{
  return (1.0 - weight) * low + weight * high;
}

/// Lists the low edges of a grid.
class SteepCells
{
public:
  SteepCells(const GridSource& grid, const SteepRule& rule)
    : Grid(grid)
    , Columns(grid.XNodes.size())
    , Rows(grid.YNodes.size())
    , Rule(rule)
    , AreSteep((this->Columns + 1) * (this->Rows + 1), 0)
  {
  }

  /// Returns the largest slope.
  double Find(Pulse& pulse)
  {
    std::vector<double> largest(this->Rows, 0.0);
    ForRowsAtOnce(pulse, this->Rows - 1, this->Columns,
      [this, &largest](std::size_t first, std::size_t last)
      {
        for (std::size_t row = first; row < last; ++row)
        {
          for (std::size_t column = 0; column + 1 < this->Columns; ++column)
          {
            largest[row] = std::max(largest[row], this->MarkCell(column, row));
          }
        }
      });
    return *std::max_element(largest.begin(), largest.end());
  }

  void List(SegmentSource& edges, Pulse& pulse)
  {
    edges.Join(SumAtOnce(pulse, this->Grid.Values.size(), SegmentSource(),
      [this](SegmentSource& part, std::size_t node)
      { this->ListNode(node % this->Columns, node / this->Columns, part); }));
  }

private:
  /// There is a column and a row of cells, which are not steep, on each side of the grid.
  std::size_t CellAbove(std::size_t column, std::size_t row) const
  {
    return column + 1 + (this->Columns + 1) * (row + 1);
  }

  CellNode At(std::size_t column, std::size_t row) const
  {
    const double value = this->Grid.Values[column + row * this->Columns];
    return { { this->Grid.XNodes[column], this->Grid.YNodes[row] }, this->Rule.Range.Scale * value,
      this->Rule.Range(value) };
  }

  /// Returns the slope of the cell above a node, if it is finite: the length of the largest slopes
  /// along x and along y. A cell without a width or height is steep where values differ across it.
  double MarkCell(std::size_t column, std::size_t row)
  {
    const double* low = &this->Grid.Values[column + row * this->Columns];
    const double* high = low + this->Columns;
    const double alongX = SlopeOf(low[1] - low[0], high[1] - high[0],
      this->Grid.XNodes[column + 1] - this->Grid.XNodes[column]);
    const double alongY = SlopeOf(
      high[0] - low[0], high[1] - low[1], this->Grid.YNodes[row + 1] - this->Grid.YNodes[row]);
    const double slope = std::sqrt(alongX * alongX + alongY * alongY);
    if (this->Rule.Range.Scale * slope > this->Rule.Slope)
    {
      const auto [least, most] = std::minmax({ low[0], low[1], high[0], high[1] });
      this->AreSteep[this->CellAbove(column, row)] =
        this->Rule.Range(least) < this->Rule.Range(most) ? 1 : 0;
    }
    return slope <= std::numeric_limits<double>::max() ? slope : 0.0;
  }

  static double SlopeOf(double rise, double otherRise, double step)
  {
    const double largest = std::max(std::abs(rise), std::abs(otherRise));
    return largest > 0.0 ? largest / step : 0.0;
  }

  /// And its edges to the right and up, and the cell above it.
  void ListNode(std::size_t column, std::size_t row, SegmentSource& edges) const
  {
    const std::uint8_t* above = &this->AreSteep[this->CellAbove(column, row)];
    const std::uint8_t* below = above - (this->Columns + 1);
    if ((above[0] | above[-1] | below[0] | below[-1]) == 0)
    {
      return;
    }
    const CellNode own = this->At(column, row);
    if (this->IsLow(own, column, row))
    {
      edges.Add(own.At, own.At, own.Value, own.Value);
    }
    if ((above[0] | below[0]) != 0)
    {
      AddLowEdge(own, this->At(column + 1, row), this->Rule, edges);
    }
    if ((above[0] | above[-1]) != 0)
    {
      AddLowEdge(own, this->At(column, row + 1), this->Rule, edges);
    }
    if (above[0] != 0)
    {
      AddLevelLine({ own, this->At(column + 1, row), this->At(column + 1, row + 1),
                     this->At(column, row + 1) },
        this->Rule.Range, edges);
    }
  }

  /// Whether no node around it is so low that it stands for it.
  bool IsLow(const CellNode& own, std::size_t column, std::size_t row) const
  {
    bool isLow = true;
    for (std::size_t y = row > 0 ? row - 1 : row; y <= std::min(row + 1, this->Rows - 1); ++y)
    {
      for (std::size_t x = column > 0 ? column - 1 : 0;
           x <= std::min(column + 1, this->Columns - 1); ++x)
      {
        const CellNode other = this->At(x, y);
        isLow = isLow && own.Value <= other.Value + this->Rule.Slope * Distance(own.At, other.At);
      }
    }
    return isLow;
  }

  const GridSource& Grid;
  const std::size_t Columns;
  const std::size_t Rows;
  const SteepRule& Rule;
  std::vector<std::uint8_t> AreSteep; ///< cells
};

} // namespace

GridInterpolator::GridInterpolator(
  const std::shared_ptr<const GridSource>& source, const Box2& bounds, Pulse& pulse)
  : Grid(ReachingOver(WithoutHoles(source, pulse), bounds))
{
}

double GridInterpolator::operator()(const Point2& x) const
{
  const PlaceOnAxis column = FindOnAxis(this->Grid->XNodes, x.X);
  const PlaceOnAxis row = FindOnAxis(this->Grid->YNodes, x.Y);
  const double* low = &this->Grid->Values[column.Cell + row.Cell * this->Grid->XNodes.size()];
  const double* high = low + this->Grid->XNodes.size();
  return Blend(
    Blend(low[0], low[1], column.Weight), Blend(high[0], high[1], column.Weight), row.Weight);
}

double GridInterpolator::AddLowEdges(
  const SteepRule& rule, SegmentSource& edges, Pulse& pulse) const
{
  SteepCells cells(*this->Grid, rule);
  const double slope = cells.Find(pulse);
  cells.List(edges, pulse);
  return slope;
}

} // namespace biting
