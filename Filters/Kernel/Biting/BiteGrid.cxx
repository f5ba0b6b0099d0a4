// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "BiteGrid.h"

#include "BiteOutline.h" // for Depth

#include <algorithm> // for max
#include <cmath>     // for sqrt
#include <limits>    // of counts

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
constexpr double MostCells = 3e7;  // 480 MB
// Measured: 2 to 7 cells a bite where they cover the bounds evenly, whatever the field, as the
// squares of their sizes then add up to the area. Where they crowd in a part of it, cells are too
// small.
constexpr double MostCellsPerBite = 16.0;
// In all, for each top cell: 6 cells where f varies twentyfold, seldom more than 1.1. To move them
// is cheap.
constexpr double CellsPerTopCell = 1.25;
constexpr double FilingMargin = 1e-6; // of the reach: more than rounding, less than a leaf

// Of entries: single precision, after the rounding of a place in units of a top cell.
constexpr double EntryMargin = 4e-6;
constexpr double PlaceRounding = 1e-15;

// How many cells of a grid are marked, from its low corner to each node.
class MarkedCells
{
public:
  MarkedCells(const std::vector<std::uint8_t>& isMarked, Id columns)
    : Stride(static_cast<std::size_t>(columns) + 1)
    , Sums(isMarked.size() + isMarked.size() / static_cast<std::size_t>(columns) + this->Stride, 0)
  {
    for (std::size_t cell = 0; cell < isMarked.size(); ++cell)
    {
      const std::size_t low = cell + cell / static_cast<std::size_t>(columns);
      const std::size_t high = low + this->Stride + 1;
      this->Sums[high] =
        isMarked[cell] + this->Sums[high - 1] + this->Sums[high - this->Stride] - this->Sums[low];
    }
  }

  bool HasAny() const { return this->Sums.back() > 0; }

  bool HasAny(Id firstColumn, Id firstRow, Id lastColumn, Id lastRow) const
  {
    const auto at = [this](Id column, Id row) { return this->Sums[row * this->Stride + column]; };
    return at(lastColumn + 1, lastRow + 1) - at(firstColumn, lastRow + 1) -
      at(lastColumn + 1, firstRow) + at(firstColumn, firstRow) >
      0;
  }

private:
  std::size_t Stride;
  std::vector<Id> Sums;
};

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
  this->Extents = { width, height };
  this->MostFiled = MostCellsPerBite * std::max(expectedBites, 1.0);
  this->Cells.reserve(static_cast<std::size_t>(CellsPerTopCell * cells));
  this->MakeCells(std::sqrt(cells / (width * height)));
}

void BiteGrid::MakeCells(double cellsPerLength)
{
  this->CellsPerLength = cellsPerLength;
  this->Columns = static_cast<Id>(this->Extents.X * cellsPerLength) + 1;
  this->Rows = static_cast<Id>(this->Extents.Y * cellsPerLength) + 1;
  this->Cells.assign(static_cast<std::size_t>(this->Columns) * this->Rows, Cell());
}

Id BiteGrid::BlockList::Add()
{
  if (static_cast<std::size_t>(this->Count) == ChunkSize * this->Chunks.size())
  {
    this->AddChunks();
  }
  return this->Count++;
}

void BiteGrid::BlockList::AddChunks()
{
  const std::size_t chunks = 1 + this->Chunks.size() / ShareAtOnce;
  // make_unique would fill it twice
  this->Allocated.emplace_back(new Block[chunks * ChunkSize]);
  for (std::size_t k = 0; k < chunks; ++k)
  {
    this->Chunks.push_back(this->Allocated.back().get() + k * ChunkSize);
  }
}

void BiteGrid::BlockList::Clear()
{
  std::vector<std::unique_ptr<Block[]>>().swap(this->Allocated);
  std::vector<Block*>().swap(this->Chunks);
  this->Count = 0;
}

void BiteGrid::Release(Pulse& pulse)
{
  this->Blocks.Clear();
  ReleaseInSteps(pulse, this->Cells);
}

void BiteGrid::Forget(Pulse& pulse)
{
  this->HasForgotten = true;
  this->Blocks.Clear();
  Cell forgotten;
  forgotten.FirstChild = Forgotten;
  std::vector<Cell>(static_cast<std::size_t>(this->Columns) * this->Rows, forgotten)
    .swap(this->Cells);
  pulse.Ask();
}

void BiteGrid::Recall(const std::vector<Box2>& boxes, Pulse& pulse)
{
  std::vector<std::uint8_t> isWanted(static_cast<std::size_t>(this->Columns) * this->Rows, 0);
  for (const Box2& box : boxes)
  {
    const double reach = 0.5 * std::max(box.Width(), box.Height());
    this->VisitTopCells(this->ToGrid(Midpoint(box.Low, box.High), reach),
      [&isWanted](Id, Id, Id cell) { isWanted[cell] = 1; });
  }
  this->RecallCells(isWanted, &pulse);
}

void BiteGrid::RecallAll()
{
  this->HasForgotten = false;
  const std::size_t count = static_cast<std::size_t>(this->Columns) * this->Rows;
  this->RecallCells(std::vector<std::uint8_t>(count, 1), nullptr);
}

// In the order of their filing.
void BiteGrid::RecallCells(const std::vector<std::uint8_t>& isWanted, Pulse* pulse)
{
  std::vector<std::uint8_t> isNew(isWanted.size(), 0);
  for (std::size_t cell = 0; cell < isWanted.size(); ++cell)
  {
    isNew[cell] = isWanted[cell] != 0 && this->Cells[cell].FirstChild == Forgotten ? 1 : 0;
    this->Cells[cell].FirstChild = isNew[cell] != 0 ? NoId : this->Cells[cell].FirstChild;
  }
  const MarkedCells areNew(isNew, this->Columns);
  const bool hasNew = areNew.HasAny();
  for (Id bite = 0; hasNew && bite <= this->Newest && (pulse == nullptr || pulse->Beat(1)); ++bite)
  {
    const LocalBox extent = this->ExtentOf(bite);
    if (!areNew.HasAny(ClampedIndex(extent.LowX, this->Columns),
          ClampedIndex(extent.LowY, this->Rows), ClampedIndex(extent.HighX, this->Columns),
          ClampedIndex(extent.HighY, this->Rows)))
    {
      continue;
    }
    const Filed filed = this->MakeFiled(bite);
    this->VisitTopCells(filed.Extent,
      [this, &filed, &isNew](Id column, Id row, Id cell)
      {
        if (isNew[cell] != 0)
        {
          this->FileInCell(
            cell, { static_cast<double>(column), static_cast<double>(row), 1.0 }, filed);
        }
      });
  }
}

void BiteGrid::File(Id bite)
{
  this->Newest = bite;
  this->FileInCells(bite);
  if (this->NumberOfFiled > std::max(this->MostFiled, MostCellsPerBite * (bite + 1.0)))
  {
    this->Coarsen(bite);
  }
}

// Twice as wide, the cells have about a quarter of the entries: O(1) amortised.
void BiteGrid::Coarsen(Id newest)
{
  this->MakeCells(0.5 * this->CellsPerLength);
  this->Blocks.Clear();
  this->NumberOfFiled = 0.0;
  for (Id bite = 0; bite <= newest; ++bite)
  {
    this->FileInCells(bite);
  }
}

void BiteGrid::FileInCells(Id bite)
{
  this->CircleAbout = this->All.IsCircle(bite) ? this->CircleAbout : 2.0f;
  const Filed filed = this->MakeFiled(bite);
  this->VisitTopCells(filed.Extent,
    [this, &filed](Id column, Id row, Id cell)
    {
      this->NumberOfFiled += 1.0;
      if (this->Cells[cell].FirstChild != Forgotten)
      {
        this->FileInCell(
          cell, { static_cast<double>(column), static_cast<double>(row), 1.0 }, filed);
      }
    });
}

// Calls visit(column, row, cell) for those that the box meets.
template <typename Visit>
void BiteGrid::VisitTopCells(const LocalBox& box, Visit&& visit) const
{
  const Id lastRow = ClampedIndex(box.HighY, this->Rows);
  const Id firstColumn = ClampedIndex(box.LowX, this->Columns);
  const Id lastColumn = ClampedIndex(box.HighX, this->Columns);
  for (Id row = ClampedIndex(box.LowY, this->Rows); row <= lastRow; ++row)
  {
    for (Id column = firstColumn; column <= lastColumn; ++column)
    {
      visit(column, row, row * this->Columns + column);
    }
  }
}

void BiteGrid::FileInCell(Id cell, const Place& place, const Filed& bite)
{
  if (this->Cells[cell].FirstChild != NoId)
  {
    this->FileInChildren(cell, place, bite);
    return;
  }
  this->Append(cell, place, bite);
  Cell& leaf = this->Cells[cell];
  const Id crowd = this->NearReach > 0.0 ? CrowdedWideLeaf : CrowdedLeaf;
  const bool isSmaller = place.Size > LeastLeaf * 0.5 * (bite.Extent.HighX - bite.Extent.LowX);
  std::uint16_t& count = isSmaller ? leaf.NumberOfSmaller : leaf.NumberOfLarger;
  count += count < std::numeric_limits<std::uint16_t>::max() ? 1 : 0;
  if (leaf.NumberOfSmaller > std::max(crowd, Id{ leaf.NumberOfLarger }))
  {
    this->Divide(cell, place);
  }
  else if (leaf.NumberOfSmaller + leaf.NumberOfLarger > crowd)
  {
    this->KeepDeepest(leaf, place, bite.Bite);
  }
}

void BiteGrid::KeepDeepest(Cell& leaf, const Place& place, Id bite)
{
  const double middle = 0.5 * place.Size;
  const Point2 offset{ place.X + middle, place.Y + middle };
  const Point2 p = this->Origin + 1.0 / this->CellsPerLength * offset;
  if (leaf.Deepest == NoId || Depth(this->All, leaf.Deepest, p) < Depth(this->All, bite, p))
  {
    leaf.Deepest = bite;
  }
}

void BiteGrid::FileInChildren(Id cell, const Place& place, const Filed& bite)
{
  const double scale = Division / place.Size;
  const Id firstChild = this->Cells[cell].FirstChild;
  const Id lastRow = ClampedIndex((bite.Extent.HighY - place.Y) * scale, Division);
  const Id firstColumn = ClampedIndex((bite.Extent.LowX - place.X) * scale, Division);
  const Id lastColumn = ClampedIndex((bite.Extent.HighX - place.X) * scale, Division);
  const double size = place.Size / Division;
  for (Id row = ClampedIndex((bite.Extent.LowY - place.Y) * scale, Division); row <= lastRow; ++row)
  {
    for (Id column = firstColumn; column <= lastColumn; ++column)
    {
      this->FileInCell(firstChild + row * Division + column,
        { place.X + column * size, place.Y + row * size, size }, bite);
    }
  }
}

void BiteGrid::Append(Id cell, const Place& place, const Filed& bite)
{
  Cell& leaf = this->Cells[cell];
  if (leaf.NewestBlock == NoId || this->Blocks[leaf.NewestBlock].Count == Block::Capacity)
  {
    const Id added = this->Blocks.Add();
    this->Blocks[added].Older = leaf.NewestBlock;
    leaf.NewestBlock = added;
  }
  Block& newest = this->Blocks[leaf.NewestBlock];
  newest.Entries[newest.Count++] = this->MakeEntry(place, bite);
}

BiteGrid::Entry BiteGrid::MakeEntry(const Place& place, const Filed& bite) const
{
  const double scale = 1.0 / place.Size; // a power of two
  const double rounding =
    EntryMargin + PlaceRounding * (static_cast<double>(this->Columns) + this->Rows) * scale;
  const double reach = bite.Reach * scale * (1.0 + EntryMargin) + rounding;
  return { static_cast<float>((bite.X - place.X) * scale),
    static_cast<float>((bite.Y - place.Y) * scale), static_cast<float>(reach * reach), bite.Bite };
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
    this->FileInChildren(cell, place, this->MakeFiled(*bite));
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

BiteGrid::LocalBox BiteGrid::ExtentOf(Id bite) const
{
  const double reach =
    this->Spread(bite) * this->All.HalfWidths[bite] * (1.0 + FilingMargin) + this->Slack;
  return this->ToGrid(this->All.Centers[bite], reach);
}

BiteGrid::Filed BiteGrid::MakeFiled(Id bite) const
{
  const Point2& center = this->All.Centers[bite];
  return { bite, (center.X - this->Origin.X) * this->CellsPerLength,
    (center.Y - this->Origin.Y) * this->CellsPerLength,
    (this->All.HalfWidths[bite] + this->Slack) * this->CellsPerLength, this->ExtentOf(bite) };
}

} // namespace biting
