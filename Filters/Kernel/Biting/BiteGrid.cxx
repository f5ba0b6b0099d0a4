// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "BiteGrid.h"

#include <algorithm> // for max
#include <cmath>     // for abs
#include <limits>    // of counts

namespace biting
{

namespace
{

constexpr double FilingMargin = 1e-6; // of the reach: more than rounding, less than a leaf
constexpr double EntryMargin = 4e-6;  // single precision, after the rounding of a place
constexpr double PlaceRounding = 1e-15;

// Of the bite's bounding box, half its width, in half-widths.
double Spread(const Bites& bites, Id bite)
{
  const Point2& axis = bites.Axes[bite];
  return bites.IsCircle(bite) ? 1.0 : std::abs(axis.X) + std::abs(axis.Y);
}

// Measured, also where f varies twentyfold: 2 to 4; filed by near reach, 4: 4.5 takes 8 bytes a
// bite less, and 15 % more time where bites are crowded.
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
// is cheap; twice as many would be more than are needed.
constexpr double CellsPerTopCell = 1.1;
constexpr std::size_t CellsPerMore = 8;

} // namespace

BiteFrame::BiteFrame(const Bites& bites, const Box2& bounds, double nearReach, double slack)
  : All(bites)
  , Origin(bounds.Low)
  , Extents{ std::max(bounds.Width(), 1e-3 * bounds.Height()),
    std::max(bounds.Height(), 1e-3 * bounds.Width()) }
  , NearReach(nearReach)
  , Slack(slack)
{
}

void BiteFrame::SetCellsPerLength(double cellsPerLength)
{
  this->Scale = cellsPerLength;
  this->NumberOfColumns = static_cast<Id>(this->Extents.X * cellsPerLength) + 1;
  this->NumberOfRows = static_cast<Id>(this->Extents.Y * cellsPerLength) + 1;
}

std::size_t BiteFrame::Size() const
{
  return static_cast<std::size_t>(this->NumberOfColumns) * this->NumberOfRows;
}

// Its bounding box, or its near reach where that is larger.
CellBox BiteFrame::ExtentOf(Id bite) const
{
  const double spread = std::max(Spread(this->All, bite), this->NearReach);
  const double reach = spread * this->All.HalfWidths[bite] * (1.0 + FilingMargin) + this->Slack;
  return this->ToGrid(this->All.Centers[bite], reach);
}

FramedBite BiteFrame::Framed(Id bite) const
{
  const Point2 center = this->ToGrid(this->All.Centers[bite]);
  return { bite, center.X, center.Y, (this->All.HalfWidths[bite] + this->Slack) * this->Scale,
    this->ExtentOf(bite) };
}

SizedBite BiteFrame::InCells(const FramedBite& bite, double size) const
{
  const double perSize = 1.0 / size;
  const double extent = static_cast<double>(this->NumberOfColumns) + this->NumberOfRows;
  const double rounding = EntryMargin + PlaceRounding * extent * perSize;
  const double reach = bite.Reach * perSize * (1.0 + EntryMargin) + rounding;
  return { size, perSize, static_cast<float>(reach * reach) };
}

BiteGrid::BiteGrid(
  const Bites& bites, const Box2& bounds, double expectedBites, double nearReach, double slack)
  : All(bites)
  , Frame(bites, bounds, nearReach, slack)
  , MostFiled(MostCellsPerBite * std::max(expectedBites, 1.0))
  , Crowd(nearReach > 0.0 ? CrowdedWideLeaf : CrowdedLeaf)
{
  const double bitesPerCell = nearReach > 0.0 ? BitesPerWideCell : BitesPerCell;
  const double cells = std::min(std::max(expectedBites / bitesPerCell, 1.0), MostCells);
  this->Cells.reserve(static_cast<std::size_t>(CellsPerTopCell * cells));
  this->Frame.SetCellsPerLength(std::sqrt(cells / this->Frame.Area()));
  this->Cells.assign(this->Frame.Size(), Cell());
}

void BiteGrid::Release(Pulse& pulse)
{
  this->Lists = BiteLists();
  ReleaseInSteps(pulse, this->Cells);
}

void BiteGrid::File(Id bite)
{
  this->FileInCells(bite);
  if (this->NumberOfFiled > std::max(this->MostFiled, MostCellsPerBite * (bite + 1.0)))
  {
    this->Coarsen(bite);
  }
}

// Twice as wide, the cells have about a quarter of the entries: O(1) amortised.
void BiteGrid::Coarsen(Id newest)
{
  this->Frame.SetCellsPerLength(0.5 * this->Frame.CellsPerLength());
  this->Cells.assign(this->Frame.Size(), Cell());
  this->Lists = BiteLists();
  this->NumberOfFiled = 0.0;
  for (Id bite = 0; bite <= newest; ++bite)
  {
    this->FileInCells(bite);
  }
}

void BiteGrid::FileInCells(Id bite)
{
  this->CircleAbout = this->All.IsCircle(bite) ? this->CircleAbout : 2.0f;
  const FramedBite filed = this->Frame.Framed(bite);
  const SizedBite sized = this->Frame.InCells(filed, 1.0);
  this->Frame.VisitCells(filed.Extent,
    [this, &filed, &sized](Id column, Id row, Id cell)
    {
      this->NumberOfFiled += 1.0;
      this->FileInCell(
        cell, { static_cast<double>(column), static_cast<double>(row) }, filed, sized);
    });
}

void BiteGrid::FileInCell(
  Id cell, const CellPlace& place, const FramedBite& bite, const SizedBite& sized)
{
  Cell& leaf = this->Cells[cell];
  if (leaf.FirstChild != NoId)
  {
    this->FileInChildren(cell, place, sized.Size, bite);
    return;
  }
  this->Lists.Append(BiteFrame::EntryOf(bite, sized, place), leaf.List);
  const bool isSmaller = sized.Size > LeastLeaf * 0.5 * (bite.Extent.HighX - bite.Extent.LowX);
  std::uint16_t& count = isSmaller ? leaf.NumberOfSmaller : leaf.NumberOfLarger;
  count += count < std::numeric_limits<std::uint16_t>::max() ? 1 : 0;
  if (leaf.NumberOfSmaller > std::max(this->Crowd, Id{ leaf.NumberOfLarger }))
  {
    this->Divide(cell, place, sized.Size);
  }
}

void BiteGrid::FileInChildren(Id cell, const CellPlace& place, double size, const FramedBite& bite)
{
  const Id firstChild = this->Cells[cell].FirstChild;
  const SizedBite sized = this->Frame.InCells(bite, size / Division);
  const double scale = sized.PerSize;
  const CellBox inChildren{ (bite.Extent.LowX - place.X) * scale,
    (bite.Extent.LowY - place.Y) * scale, (bite.Extent.HighX - place.X) * scale,
    (bite.Extent.HighY - place.Y) * scale };
  VisitCellsAt(inChildren, Division, Division,
    [this, &place, &bite, &sized, firstChild](Id column, Id row)
    {
      this->FileInCell(firstChild + row * Division + column,
        { place.X + column * sized.Size, place.Y + row * sized.Size }, bite, sized);
      return false;
    });
}

// Deals the leaf's bites to its new children in the order of their filing.
void BiteGrid::Divide(Id cell, const CellPlace& place, double size)
{
  std::vector<Id> entries;
  this->Lists.Visit(this->Cells[cell].List,
    [&entries](const BiteEntry& entry)
    {
      entries.push_back(entry.Bite);
      return false;
    });
  this->Lists.Empty(this->Cells[cell].List);
  const Id firstChild = static_cast<Id>(this->Cells.size());
  const std::size_t cells = this->Cells.size() + static_cast<std::size_t>(Division) * Division;
  if (cells > this->Cells.capacity())
  {
    this->Cells.reserve(cells + cells / CellsPerMore);
  }
  this->Cells.resize(cells);
  this->Cells[cell].FirstChild = firstChild;
  for (auto bite = entries.rbegin(); bite != entries.rend(); ++bite)
  {
    this->FileInChildren(cell, place, size, this->Frame.Framed(*bite));
  }
}

} // namespace biting
