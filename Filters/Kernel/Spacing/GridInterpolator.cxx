// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "GridInterpolator.h"

#include <algorithm> // for min, max, lower_bound
#include <utility>   // for move

namespace biting
{
namespace
{

/// Of the steps outside, one after the other.
constexpr double StepGrowth = 1.2;

/// The first step from a border outwards: as long as the last one before it, but a share of the
/// way.
double FirstStep(double last, double way)
{
  constexpr double ShortestShare = 1.0 / 1024.0;
  return last > ShortestShare * way ? last : ShortestShare * way;
}

/// Nodes out to the ends of an interval, beside those that there are, in steps that grow.
std::vector<double> Padded(const std::vector<double>& nodes, double low, double high)
{
  std::vector<double> padded = nodes;
  const std::size_t last = nodes.size() - 1;
  if (high > nodes.back())
  {
    double step = FirstStep(last > 0 ? nodes[last] - nodes[last - 1] : 0.0, high - nodes.back());
    for (double node = nodes.back() + step; node < high; node += step)
    {
      padded.push_back(node);
      step *= StepGrowth;
    }
    padded.push_back(high);
  }
  if (low < nodes.front())
  {
    std::vector<double> before;
    double step = FirstStep(last > 0 ? nodes[1] - nodes[0] : 0.0, nodes.front() - low);
    for (double node = nodes.front() - step; node > low; node -= step)
    {
      before.push_back(node);
      step *= StepGrowth;
    }
    before.push_back(low);
    padded.insert(padded.begin(), before.rbegin(), before.rend());
  }
  return padded;
}

/// Of the nodes of an axis in the values of a grid, `step` apart: nodes that are added have those
/// of the nodes beside them.
std::vector<std::size_t> OffsetsOf(
  const GridAxis& axis, const std::vector<double>& own, std::size_t step)
{
  const std::vector<double>& nodes = axis.AllNodes();
  const auto before = static_cast<std::size_t>(
    std::lower_bound(nodes.begin(), nodes.end(), own.front()) - nodes.begin());
  std::vector<std::size_t> offsets;
  for (std::size_t node = 0; node < nodes.size(); ++node)
  {
    offsets.push_back(step * std::min(std::max(node, before) - before, own.size() - 1));
  }
  return offsets;
}

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

GridInterpolator::GridInterpolator(std::shared_ptr<const GridSource> source, const Box2& bounds)
  : Source(std::move(source))
  , XAxis(Padded(this->Source->XNodes, bounds.Low.X, bounds.High.X))
  , YAxis(Padded(this->Source->YNodes, bounds.Low.Y, bounds.High.Y))
  , ColumnOffsets(OffsetsOf(this->XAxis, this->Source->XNodes, 1))
  , RowOffsets(OffsetsOf(this->YAxis, this->Source->YNodes, this->Source->XNodes.size()))
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
  const auto [a, b, c, d] = this->Corners(place.Column, place.Row);
  return Blend(Blend(a, b, place.X), Blend(c, d, place.X), place.Y);
}

std::array<double, 4> GridInterpolator::Corners(std::size_t column, std::size_t row) const
{
  const std::size_t left = this->ColumnOffsets[column];
  const std::size_t right = this->ColumnOffsets[column + 1];
  const double* low = this->Source->Values.data() + this->RowOffsets[row];
  const double* high = this->Source->Values.data() + this->RowOffsets[row + 1];
  return { low[left], low[right], high[left], high[right] };
}

} // namespace biting
