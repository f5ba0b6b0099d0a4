// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingGridSweeps_h
#define BitingGridSweeps_h

#include "../Base/Pulse.h"

#include <limits> // for stretches without nodes

namespace biting
{

/// Two sweeps over the nodes of a grid, in which each is offered what its neighbors have (vector
/// propagation, after Danielsson 1980). In each row only a stretch of nodes takes part, with one
/// more at each end, and with those that take what they are offered.
class GridSweeps
{
public:
  /// Of a row: the nodes First to End - 1.
  struct Stretch
  {
    std::size_t First = std::numeric_limits<std::size_t>::max();
    std::size_t End = 0;

    void Add(std::size_t column)
    {
      this->First = std::min(this->First, column);
      this->End = std::max(this->End, column + 1);
    }
  };

  GridSweeps(std::size_t columns, std::size_t rows)
    : Columns(columns)
    , Stretches(rows)
  {
  }

  /// The stretch of that row has this node.
  void Add(std::size_t column, std::size_t row) { this->Stretches[row].Add(column); }

  /// What takes part of two rows; none where First is not below End.
  Stretch OfRows(std::size_t row, std::size_t other) const
  {
    const Stretch& a = this->Stretches[row];
    const Stretch& b = this->Stretches[other];
    return { std::min(a.First, b.First), std::max(a.End, b.End) };
  }

  /// Calls offer(from, to, column, row) for neighbors, ids of nodes row by row, of which the other
  /// one is at that column and row: whether it takes what it is offered.
  template <typename Offer>
  void Run(Pulse& pulse, Offer offer)
  {
    const std::size_t rows = this->Stretches.size();
    for (std::size_t row = 0; row < rows && pulse.Beat(16 * this->Columns); ++row)
    {
      pulse.SetFraction(0.5 * static_cast<double>(row) / static_cast<double>(rows));
      this->SweepRow(row, row > 0 ? row - 1 : row, offer);
    }
    for (std::size_t row = rows; row-- > 0 && pulse.Beat(16 * this->Columns);)
    {
      pulse.SetFraction(1.0 - 0.5 * static_cast<double>(row) / static_cast<double>(rows));
      this->SweepRow(row, row + 1 < rows ? row + 1 : row, offer);
    }
  }

private:
  template <typename Offer>
  void SweepRow(std::size_t row, std::size_t beside, Offer& offer)
  {
    const Stretch near = this->OfRows(row, beside);
    if (near.First >= near.End)
    {
      return;
    }
    Stretch& own = this->Stretches[row];
    const std::size_t to = this->Columns * row;
    const std::size_t from = this->Columns * beside;
    std::size_t column = near.First > 0 ? near.First - 1 : 0;
    const std::size_t begin = column;
    for (; column < this->Columns && column <= std::max(near.End, own.End); ++column)
    {
      const std::size_t node = to + column;
      bool isTaken = column > 0 && offer(from + column - 1, node, column, row);
      isTaken = offer(from + column, node, column, row) || isTaken;
      isTaken =
        (column + 1 < this->Columns && offer(from + column + 1, node, column, row)) || isTaken;
      isTaken = (column > 0 && offer(node - 1, node, column, row)) || isTaken;
      if (isTaken)
      {
        own.Add(column);
      }
    }
    for (--column; column > 0 && (column > begin || column >= own.First); --column)
    {
      if (offer(to + column, to + column - 1, column - 1, row))
      {
        own.Add(column - 1);
      }
    }
  }

  std::size_t Columns;
  std::vector<Stretch> Stretches;
};

} // namespace biting

#endif
