// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "GridHoles.h"

#include "../Base/Pulse.h"

#include <algorithm> // for any_of
#include <limits>    // for infinity

namespace biting
{
namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();

/// The nearest given node of each column, for every row: row number, NoId in a column of holes.
class ColumnNearest
{
public:
  ColumnNearest(const GridSource& source, Pulse& pulse)
    : Source(source)
    , Rows(source.Values.size(), NoId)
  {
    const auto rowCount = static_cast<Id>(source.YNodes.size());
    for (Id row = 0; row < rowCount && pulse.Beat(source.XNodes.size()); ++row)
    {
      this->Adopt(row, row - 1);
    }
    for (Id row = rowCount - 1; row >= 0 && pulse.Beat(source.XNodes.size()); --row)
    {
      this->Adopt(row, row + 1);
    }
  }

  Id RowOf(Id column, Id row) const { return this->Rows[this->NodeOf(column, row)]; }

  double DistanceSquared(Id column, Id row) const
  {
    const Id nearest = this->RowOf(column, row);
    return nearest == NoId ? Infinity : this->SquaredStep(row, nearest);
  }

private:
  std::size_t NodeOf(Id column, Id row) const
  {
    return static_cast<std::size_t>(column) +
      static_cast<std::size_t>(row) * this->Source.XNodes.size();
  }

  double SquaredStep(Id from, Id to) const
  {
    const double step = this->Source.YNodes[static_cast<std::size_t>(to)] -
      this->Source.YNodes[static_cast<std::size_t>(from)];
    return step * step;
  }

  void Adopt(Id row, Id neighborRow)
  {
    const auto rowCount = static_cast<Id>(this->Source.YNodes.size());
    for (Id column = 0; column < static_cast<Id>(this->Source.XNodes.size()); ++column)
    {
      Id& nearest = this->Rows[this->NodeOf(column, row)];
      if (!std::isnan(this->Source.Values[this->NodeOf(column, row)]))
      {
        nearest = row;
        continue;
      }
      const bool hasNeighbor = neighborRow >= 0 && neighborRow < rowCount;
      const Id offered = hasNeighbor ? this->RowOf(column, neighborRow) : NoId;
      const bool isNearer = offered != NoId &&
        (nearest == NoId || this->SquaredStep(row, offered) < this->SquaredStep(row, nearest));
      nearest = isNearer ? offered : nearest;
    }
  }

  const GridSource& Source;
  std::vector<Id> Rows;
};

/// Lower envelope of the parabolas (x - x_i)^2 + height_i over one row: which column is nearest
/// (the second pass of the exact distance transform of Felzenszwalb and Huttenlocher, 2012).
class RowEnvelope
{
public:
  explicit RowEnvelope(const std::vector<double>& nodes)
    : Nodes(nodes)
  {
  }

  void Clear()
  {
    this->Columns.clear();
    this->Starts.clear();
    this->Heights.clear();
  }

  void Add(Id column, double height)
  {
    double start = -Infinity;
    while (!this->Columns.empty())
    {
      start = this->Crossing(this->Columns.back(), this->Heights.back(), column, height);
      if (start > this->Starts.back())
      {
        break;
      }
      this->Columns.pop_back();
      this->Starts.pop_back();
      this->Heights.pop_back();
      start = -Infinity;
    }
    this->Columns.push_back(column);
    this->Starts.push_back(start);
    this->Heights.push_back(height);
  }

  /// The column of the lowest parabola at x.
  Id LowestAt(double x) const
  {
    const auto next = std::upper_bound(this->Starts.begin(), this->Starts.end(), x);
    const auto piece = std::max<std::ptrdiff_t>(next - this->Starts.begin() - 1, 0);
    return this->Columns[static_cast<std::size_t>(piece)];
  }

private:
  /// Where the parabola of the later column becomes the lower one. Equal nodes never cross: the
  /// lower of the two parabolas wins everywhere.
  double Crossing(Id earlier, double earlierHeight, Id later, double laterHeight) const
  {
    const double a = this->Nodes[static_cast<std::size_t>(earlier)];
    const double b = this->Nodes[static_cast<std::size_t>(later)];
    if (!(b > a))
    {
      return laterHeight < earlierHeight ? -Infinity : Infinity;
    }
    return a + 0.5 * ((b - a) + (laterHeight - earlierHeight) / (b - a));
  }

  const std::vector<double>& Nodes;
  std::vector<Id> Columns;
  std::vector<double> Starts;
  std::vector<double> Heights;
};

void FillRow(const GridSource& source, const ColumnNearest& nearest, Id row, RowEnvelope& envelope,
  std::vector<double>& values)
{
  const auto columnCount = static_cast<Id>(source.XNodes.size());
  envelope.Clear();
  for (Id column = 0; column < columnCount; ++column)
  {
    if (nearest.RowOf(column, row) != NoId)
    {
      envelope.Add(column, nearest.DistanceSquared(column, row));
    }
  }
  for (Id column = 0; column < columnCount; ++column)
  {
    double& value = values[static_cast<std::size_t>(column) +
      static_cast<std::size_t>(row) * source.XNodes.size()];
    if (std::isnan(value))
    {
      const Id from = envelope.LowestAt(source.XNodes[static_cast<std::size_t>(column)]);
      value = source.Values[static_cast<std::size_t>(from) +
        static_cast<std::size_t>(nearest.RowOf(from, row)) * source.XNodes.size()];
    }
  }
}

} // namespace

std::shared_ptr<const GridSource> FillHoles(
  std::shared_ptr<const GridSource> source, Monitor& monitor)
{
  const bool hasHoles = std::any_of(
    source->Values.begin(), source->Values.end(), [](double value) { return std::isnan(value); });
  if (!hasHoles)
  {
    return source;
  }
  auto filled = std::make_shared<GridSource>(*source);
  Pulse pulse(monitor);
  const ColumnNearest nearest(*source, pulse);
  RowEnvelope envelope(source->XNodes);
  for (Id row = 0; row < static_cast<Id>(source->YNodes.size()); ++row)
  {
    if (!pulse.Beat(4 * source->XNodes.size()))
    {
      return nullptr;
    }
    FillRow(*source, nearest, row, envelope, filled->Values);
  }
  return filled;
}

} // namespace biting
