// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "CellMask.h"

#include <cmath> // for sqrt

namespace biting
{

CellMask::CellMask(const std::vector<Point2>& points, std::size_t numberOfSuspects, Pulse& pulse)
  : Budget(static_cast<std::int64_t>(points.size() + 9 * numberOfSuspects))
{
  pulse.ForEach(points.size(), [this, &points](std::size_t i) { this->Bounds.Add(points[i]); });
  const double root = std::sqrt(static_cast<double>(points.size()));
  const double extent = std::max(this->Bounds.Width(), this->Bounds.Height());
  this->CellsPerLength = extent > 0.0 ? root / extent : 0.0;
  this->Columns += static_cast<std::int64_t>(this->Bounds.Width() * this->CellsPerLength);
  this->Rows += static_cast<std::int64_t>(this->Bounds.Height() * this->CellsPerLength);
  this->IsMarked.assign(static_cast<std::size_t>(this->Columns * this->Rows), 0);
}

void CellMask::Add(const Point2& center, double radius)
{
  const std::int64_t firstColumn = this->Column(center.X - radius);
  const std::int64_t lastColumn = this->Column(center.X + radius);
  const std::int64_t firstRow = this->Row(center.Y - radius);
  const std::int64_t lastRow = this->Row(center.Y + radius);
  this->Budget -= (lastColumn - firstColumn + 1) * (lastRow - firstRow + 1);
  for (std::int64_t row = firstRow; row <= lastRow && !this->IsFull(); ++row)
  {
    const auto begin = this->IsMarked.begin() + row * this->Columns;
    std::fill(begin + firstColumn, begin + lastColumn + 1, std::uint8_t{ 1 });
  }
}

} // namespace biting
