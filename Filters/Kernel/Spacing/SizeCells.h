// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSizeCells_h
#define BitingSizeCells_h

#include "../Base/Pulse.h"
#include "CornerTable.h"
#include "Source.h"

namespace biting
{

/// The cells of a SizeTree while it is made: a cube that is cut again and again, with the corners
/// of all cells, and the low places in them.
template <std::size_t D>
class SizeCells
{
public:
  static constexpr int Children = 1 << D;
  static constexpr int MaximumLevel = CornerTable<D>::MaximumLevel;

  /// Coordinates from the low corner of the cube, whose side is 2^MaximumLevel.
  using Units = typename CornerTable<D>::Units;
  using Ids = std::array<Id, std::size_t(1) << D>;

  /// Around[o] is the leaf in orthant o, or a cell that it is part of. Bit d of an orthant is set
  /// where it is the upper one along axis d.
  struct Corner
  {
    Units At{};
    double Given = 0.0;
    double Size = 0.0; ///< f
    Id Origin = NoId;  ///< a place, or the complement of a corner
    bool IsInside = true;
    Ids Around{};
  };

  struct Cell
  {
    Units Low{};
    int Level = 0;
    Id FirstChild = 0; ///< 0: a leaf
    Id FirstPlace = 0;
    Id LastPlace = 0;
    Id Lowest = NoId; ///< of its places
    bool IsWaiting = false;
    bool MustBeCut = false;
    bool HasOffered = false;
    Ids Corners{};
  };

  /// One cell, the cube around a box and the places. Incomplete if the pulse stops.
  SizeCells(Point<D> low, Point<D> high, std::vector<LowPlace<D>> places, Pulse& pulse);

  const Corner& CornerAt(Id id) const { return this->Corners[static_cast<std::size_t>(id)]; }
  Corner& CornerAt(Id id) { return this->Corners[static_cast<std::size_t>(id)]; }
  const Cell& CellAt(Id id) const { return this->Cells[static_cast<std::size_t>(id)]; }
  Cell& CellAt(Id id) { return this->Cells[static_cast<std::size_t>(id)]; }

  std::uint32_t SideOf(const Cell& cell) const { return 1u << (MaximumLevel - cell.Level); }
  double SizeOf(const Cell& cell) const { return this->UnitLength * this->SideOf(cell); }

  Point<D> PlaceOf(const Units& units) const
  {
    Point<D> place;
    for (std::size_t d = 0; d < D; ++d)
    {
      place[d] = this->Low[d] + this->UnitLength * units[d];
    }
    return place;
  }
  Point<D> CenterOf(const Cell& cell) const
  {
    Units center = cell.Low;
    for (std::uint32_t& unit : center)
    {
      unit += this->SideOf(cell) / 2;
    }
    return this->PlaceOf(center);
  }
  LowPlace<D> OriginAt(Id origin) const
  {
    if (origin >= 0)
    {
      return this->Places[static_cast<std::size_t>(origin)];
    }
    const Corner& corner = this->CornerAt(~origin);
    return { this->PlaceOf(corner.At), corner.Given };
  }

  /// Returns the first of the children. The last corners are new: one for each of MadeFor.
  Id Cut(Id id);

  /// The leaf in an orthant of a corner; none beyond the cube.
  Id LeafAt(Id id, int orthant);

  Point<D> Low{};
  double Size = 0.0;
  std::vector<Cell> Cells; ///< the first one is the cube
  std::vector<Corner> Corners;
  std::vector<LowPlace<D>> Places; ///< along a Morton curve: so those of a cell are a range
  std::vector<Id> MadeFor; ///< the cells that were cut for the last corners, until it is cleared

private:
  void SortPlaces(Pulse& pulse);
  std::uint64_t MortonKey(const Point<D>& place) const;
  void DealPlaces(const Cell& parent, Id first);
  void FindLowest(Cell& cell) const;
  Id FindCorner(const Units& at, Id cell);

  double UnitLength = 0.0;
  std::vector<std::uint64_t> Keys; ///< of the places
  CornerTable<D> Table;
};

extern template class SizeCells<2>;
extern template class SizeCells<3>;

} // namespace biting

#endif
