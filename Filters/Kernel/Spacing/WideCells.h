// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingWideCells_h
#define BitingWideCells_h

#include "../Base/Pulse.h"
#include "GridCells.h"
#include "NodeBound.h"

namespace biting
{

/// Cells across which f may grow by more than a share of itself: there interpolation between bounded
/// nodes is not enough. What the largest Lipschitz function below the interpolant grows from is then
/// given to cones: the sides of steep cells, and within them the lines along which the bilinear
/// interpolant is exactly as steep as the gradation; and the places that bound the nodes around.
class WideCells
{
public:
  /// The arguments must outlive it.
  WideCells(const GridCells& cells, const std::vector<NodeBound>& bounds, ConeCollector& cones,
    Pulse& pulse);

  /// False if the pulse stops.
  bool AddCones();

  /// Whether a node is of a wide cell: beside those, lowered nodes would say too little of where
  /// between them f is how low.
  bool IsNodeOf(Id column, Id row) const
  {
    return this->HasWide &&
      this->IsWideNode[static_cast<std::size_t>(this->Cells.Node(column, row))];
  }

private:
  void MarkNodes();

  bool IsWide(Id column, Id row) const;
  bool IsWideCell(Id column, Id row) const;
  bool IsWideAndSteep(Id column, Id row) const;
  bool IsNearWide(Id column, Id row) const
  {
    return this->IsNear[static_cast<std::size_t>(this->Cells.Node(column, row))];
  }
  void AddConesAt(Id column, Id row);
  void AddSide(Id startColumn, Id startRow, Id endColumn, Id endRow);
  void AddPlaces(Id column, Id row);
  void AddInside(Id column, Id row);

  const NodeBound& BoundOf(Id node) const { return this->Bounds[static_cast<std::size_t>(node)]; }

  const GridCells& Cells;
  const std::vector<NodeBound>& Bounds;
  ConeCollector& Cones;
  Pulse& Beats;
  std::vector<bool> Wide;       ///< of each cell
  std::vector<bool> IsWideNode; ///< whether it is of a wide cell
  std::vector<bool> IsNear;     ///< whether one beside it is
  bool HasWide = false;
};

} // namespace biting

#endif
