// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingBiteGrid_h
#define BitingBiteGrid_h

#include "../Base/Box2.h"
#include "../Base/Ids.h"
#include "../Base/Point2.h"
#include "../Base/Pulse.h"
#include "Bites.h"

#include <cstddef> // for sizes
#include <cstdint> // for counts
#include <memory>  // for chunks of blocks
#include <vector>  // for the arrays

namespace biting
{

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

  /// Calls visit(bite) for the bites of p's leaf that may contain p, the newest first, until it
  /// returns true.
  template <typename Visit>
  bool VisitLeaf(const Point2& p, Visit&& visit) const;

  /// Of p's leaf where that is crowded: the bite that most likely contains p, as the middle of the
  /// leaf lies deep in it. NoId elsewhere.
  Id DeepestOfLeaf(const Point2& p) const { return this->Locate(p).Leaf->Deepest; }

  /// Calls visit(bite) for bites whose centres are within `reach` of their half-widths from p, the
  /// newest first, until it returns true: all of them up to the near reach, beyond it those of p's
  /// leaf.
  template <typename Visit>
  bool VisitNear(const Point2& p, double reach, Visit&& visit) const;

  /// Calls visit(bite) for the bites of all leaves that the square meets, until it returns true; a
  /// bite may come twice.
  template <typename Visit>
  bool VisitSquare(const Point2& center, double reach, Visit&& visit) const;

  /// Gives the memory back but for the cells at the top.
  void Forget(Pulse& pulse);

  /// Whether some of it may be forgotten.
  bool IsForgotten() const { return this->HasForgotten; }

  /// What was forgotten of the cells that meet one of the boxes: it takes a look at each bite.
  void Recall(const std::vector<Box2>& boxes, Pulse& pulse);
  void RecallAll();

  /// Gives the memory back; there is nothing to be asked for afterwards.
  void Release(Pulse& pulse);

private:
  static constexpr Id Division = 2;
  static constexpr Id Forgotten = -2; ///< in place of the first child

  struct Cell
  {
    Id FirstChild = NoId;
    Id NewestBlock = NoId;
    Id Deepest = NoId; ///< in a crowded leaf: the bite that the middle lies deepest in
    std::uint16_t NumberOfSmaller = 0; ///< bites smaller than the leaf, as far as can be counted
    std::uint16_t NumberOfLarger = 0;
  };

  // A bite as its leaf sees it, in units of the leaf.
  struct Entry
  {
    float X, Y;   ///< its centre, from the low corner
    float Square; ///< of its half-width
    Id Bite;
  };

  // Four cache lines.
  struct Block
  {
    static constexpr Id Capacity = 15;
    Id Older = NoId;
    Id Count = 0;
    Entry Entries[Capacity];
  };

  // In chunks: to move all blocks where there is no room for one more takes twice the memory.
  // Chunks are allocated several at once, the more the more there are: threads that allocate small
  // parts by the thousand wait for each other.
  class BlockList
  {
  public:
    Id Size() const { return this->Count; }
    Block& operator[](Id block) { return this->Chunks[block / ChunkSize][block % ChunkSize]; }
    const Block& operator[](Id block) const
    {
      return this->Chunks[block / ChunkSize][block % ChunkSize];
    }
    Id Add();
    void Clear();

  private:
    static constexpr Id ChunkSize = 64;
    static constexpr std::size_t ShareAtOnce = 16; ///< one of so many that there are

    void AddChunks();

    std::vector<std::unique_ptr<Block[]>> Allocated;
    std::vector<Block*> Chunks; ///< in what is allocated
    Id Count = 0;
  };

  // A place in a leaf, in its units.
  struct LeafPlace
  {
    const Cell* Leaf;
    float X, Y;
  };

  // A box in units of a cell, relative to its low corner.
  struct LocalBox
  {
    double LowX, LowY, HighX, HighY;
  };

  // A bite that is filed, in units of a top cell.
  struct Filed
  {
    Id Bite;
    double X, Y;     ///< its centre
    double Reach;    ///< half-width and slack
    LocalBox Extent; ///< as far as it is filed
  };

  static Id ClampedIndex(double position, Id count)
  {
    return position <= 0.0 ? 0 : (position >= count ? count - 1 : static_cast<Id>(position));
  }

  LocalBox ToGrid(const Point2& center, double reach) const
  {
    return { (center.X - reach - this->Origin.X) * this->CellsPerLength,
      (center.Y - reach - this->Origin.Y) * this->CellsPerLength,
      (center.X + reach - this->Origin.X) * this->CellsPerLength,
      (center.Y + reach - this->Origin.Y) * this->CellsPerLength };
  }

  template <typename Visit>
  bool VisitBlocks(const Cell& cell, Visit&& visit) const;
  LeafPlace Locate(const Point2& p) const;
  template <typename Visit>
  bool VisitCell(const Cell& cell, const LocalBox& box, Visit&& visit) const;
  // A cell's low corner and size, in units of a top cell.
  struct Place
  {
    double X, Y, Size;
  };

  void MakeCells(double cellsPerLength);
  void FileInCells(Id bite);
  template <typename Visit>
  void VisitTopCells(const LocalBox& box, Visit&& visit) const;
  void RecallCells(const std::vector<std::uint8_t>& isWanted, Pulse* pulse);
  void Coarsen(Id newest);
  double Spread(Id bite) const;
  LocalBox ExtentOf(Id bite) const;
  Filed MakeFiled(Id bite) const;
  void FileInCell(Id cell, const Place& place, const Filed& bite);
  void FileInChildren(Id cell, const Place& place, const Filed& bite);
  void Append(Id cell, const Place& place, const Filed& bite);
  void KeepDeepest(Cell& leaf, const Place& place, Id bite);
  Entry MakeEntry(const Place& place, const Filed& bite) const;
  void Divide(Id cell, const Place& place);

  const Bites& All;
  Point2 Origin;
  Point2 Extents;             ///< width and height
  double MostFiled = 0.0;     ///< what NumberOfFiled may be in any case
  double NumberOfFiled = 0.0; ///< bites in top cells, each as often as it is filed
  double CellsPerLength = 1.0;
  double NearReach;         ///< in half-widths
  double Slack;             ///< a length
  float CircleAbout = 1.0f; ///< squared radius of the circle about a bite, in squared half-widths
  Id Columns = 1;
  Id Rows = 1;
  Id Newest = NoId; ///< the last bite that was filed
  bool HasForgotten = false;
  std::vector<Cell> Cells;
  BlockList Blocks;
};

template <typename Visit>
bool BiteGrid::VisitBlocks(const Cell& cell, Visit&& visit) const
{
  for (Id block = cell.NewestBlock; block != NoId; block = this->Blocks[block].Older)
  {
    const Block& entries = this->Blocks[block];
    for (Id k = entries.Count; k-- > 0;)
    {
      if (visit(entries.Entries[k]))
      {
        return true;
      }
    }
  }
  return false;
}

inline BiteGrid::LeafPlace BiteGrid::Locate(const Point2& p) const
{
  double u = (p.X - this->Origin.X) * this->CellsPerLength;
  double v = (p.Y - this->Origin.Y) * this->CellsPerLength;
  Id column = ClampedIndex(u, this->Columns);
  Id row = ClampedIndex(v, this->Rows);
  const Cell* cell = &this->Cells[static_cast<std::size_t>(row) * this->Columns + column];
  while (cell->FirstChild != NoId)
  {
    if (cell->FirstChild == Forgotten)
    {
      const_cast<BiteGrid*>(this)->RecallAll(); // NOLINT: what it says is the same
      return this->Locate(p);
    }
    u = (u - column) * Division;
    v = (v - row) * Division;
    column = ClampedIndex(u, Division);
    row = ClampedIndex(v, Division);
    cell = &this->Cells[cell->FirstChild + row * Division + column];
  }
  return { cell, static_cast<float>(u - column), static_cast<float>(v - row) };
}

template <typename Visit>
bool BiteGrid::VisitLeaf(const Point2& p, Visit&& visit) const
{
  const LeafPlace place = this->Locate(p);
  return this->VisitBlocks(*place.Leaf,
    [&place, &visit, reach = this->CircleAbout](const Entry& entry)
    {
      const float x = entry.X - place.X;
      const float y = entry.Y - place.Y;
      return x * x + y * y <= reach * entry.Square && visit(entry.Bite);
    });
}

template <typename Visit>
bool BiteGrid::VisitNear(const Point2& p, double reach, Visit&& visit) const
{
  const LeafPlace place = this->Locate(p);
  return this->VisitBlocks(*place.Leaf,
    [&place, &visit, square = static_cast<float>(reach * reach)](const Entry& entry)
    {
      const float x = entry.X - place.X;
      const float y = entry.Y - place.Y;
      return x * x + y * y <= square * entry.Square && visit(entry.Bite);
    });
}

template <typename Visit>
bool BiteGrid::VisitSquare(const Point2& center, double reach, Visit&& visit) const
{
  const LocalBox box = this->ToGrid(center, reach);
  const Id lastRow = ClampedIndex(box.HighY, this->Rows);
  const Id lastColumn = ClampedIndex(box.HighX, this->Columns);
  for (Id row = ClampedIndex(box.LowY, this->Rows); row <= lastRow; ++row)
  {
    for (Id column = ClampedIndex(box.LowX, this->Columns); column <= lastColumn; ++column)
    {
      if (this->Cells[static_cast<std::size_t>(row) * this->Columns + column].FirstChild ==
        Forgotten)
      {
        const_cast<BiteGrid*>(this)->RecallAll(); // NOLINT: what it says is the same
      }
      const Cell& cell = this->Cells[static_cast<std::size_t>(row) * this->Columns + column];
      const LocalBox local{ box.LowX - column, box.LowY - row, box.HighX - column,
        box.HighY - row };
      if (this->VisitCell(cell, local, visit))
      {
        return true;
      }
    }
  }
  return false;
}

template <typename Visit>
bool BiteGrid::VisitCell(const Cell& cell, const LocalBox& box, Visit&& visit) const
{
  if (cell.FirstChild == NoId)
  {
    return this->VisitBlocks(cell, [&visit](const Entry& entry) { return visit(entry.Bite); });
  }
  const double lowX = box.LowX * Division;
  const double lowY = box.LowY * Division;
  const double highX = box.HighX * Division;
  const double highY = box.HighY * Division;
  const Id lastRow = ClampedIndex(highY, Division);
  const Id lastColumn = ClampedIndex(highX, Division);
  for (Id row = ClampedIndex(lowY, Division); row <= lastRow; ++row)
  {
    for (Id column = ClampedIndex(lowX, Division); column <= lastColumn; ++column)
    {
      if (this->VisitCell(this->Cells[cell.FirstChild + row * Division + column],
            { lowX - column, lowY - row, highX - column, highY - row }, visit))
      {
        return true;
      }
    }
  }
  return false;
}

} // namespace biting

#endif
