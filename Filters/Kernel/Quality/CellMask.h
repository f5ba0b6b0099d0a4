// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingCellMask_h
#define BitingCellMask_h

#include "../Base/Box2.h"
#include "../Base/Point2.h"
#include "../Base/Pulse.h"

#include <algorithm> // for min
#include <cstddef>   // for counts
#include <cstdint>   // for flags
#include <vector>    // for the cells

namespace biting
{

/// Cells of a grid over points that the discs of the suspects touch.
class CellMask
{
public:
  CellMask(const std::vector<Point2>& points, std::size_t numberOfSuspects, Pulse& pulse);
  bool IsFull() const { return this->Budget < 0; }
  void Add(const Point2& center, double radius);
  bool Contains(const Point2& p) const
  {
    return this->IsMarked[static_cast<std::size_t>(
             this->Row(p.Y) * this->Columns + this->Column(p.X))] != 0;
  }

private:
  std::int64_t Column(double x) const
  {
    return ToCell((x - this->Bounds.Low.X) * this->CellsPerLength, this->Columns);
  }
  std::int64_t Row(double y) const
  {
    return ToCell((y - this->Bounds.Low.Y) * this->CellsPerLength, this->Rows);
  }
  static std::int64_t ToCell(double position, std::int64_t count)
  {
    const double last = static_cast<double>(count - 1);
    return position > 0.0 ? static_cast<std::int64_t>(std::min(position, last)) : 0;
  }

  Box2 Bounds;
  double CellsPerLength = 0.0;
  std::int64_t Columns = 1;
  std::int64_t Rows = 1;
  std::int64_t Budget; ///< cells that may still be marked: keeps the cost O(n) for any input
  std::vector<std::uint8_t> IsMarked;
};

} // namespace biting

#endif
