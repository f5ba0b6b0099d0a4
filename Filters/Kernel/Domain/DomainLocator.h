// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingDomainLocator_h
#define BitingDomainLocator_h

#include "../Base/Box.h"
#include "../Base/CellIndex.h"
#include "../Base/Ids.h"
#include "../Base/Point.h"
#include "../Base/Pulse.h"
#include "Domain.h"

#include <cstddef> // for size_t
#include <vector>  // for the arrays

namespace biting
{

/// Answers exactly whether a point lies inside a domain.
///
/// A grid over the domain whose crowded cells are divided again. A cell with boundary segments has
/// a reference point of known side; a query counts the boundary segments between that point and its
/// own. Queries cost O(1) away from the boundary and O(segments of one cell) near it. Made in
/// O(n log n), in memory for some ten entries a segment. The domain must outlive the locator.
class DomainLocator
{
public:
  /// Where the monitor wants to stop, the answers are of no use.
  DomainLocator(const Domain& domain, Pulse& pulse);

  /// True where p is inside; false outside and on the boundary itself.
  bool IsInside(const Point2& p) const;

  /// Calls visit(segment) for the boundary segments of all cells that `box` meets, until it returns
  /// true. A segment may come several times, and one that only passes nearby may come too.
  template <typename Visit>
  bool VisitSegments(const Box2& box, Visit&& visit) const;

  /// True only if no boundary segment meets `box` (false may also mean: not known).
  bool IsClear(const Box2& box) const
  {
    return !this->VisitSegments(box, [](Id) { return true; });
  }

private:
  struct Cell
  {
    Id FirstChild = NoId; ///< of Division x Division cells, row by row; or NoId for a leaf
    Id FirstSegment = 0;
    Id NumberOfSegments = 0;
    bool ReferenceIsInside = false;
    Point2 Reference;
  };

  void MakeGrid(Pulse& pulse);
  void FileSegments(Pulse& pulse);
  template <typename Visit>
  void VisitTopCells(Id segment, const Visit& visit);
  void SetReferences(Pulse& pulse);
  void CollectSegments(const Cell& a, const Cell& b, std::vector<Id>& segments) const;
  void Divide(Id cell, const Box2& box, int depth, Pulse& pulse);
  void MakeChild(Id child, const Box2& box, const Cell& parent);
  Point2 FreePoint(const Box2& box, const Cell& cell) const;
  Box2 TopBox(Id column, Id row) const;

  static constexpr Id Division = 4;

  template <typename Visit>
  bool VisitCells(Id firstCell, Id columns, Id rows, const CellBox& box, Visit&& visit) const;
  template <typename Visit>
  bool VisitCell(const Cell& cell, const CellBox& box, Visit&& visit) const;

  const Domain& Geometry;
  Point2 Origin;
  double CellSize = 1.0;
  Id Columns = 1;
  Id Rows = 1;
  std::vector<Cell> Cells;
  std::vector<Id> Segments;
  std::size_t MostEntries = 0; ///< of Segments, while a top cell is divided
};

template <typename Visit>
bool DomainLocator::VisitSegments(const Box2& box, Visit&& visit) const
{
  const CellBox local{ (box.Low.X - this->Origin.X) / this->CellSize,
    (box.Low.Y - this->Origin.Y) / this->CellSize, (box.High.X - this->Origin.X) / this->CellSize,
    (box.High.Y - this->Origin.Y) / this->CellSize };
  return this->VisitCells(0, this->Columns, this->Rows, local, visit);
}

template <typename Visit>
bool DomainLocator::VisitCells(
  Id firstCell, Id columns, Id rows, const CellBox& box, Visit&& visit) const
{
  return VisitCellsAt(box, columns, rows,
    [this, firstCell, columns, &box, &visit](Id column, Id row)
    {
      return this->VisitCell(
        this->Cells[firstCell + row * columns + column], box.From(column, row), visit);
    });
}

template <typename Visit>
bool DomainLocator::VisitCell(const Cell& cell, const CellBox& box, Visit&& visit) const
{
  if (cell.FirstChild != NoId)
  {
    return this->VisitCells(
      cell.FirstChild, Division, Division, box.Divided(Division, Division), visit);
  }
  for (Id k = 0; k < cell.NumberOfSegments; ++k)
  {
    if (visit(this->Segments[cell.FirstSegment + k]))
    {
      return true;
    }
  }
  return false;
}

} // namespace biting

#endif
