// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "BiteGrid.h"

#include <algorithm> // for max
#include <cmath>     // for sqrt

namespace biting
{

namespace
{

constexpr double BitesPerCell = 3.0;  // measured: 2 to 4 are equally fast
constexpr Id CrowdedLeaf = 40;        // a leaf of two spacings holds 10 to 15 bites
constexpr double LeastLeaf = 0.75;    // of a bite's reach: a smaller leaf holds no fewer bites
constexpr double MostCells = 3e7;     // 360 MB
constexpr double FilingMargin = 1e-6; // of the reach: more than rounding, less than a leaf

} // namespace

BiteGrid::BiteGrid(const Bites& bites, const Box2& bounds, double expectedBites)
  : Squares(bites)
  , Origin(bounds.Low)
{
  const double width = std::max(bounds.Width(), 1e-3 * bounds.Height());
  const double height = std::max(bounds.Height(), 1e-3 * bounds.Width());
  const double cells = std::min(std::max(expectedBites / BitesPerCell, 1.0), MostCells);
  this->CellsPerLength = std::sqrt(cells / (width * height));
  this->Columns = static_cast<Id>(width * this->CellsPerLength) + 1;
  this->Rows = static_cast<Id>(height * this->CellsPerLength) + 1;
  this->Cells.resize(static_cast<std::size_t>(this->Columns) * this->Rows);
  this->Blocks.reserve(this->Cells.size());
}

void BiteGrid::File(Id bite)
{
  const LocalBox extent = this->Extent(bite);
  const Id lastRow = ClampedIndex(extent.HighY, this->Rows);
  const Id lastColumn = ClampedIndex(extent.HighX, this->Columns);
  for (Id row = ClampedIndex(extent.LowY, this->Rows); row <= lastRow; ++row)
  {
    for (Id column = ClampedIndex(extent.LowX, this->Columns); column <= lastColumn; ++column)
    {
      this->FileInCell(row * this->Columns + column,
        { static_cast<double>(column), static_cast<double>(row), 1.0 }, bite, extent);
    }
  }
}

void BiteGrid::FileInCell(Id cell, const Place& place, Id bite, const LocalBox& extent)
{
  if (this->Cells[cell].FirstChild != NoId)
  {
    this->FileInChildren(cell, place, bite, extent);
    return;
  }
  this->Append(cell, bite);
  const double reach = 0.5 * (extent.HighX - extent.LowX);
  if (this->Cells[cell].Count > CrowdedLeaf && place.Size > LeastLeaf * reach)
  {
    this->Divide(cell, place);
  }
}

void BiteGrid::FileInChildren(Id cell, const Place& place, Id bite, const LocalBox& extent)
{
  const double scale = Division / place.Size;
  const Id firstChild = this->Cells[cell].FirstChild;
  const Id lastRow = ClampedIndex((extent.HighY - place.Y) * scale, Division);
  const Id firstColumn = ClampedIndex((extent.LowX - place.X) * scale, Division);
  const Id lastColumn = ClampedIndex((extent.HighX - place.X) * scale, Division);
  const double size = place.Size / Division;
  for (Id row = ClampedIndex((extent.LowY - place.Y) * scale, Division); row <= lastRow; ++row)
  {
    for (Id column = firstColumn; column <= lastColumn; ++column)
    {
      this->FileInCell(firstChild + row * Division + column,
        { place.X + column * size, place.Y + row * size, size }, bite, extent);
    }
  }
}

void BiteGrid::Append(Id cell, Id bite)
{
  Cell& leaf = this->Cells[cell];
  ++leaf.Count;
  if (leaf.NewestBlock == NoId || this->Blocks[leaf.NewestBlock].Count == Block::Capacity)
  {
    Block block;
    block.Older = leaf.NewestBlock;
    leaf.NewestBlock = static_cast<Id>(this->Blocks.size());
    this->Blocks.push_back(block);
  }
  Block& newest = this->Blocks[leaf.NewestBlock];
  newest.Entries[newest.Count++] = bite;
}

// Deals the leaf's bites to its new children in the order of their filing.
void BiteGrid::Divide(Id cell, const Place& place)
{
  std::vector<Id> entries;
  this->VisitBlocks(this->Cells[cell],
    [&entries](Id bite)
    {
      entries.push_back(bite);
      return false;
    });
  const Id firstChild = static_cast<Id>(this->Cells.size());
  this->Cells.resize(this->Cells.size() + static_cast<std::size_t>(Division) * Division);
  this->Cells[cell].FirstChild = firstChild;
  for (auto bite = entries.rbegin(); bite != entries.rend(); ++bite)
  {
    this->FileInChildren(cell, place, *bite, this->Extent(*bite));
  }
}

BiteGrid::LocalBox BiteGrid::Extent(Id bite) const
{
  const Point2& axis = this->Squares.Axes[bite];
  const double reach =
    this->Squares.HalfWidths[bite] * (std::abs(axis.X) + std::abs(axis.Y)) * (1.0 + FilingMargin);
  return this->ToGrid(this->Squares.Centers[bite], reach);
}

} // namespace biting
