// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "VertexGrid.h"

#include <cmath> // for floor

namespace biting
{

namespace
{

constexpr double CellSizeInReach = 16.0;
constexpr std::size_t LeastEntries = 1024;

} // namespace

VertexGrid::VertexGrid(const std::vector<Point2>& points, double reach, const Point2& stretch)
  : Points(points)
  , Reach(reach)
  , Stretch(stretch)
  , CellSize(CellSizeInReach * reach)
{
}

void VertexGrid::Update()
{
  if (this->Points.size() >= this->Heads.size())
  {
    this->Grow();
  }
  while (this->Nexts.size() < this->Points.size())
  {
    this->File(static_cast<Id>(this->Nexts.size()));
  }
}

void VertexGrid::Grow()
{
  std::size_t entries = LeastEntries;
  while (entries < 2 * this->Points.size())
  {
    entries *= 2;
  }
  this->Heads.assign(entries, NoId);
  this->Nexts.clear();
  this->Nexts.reserve(entries);
}

void VertexGrid::File(Id vertex)
{
  const Point2& p = this->Points[vertex];
  Id& head =
    this->Heads[this->EntryOf(std::floor(p.X / this->CellSize), std::floor(p.Y / this->CellSize))];
  this->Nexts.push_back(head);
  head = vertex;
}

Id VertexGrid::Find(const Point2& place) const
{
  const double lastColumn = std::floor((place.X + this->Reach) / this->CellSize);
  const double lastRow = std::floor((place.Y + this->Reach) / this->CellSize);
  Id nearest = NoId;
  double least = this->Reach;
  for (double row = std::floor((place.Y - this->Reach) / this->CellSize); row <= lastRow; ++row)
  {
    for (double column = std::floor((place.X - this->Reach) / this->CellSize); column <= lastColumn;
         ++column)
    {
      for (Id vertex = this->Heads[this->EntryOf(column, row)]; vertex != NoId;
           vertex = this->Nexts[vertex])
      {
        const Point2 gap = this->Points[vertex] - place;
        const double distance = Length(Point2{ this->Stretch.X * gap.X, this->Stretch.Y * gap.Y });
        const bool isTie = distance == least && (nearest == NoId || vertex < nearest);
        nearest = distance < least || isTie ? vertex : nearest;
        least = distance < least ? distance : least;
      }
    }
  }
  return nearest;
}

/// Columns and rows are below 2^47 in magnitude, as the reach is some ulp of the coordinates; cells
/// that share an entry cost time only.
std::size_t VertexGrid::EntryOf(double column, double row) const
{
  const auto x = static_cast<std::uint64_t>(static_cast<std::int64_t>(column));
  const auto y = static_cast<std::uint64_t>(static_cast<std::int64_t>(row));
  std::uint64_t key = (x ^ (y * 0xD6E8FEB86659FD93u)) * 0x9E3779B97F4A7C15u;
  key = (key ^ (key >> 32)) * 0xD6E8FEB86659FD93u;
  return static_cast<std::size_t>((key ^ (key >> 32)) & (this->Heads.size() - 1));
}

} // namespace biting
