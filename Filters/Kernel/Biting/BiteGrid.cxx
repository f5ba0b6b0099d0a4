// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "BiteGrid.h"

#include <algorithm> // for max
#include <cmath>     // for sqrt

namespace biting
{

namespace
{

// Measured, also where f varies twentyfold: 2 to 4; filed by near reach, 4.
constexpr double BitesPerCell = 3.0;
constexpr double BitesPerWideCell = 4.0;
// A leaf of two spacings holds 10 to 15 bites; filed by near reach, 20 to 30.
constexpr Id CrowdedLeaf = 40;
constexpr Id CrowdedWideLeaf = 64;
constexpr double LeastLeaf = 0.75; // of a bite's reach: a smaller leaf holds no fewer bites
constexpr double MostCells = 3e7;  // 360 MB
// Measured: 1 to 2 where bites are not crowded. Room that is not used costs nothing, but to move many
// blocks takes a second.
constexpr double BlocksPerCell = 2.5;
constexpr double FilingMargin = 1e-6; // of the reach: more than rounding, less than a leaf

// Of entries: single precision, after the rounding of a place in units of a top cell.
constexpr double EntryMargin = 4e-6;
constexpr double PlaceRounding = 1e-15;

} // namespace

BiteGrid::BiteGrid(
  const Bites& bites, const Box2& bounds, double expectedBites, double nearReach, double slack)
  : All(bites)
  , Origin(bounds.Low)
  , NearReach(nearReach)
  , Slack(slack)
{
  const double width = std::max(bounds.Width(), 1e-3 * bounds.Height());
  const double height = std::max(bounds.Height(), 1e-3 * bounds.Width());
  const double bitesPerCell = nearReach > 0.0 ? BitesPerWideCell : BitesPerCell;
  const double cells = std::min(std::max(expectedBites / bitesPerCell, 1.0), MostCells);
  this->CellsPerLength = std::sqrt(cells / (width * height));
  this->Columns = static_cast<Id>(width * this->CellsPerLength) + 1;
  this->Rows = static_cast<Id>(height * this->CellsPerLength) + 1;
  this->Cells.resize(static_cast<std::size_t>(this->Columns) * this->Rows);
  this->Blocks.reserve(
    static_cast<std::size_t>(BlocksPerCell * static_cast<double>(this->Cells.size())));
}

void BiteGrid::File(Id bite)
{
  this->CircleAbout = this->All.IsCircle(bite) ? this->CircleAbout : 2.0f;
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
  this->Append(cell, place, bite);
  const double reach = 0.5 * (extent.HighX - extent.LowX);
  const Id crowd = this->NearReach > 0.0 ? CrowdedWideLeaf : CrowdedLeaf;
  if (this->Cells[cell].Count > crowd && place.Size > LeastLeaf * reach)
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

void BiteGrid::Append(Id cell, const Place& place, Id bite)
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
  newest.Entries[newest.Count++] = this->MakeEntry(place, bite);
}

BiteGrid::Entry BiteGrid::MakeEntry(const Place& place, Id bite) const
{
  const Point2 center = this->All.Centers[bite];
  const double scale = this->CellsPerLength / place.Size;
  const double x = (center.X - this->Origin.X) * this->CellsPerLength;
  const double y = (center.Y - this->Origin.Y) * this->CellsPerLength;
  const double rounding =
    EntryMargin + PlaceRounding * (static_cast<double>(this->Columns) + this->Rows) / place.Size;
  const double reach =
    (this->All.HalfWidths[bite] + this->Slack) * scale * (1.0 + EntryMargin) + rounding;
  return { static_cast<float>((x - place.X) / place.Size),
    static_cast<float>((y - place.Y) / place.Size), static_cast<float>(reach * reach), bite };
}

// Deals the leaf's bites to its new children in the order of their filing.
void BiteGrid::Divide(Id cell, const Place& place)
{
  std::vector<Id> entries;
  this->VisitBlocks(this->Cells[cell],
    [&entries](const Entry& entry)
    {
      entries.push_back(entry.Bite);
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

// Of the bite's bounding box, or of its near reach where that is larger: half its width, in
// half-widths.
double BiteGrid::Spread(Id bite) const
{
  const Point2& axis = this->All.Axes[bite];
  const double spread = this->All.IsCircle(bite) ? 1.0 : std::abs(axis.X) + std::abs(axis.Y);
  return std::max(spread, this->NearReach);
}

BiteGrid::LocalBox BiteGrid::Extent(Id bite) const
{
  const double reach =
    this->Spread(bite) * this->All.HalfWidths[bite] * (1.0 + FilingMargin) + this->Slack;
  return this->ToGrid(this->All.Centers[bite], reach);
}

} // namespace biting
