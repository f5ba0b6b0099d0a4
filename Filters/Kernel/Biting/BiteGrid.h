// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingBiteGrid_h
#define BitingBiteGrid_h

#include "../Base/Box.h"
#include "../Base/CellIndex.h"
#include "../Base/Ids.h"
#include "../Base/Point.h"
#include "../Base/Pulse.h"
#include "BiteLists.h"
#include "Bites.h"

#include <cstddef> // for sizes
#include <cstdint> // for counts
#include <vector>  // for the arrays

namespace biting
{

/// A bite in units of a grid's cells.
struct FramedBite
{
  Id Bite;
  double X, Y;    ///< its centre
  double Reach;   ///< half-width and slack
  CellBox Extent; ///< as far as it is filed
};

/// A cell's low corner, in units of a grid's cells.
struct CellPlace
{
  double X, Y;
};

/// A bite as cells of one size see it.
struct SizedBite
{
  double Size;    ///< of the cells, in units of those at the top: a power of two
  double PerSize; ///< its inverse
  float Square;   ///< of the bite's reach, in units of the cells
};

/// A grid of equal squares over a box, and how bites lie in it: how far each is filed, and what
/// stands of it in the list of a cell.
class BiteFrame
{
public:
  /// `nearReach`: how far from its centre a bite is filed at least, in half-widths. `slack`: how
  /// far outside of it, as a length.
  BiteFrame(const Bites& bites, const Box2& bounds, double nearReach, double slack);

  double Area() const { return this->Extents.X * this->Extents.Y; }
  void SetCellsPerLength(double cellsPerLength);
  double CellsPerLength() const { return this->Scale; }
  Id Columns() const { return this->NumberOfColumns; }
  Id Rows() const { return this->NumberOfRows; }
  std::size_t Size() const; ///< of the grid, in cells

  /// In units of a cell, from the low corner of the grid.
  Point2 ToGrid(const Point2& p) const
  {
    return { (p.X - this->Origin.X) * this->Scale, (p.Y - this->Origin.Y) * this->Scale };
  }

  /// The square about a point.
  CellBox ToGrid(const Point2& center, double reach) const
  {
    return { (center.X - reach - this->Origin.X) * this->Scale,
      (center.Y - reach - this->Origin.Y) * this->Scale,
      (center.X + reach - this->Origin.X) * this->Scale,
      (center.Y + reach - this->Origin.Y) * this->Scale };
  }

  CellBox ExtentOf(Id bite) const;
  FramedBite Framed(Id bite) const;
  SizedBite InCells(const FramedBite& bite, double size) const;

  /// What stands in the list of a leaf.
  static BiteEntry EntryOf(const FramedBite& bite, const SizedBite& sized, const CellPlace& leaf)
  {
    return { static_cast<float>((bite.X - leaf.X) * sized.PerSize),
      static_cast<float>((bite.Y - leaf.Y) * sized.PerSize), sized.Square, bite.Bite };
  }

  /// Calls visit(column, row, cell) for the cells that the box meets.
  template <typename Visit>
  void VisitCells(const CellBox& box, Visit&& visit) const
  {
    VisitCellsAt(box, this->NumberOfColumns, this->NumberOfRows,
      [this, &visit](Id column, Id row)
      {
        visit(column, row, row * this->NumberOfColumns + column);
        return false;
      });
  }

private:
  const Bites& All;
  Point2 Origin;
  Point2 Extents; ///< width and height
  double Scale = 1.0;
  Id NumberOfColumns = 1;
  Id NumberOfRows = 1;
  double NearReach; ///< in half-widths
  double Slack;     ///< a length
};

/// Where the bites are: each is filed in every leaf that its bounding box meets, so that all bites
/// that may contain a point, or meet its leaf, stand in one list.
///
/// Beside each bite stand its place and reach in units of the leaf, rounded: they tell most of
/// those that are out of reach without a look at the bites themselves.
/// A grid of about one cell per few bites; a crowded cell is divided into 2 x 2, again and again,
/// so leaves follow the spacing wherever it leads. Only bites smaller than the cell are a crowd,
/// and only where they outnumber the larger ones, which then stand in all its children. Filing
/// costs O(1) amortised, as does a query: bites have bounded overlap (paper, lemma 5.2). Those
/// about input vertices and segments that lie far closer than f have not: cells then grow with the
/// bites, and a bite still stands in a bounded number of lists.
class BiteGrid
{
public:
  /// Prepares a grid over `bounds` for about `expectedBites` bites. `bites` must outlive the grid.
  /// `nearReach`: how far from a bite's centre VisitNear is sure to find it, in half-widths.
  /// `slack`: how far outside of a bite, as a length, VisitLeaf still finds it.
  BiteGrid(const Bites& bites, const Box2& bounds, double expectedBites, double nearReach = 0.0,
    double slack = 0.0);

  /// Files `bite`. All bites are filed one after the other, in the order of their ids.
  void File(Id bite);

  /// Calls visit(bite) for the bites after `birth` of p's leaf that may contain p, newest first,
  /// until it returns true.
  template <typename Visit>
  bool VisitLeaf(const Point2& p, Visit&& visit, Id birth = NoId) const;

  /// Calls visit(bite) for bites whose centres are within `reach` of their half-widths from p, the
  /// newest first, until it returns true: all of them up to the near reach, beyond it those of p's
  /// leaf.
  template <typename Visit>
  bool VisitNear(const Point2& p, double reach, Visit&& visit) const;

  /// Calls visit(bite) for the bites of all leaves that the square meets, until it returns true; a
  /// bite may come twice.
  template <typename Visit>
  bool VisitSquare(const Point2& center, double reach, Visit&& visit) const;

  /// Gives the memory back; there is nothing to be asked for afterwards.
  void Release(Pulse& pulse);

private:
  static constexpr Id Division = 2;

  struct Cell
  {
    Id FirstChild = NoId;
    Id List = NoId;                    ///< of a leaf
    std::uint16_t NumberOfSmaller = 0; ///< bites smaller than the leaf, as far as can be counted
    std::uint16_t NumberOfLarger = 0;
  };

  // A place in a leaf, in its units.
  struct LeafPlace
  {
    const Cell* Leaf;
    float X, Y;
  };

  LeafPlace Locate(const Point2& p) const;
  template <typename Visit>
  bool VisitCell(const Cell& cell, const CellBox& box, Visit&& visit) const;
  void FileInCells(Id bite);
  void Coarsen(Id newest);
  void FileInCell(Id cell, const CellPlace& place, const FramedBite& bite, const SizedBite& sized);
  void FileInChildren(Id cell, const CellPlace& place, double size, const FramedBite& bite);
  void Divide(Id cell, const CellPlace& place, double size);

  const Bites& All;
  BiteFrame Frame;            ///< of the cells at the top
  double MostFiled = 0.0;     ///< what NumberOfFiled may be in any case
  double NumberOfFiled = 0.0; ///< bites in top cells, each as often as it is filed
  Id Crowd;                   ///< more bites than that divide a leaf
  float CircleAbout = 1.0f;   ///< squared radius of the circle about a bite, in squared half-widths
  std::vector<Cell> Cells;    ///< those at the top first
  BiteLists Lists;
};

inline BiteGrid::LeafPlace BiteGrid::Locate(const Point2& p) const
{
  const Point2 place = this->Frame.ToGrid(p);
  double u = place.X;
  double v = place.Y;
  Id column = ClampedIndex(u, this->Frame.Columns());
  Id row = ClampedIndex(v, this->Frame.Rows());
  const Cell* cell = &this->Cells[static_cast<std::size_t>(row) * this->Frame.Columns() + column];
  while (cell->FirstChild != NoId)
  {
    u = (u - column) * Division;
    v = (v - row) * Division;
    column = ClampedIndex(u, Division);
    row = ClampedIndex(v, Division);
    cell = &this->Cells[cell->FirstChild + row * Division + column];
  }
  return { cell, static_cast<float>(u - column), static_cast<float>(v - row) };
}

template <typename Visit>
bool BiteGrid::VisitLeaf(const Point2& p, Visit&& visit, Id birth) const
{
  const LeafPlace place = this->Locate(p);
  bool isFound = false;
  this->Lists.Visit(place.Leaf->List,
    [&place, birth, &visit, &isFound, reach = this->CircleAbout](const BiteEntry& entry)
    {
      const float x = entry.X - place.X;
      const float y = entry.Y - place.Y;
      const bool isOlder = entry.Bite <= birth;
      isFound = !isOlder && x * x + y * y <= reach * entry.Square && visit(entry.Bite);
      return isOlder || isFound;
    });
  return isFound;
}

template <typename Visit>
bool BiteGrid::VisitNear(const Point2& p, double reach, Visit&& visit) const
{
  const LeafPlace place = this->Locate(p);
  return this->Lists.Visit(place.Leaf->List,
    [&place, &visit, square = static_cast<float>(reach * reach)](const BiteEntry& entry)
    {
      const float x = entry.X - place.X;
      const float y = entry.Y - place.Y;
      return x * x + y * y <= square * entry.Square && visit(entry.Bite);
    });
}

template <typename Visit>
bool BiteGrid::VisitSquare(const Point2& center, double reach, Visit&& visit) const
{
  const CellBox box = this->Frame.ToGrid(center, reach);
  return VisitCellsAt(box, this->Frame.Columns(), this->Frame.Rows(),
    [this, &box, &visit](Id column, Id row)
    {
      const std::size_t cell = static_cast<std::size_t>(row) * this->Frame.Columns() + column;
      return this->VisitCell(this->Cells[cell], box.From(column, row), visit);
    });
}

template <typename Visit>
bool BiteGrid::VisitCell(const Cell& cell, const CellBox& box, Visit&& visit) const
{
  if (cell.FirstChild == NoId)
  {
    return this->Lists.Visit(
      cell.List, [&visit](const BiteEntry& entry) { return visit(entry.Bite); });
  }
  const CellBox inParts = box.Divided(Division, Division);
  return VisitCellsAt(inParts, Division, Division,
    [this, &cell, &inParts, &visit](Id column, Id row)
    {
      return this->VisitCell(
        this->Cells[cell.FirstChild + row * Division + column], inParts.From(column, row), visit);
    });
}

} // namespace biting

#endif
