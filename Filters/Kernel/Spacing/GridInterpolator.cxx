// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "GridInterpolator.h"

#include "../Base/Tasks.h"

#include <algorithm> // for min, max
#include <cstdint>   // for marks
#include <utility>   // for move

namespace biting
{
namespace
{

std::vector<double> AtLeastTwo(std::vector<double> nodes)
{
  if (nodes.size() == 1)
  {
    nodes.push_back(nodes.front());
  }
  return nodes;
}

} // namespace

GridAxis::GridAxis(const std::vector<double>& nodes)
  : Nodes(AtLeastTwo(nodes))
{
  const std::size_t bucketCount = this->Nodes.size() - 1;
  const double extent = this->Nodes.back() - this->Nodes.front();
  this->LastNodeBefore.assign(bucketCount + 1, 0);
  this->BucketsPerLength = extent > 0.0 ? static_cast<double>(bucketCount) / extent : 0.0;
  for (std::size_t node = 0; node < this->Nodes.size(); ++node)
  {
    this->LastNodeBefore[this->BucketOf(this->Nodes[node]) + 1] = static_cast<Id>(node);
  }
  for (std::size_t bucket = 1; bucket <= bucketCount; ++bucket)
  {
    this->LastNodeBefore[bucket] =
      std::max(this->LastNodeBefore[bucket], this->LastNodeBefore[bucket - 1]);
  }
}

/// Monotone, also after rounding: so a node of an earlier bucket is below the coordinate, and the
/// search between the last nodes of two buckets cannot miss.
std::size_t GridAxis::BucketOf(double coordinate) const
{
  const double bucket = (coordinate - this->Nodes.front()) * this->BucketsPerLength;
  const auto last = static_cast<double>(this->Nodes.size() - 2);
  return static_cast<std::size_t>(std::min(std::max(0.0, bucket), last));
}

GridAxis::Place GridAxis::Find(double coordinate) const
{
  const std::size_t bucket = this->BucketOf(coordinate);
  auto low = static_cast<std::size_t>(this->LastNodeBefore[bucket]);
  auto high = static_cast<std::size_t>(this->LastNodeBefore[bucket + 1]);
  while (low < high)
  {
    const std::size_t middle = (low + high + 1) / 2;
    const bool isAbove = coordinate < this->Nodes[middle];
    low = isAbove ? low : middle;
    high = isAbove ? middle - 1 : high;
  }
  const std::size_t cell = std::min(low, this->Nodes.size() - 2);
  const double width = this->Nodes[cell + 1] - this->Nodes[cell];
  const double weight = width > 0.0 ? (coordinate - this->Nodes[cell]) / width : 0.0;
  return { cell, std::min(std::max(0.0, weight), 1.0) };
}

GridInterpolator::GridInterpolator(std::shared_ptr<const GridSource> source)
  : Grid(std::move(source))
  , XAxis(this->Grid->XNodes)
  , YAxis(this->Grid->YNodes)
  , ToRight(this->Grid->XNodes.size() > 1 ? 1 : 0)
  , ToNextRow(this->Grid->YNodes.size() > 1 ? this->Grid->XNodes.size() : 0)
{
}

GridInterpolator::Place GridInterpolator::Find(const Point2& x) const
{
  const GridAxis::Place column = this->XAxis.Find(x.X);
  const GridAxis::Place row = this->YAxis.Find(x.Y);
  return { column.Cell, row.Cell, column.Weight, row.Weight };
}

double GridInterpolator::At(const Place& place) const
{
  const double* low = &this->Grid->Values[this->NodeAt(place.Column, place.Row)];
  const double* high = low + this->ToNextRow;
  return Blend(Blend(low[0], low[this->ToRight], place.X),
    Blend(high[0], high[this->ToRight], place.X), place.Y);
}

Source<2>::Sample GridInterpolator::At(const Point<2>& x) const
{
  const std::vector<double>& xs = this->Grid->XNodes;
  const std::vector<double>& ys = this->Grid->YNodes;
  const bool isInside =
    x[0] >= xs.front() && x[0] <= xs.back() && x[1] >= ys.front() && x[1] <= ys.back();
  return { (*this)(Point2{ x[0], x[1] }), isInside };
}

namespace
{

/// Lists the low places of a grid.
class LowNodes
{
public:
  LowNodes(const GridSource& grid, double slope, const ValueRange& range)
    : Grid(grid)
    , Columns(grid.XNodes.size())
    , Rows(grid.YNodes.size())
    , Slope(slope)
    , Range(range)
    , MostOnEdge(MostPlacesOnEdge(2 * grid.Values.size()))
    , AreSteep((this->Columns + 1) * (this->Rows + 1), 0)
  {
  }

  std::vector<LowPlace<2>> List(Pulse& pulse)
  {
    ForRowsAtOnce(pulse, std::max<std::size_t>(this->Rows - 1, 1), this->Columns,
      [this](std::size_t first, std::size_t last)
      {
        for (std::size_t row = first; row < last; ++row)
        {
          for (std::size_t column = 0; column == 0 || column + 1 < this->Columns; ++column)
          {
            this->AreSteep[this->CellAbove(column, row)] = this->IsSteep(column, row) ? 1 : 0;
          }
        }
      });
    std::vector<std::vector<LowPlace<2>>> parts(this->Rows);
    ForRowsAtOnce(pulse, this->Rows, this->Columns,
      [this, &parts](std::size_t first, std::size_t last)
      {
        for (std::size_t row = first; row < last; ++row)
        {
          this->ListRow(row, parts[row]);
        }
      });
    std::vector<LowPlace<2>> places;
    for (const std::vector<LowPlace<2>>& part : parts)
    {
      places.insert(places.end(), part.begin(), part.end());
    }
    return places;
  }

private:
  /// There is a column and a row of cells, which are not steep, on each side of the grid.
  std::size_t CellAbove(std::size_t column, std::size_t row) const
  {
    return column + 1 + (this->Columns + 1) * (row + 1);
  }

  double Value(std::size_t column, std::size_t row) const
  {
    return this->Grid.Values[column + row * this->Columns];
  }
  LowPlace<2> At(std::size_t column, std::size_t row) const
  {
    return { { this->Grid.XNodes[column], this->Grid.YNodes[row] },
      this->Range(this->Value(column, row)) };
  }

  /// Of the cell above a node, as LargestSlope measures it. A cell without a width or height is
  /// where values differ across it.
  bool IsSteep(std::size_t column, std::size_t row) const
  {
    const std::size_t right = std::min(column + 1, this->Columns - 1);
    const std::size_t up = std::min(row + 1, this->Rows - 1);
    const double values[4] = { this->Value(column, row), this->Value(right, row),
      this->Value(column, up), this->Value(right, up) };
    const auto [least, most] = std::minmax_element(values, values + 4);
    const auto slopeOf = [this](double rise, double otherRise, double step)
    {
      const double largest = this->Range.Scale * std::max(std::abs(rise), std::abs(otherRise));
      return largest > 0.0 ? largest / step : 0.0;
    };
    const double alongX = slopeOf(values[1] - values[0], values[3] - values[2],
      this->Grid.XNodes[right] - this->Grid.XNodes[column]);
    const double alongY = slopeOf(
      values[2] - values[0], values[3] - values[1], this->Grid.YNodes[up] - this->Grid.YNodes[row]);
    return this->Range(*least) < this->Range(*most) &&
      alongX * alongX + alongY * alongY > this->Slope * this->Slope;
  }

  void ListRow(std::size_t row, std::vector<LowPlace<2>>& places) const
  {
    for (std::size_t column = 0; column < this->Columns; ++column)
    {
      const std::uint8_t* above = &this->AreSteep[this->CellAbove(column, row)];
      const std::uint8_t* below = above - (this->Columns + 1);
      const bool isRightSteep = (above[0] | below[0]) != 0;
      const bool isUpSteep = (above[0] | above[-1]) != 0;
      if (isRightSteep || isUpSteep || below[-1] != 0)
      {
        this->ListNode(column, row, isRightSteep, isUpSteep, places);
      }
    }
  }

  /// And what is on its edges to the right and up.
  void ListNode(std::size_t column, std::size_t row, bool isRightSteep, bool isUpSteep,
    std::vector<LowPlace<2>>& places) const
  {
    const LowPlace<2> own = this->At(column, row);
    bool isLow = true;
    const auto lookAt = [this, &own, &isLow, &places](const LowPlace<2>& other, bool isSteep)
    {
      isLow = isLow && own.Value <= other.Value + this->Slope * Distance<2>(own.At, other.At);
      if (isSteep)
      {
        AddPlacesOnEdge<2>(own, other, this->Slope, this->MostOnEdge, places);
      }
    };
    lookAt(this->At(column > 0 ? column - 1 : 0, row), false);
    lookAt(this->At(column, row > 0 ? row - 1 : 0), false);
    lookAt(this->At(std::min(column + 1, this->Columns - 1), row), isRightSteep);
    lookAt(this->At(column, std::min(row + 1, this->Rows - 1)), isUpSteep);
    if (isLow)
    {
      places.push_back(own);
    }
  }

  const GridSource& Grid;
  const std::size_t Columns;
  const std::size_t Rows;
  const double Slope;
  const ValueRange& Range;
  const double MostOnEdge;
  std::vector<std::uint8_t> AreSteep; ///< cells
};

} // namespace

std::vector<LowPlace<2>> GridInterpolator::LowPlaces(
  double slope, const ValueRange& range, Pulse& pulse) const
{
  return LowNodes(*this->Grid, slope, range).List(pulse);
}

} // namespace biting
