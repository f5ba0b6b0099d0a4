// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "BiteFrame.h"

#include <algorithm> // for max
#include <cmath>     // for abs

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

} // namespace biting
