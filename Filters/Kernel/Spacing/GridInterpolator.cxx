// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "GridInterpolator.h"

#include <algorithm> // for min, max
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
  : Source(std::move(source))
  , XAxis(this->Source->XNodes)
  , YAxis(this->Source->YNodes)
  , ToRight(this->Source->XNodes.size() > 1 ? 1 : 0)
  , ToNextRow(this->Source->YNodes.size() > 1 ? this->Source->XNodes.size() : 0)
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
  const double* low = &this->Source->Values[this->NodeAt(place.Column, place.Row)];
  const double* high = low + this->ToNextRow;
  return Blend(Blend(low[0], low[this->ToRight], place.X),
    Blend(high[0], high[this->ToRight], place.X), place.Y);
}

} // namespace biting
