// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "VertexGrid.h"

#include <cmath>   // for floor
#include <cstddef> // for size_t

namespace biting
{

namespace
{

/// Columns and rows are below 2^51 in magnitude, as the reach is a few ulp of the coordinates; cells
/// that share a key cost time only.
std::uint64_t KeyOf(double column, double row)
{
  const auto x = static_cast<std::uint64_t>(static_cast<std::int64_t>(column));
  const auto y = static_cast<std::uint64_t>(static_cast<std::int64_t>(row));
  const std::uint64_t mixed = x * 0x9E3779B97F4A7C15u + y;
  return mixed ^ (mixed >> 29);
}

} // namespace

VertexGrid::VertexGrid(const std::vector<Point2>& points, double reach)
  : Points(points)
  , Reach(reach)
{
}

void VertexGrid::Update()
{
  this->Cells.reserve(this->Points.size());
  for (std::size_t v = this->Cells.size(); v < this->Points.size(); ++v)
  {
    const Point2& p = this->Points[v];
    const std::uint64_t key = KeyOf(std::floor(p.X / this->Reach), std::floor(p.Y / this->Reach));
    this->Cells.emplace(key, static_cast<Id>(v));
  }
}

Id VertexGrid::Find(const Point2& place) const
{
  const double column = std::floor(place.X / this->Reach);
  const double row = std::floor(place.Y / this->Reach);
  Id nearest = NoId;
  double least = this->Reach;
  for (int neighbor = 0; neighbor < 9; ++neighbor)
  {
    const auto range =
      this->Cells.equal_range(KeyOf(column + neighbor % 3 - 1, row + neighbor / 3 - 1));
    for (auto cell = range.first; cell != range.second; ++cell)
    {
      const Id vertex = cell->second;
      const double distance = Distance(place, this->Points[static_cast<std::size_t>(vertex)]);
      const bool isTie = distance == least && (nearest == NoId || vertex < nearest);
      if (distance < least || isTie)
      {
        nearest = vertex;
        least = distance;
      }
    }
  }
  return nearest;
}

} // namespace biting
