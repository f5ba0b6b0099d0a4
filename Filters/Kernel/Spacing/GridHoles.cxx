// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "GridHoles.h"

#include "../Base/Pulse.h"

#include <algorithm> // for any_of

namespace biting
{
namespace
{

/// Nodes hand on to their neighbors the node whose value they take, in two sweeps.
class HoleFiller
{
public:
  HoleFiller(const GridSource& source, Pulse& pulse)
    : Source(source)
    , Beats(pulse)
    , Columns(static_cast<Id>(source.XNodes.size()))
    , Rows(static_cast<Id>(source.YNodes.size()))
    , Nearest(source.Values.size(), NoId)
  {
  }

  bool Fill(std::vector<double>& values)
  {
    for (Id node = 0; node < static_cast<Id>(values.size()); ++node)
    {
      this->Nearest[static_cast<std::size_t>(node)] =
        std::isnan(values[static_cast<std::size_t>(node)]) ? NoId : node;
    }
    for (Id row = 0; row < this->Rows && this->SweepRow(row, row - 1); ++row)
    {
    }
    for (Id row = this->Rows - 1; row >= 0 && this->SweepRow(row, row + 1); --row)
    {
    }
    for (std::size_t node = 0; node < values.size() && !this->Beats.HasStopped(); ++node)
    {
      values[node] = this->Source.Values[static_cast<std::size_t>(this->Nearest[node])];
    }
    return !this->Beats.HasStopped();
  }

private:
  bool SweepRow(Id row, Id from)
  {
    const bool hasFrom = from >= 0 && from < this->Rows;
    for (Id column = 0; column < this->Columns; ++column)
    {
      for (Id side = -1; hasFrom && side <= 1; ++side)
      {
        this->Adopt(column, row, column + side, from);
      }
      this->Adopt(column, row, column - 1, row);
    }
    for (Id column = this->Columns - 2; column >= 0; --column)
    {
      this->Adopt(column, row, column + 1, row);
    }
    return this->Beats.Beat(4 * static_cast<std::size_t>(this->Columns));
  }

  void Adopt(Id column, Id row, Id fromColumn, Id fromRow)
  {
    Id& nearest = this->Nearest[static_cast<std::size_t>(column + this->Columns * row)];
    if (fromColumn < 0 || fromColumn >= this->Columns || nearest == column + this->Columns * row)
    {
      return;
    }
    const Id offered =
      this->Nearest[static_cast<std::size_t>(fromColumn + this->Columns * fromRow)];
    const bool isNearer = offered != NoId && offered != nearest &&
      (nearest == NoId || this->Away(column, row, offered) < this->Away(column, row, nearest));
    nearest = isNearer ? offered : nearest;
  }

  double Away(Id column, Id row, Id node) const
  {
    return Distance(
      this->Place(column, row), this->Place(node % this->Columns, node / this->Columns));
  }

  Point2 Place(Id column, Id row) const
  {
    return { this->Source.XNodes[static_cast<std::size_t>(column)],
      this->Source.YNodes[static_cast<std::size_t>(row)] };
  }

  const GridSource& Source;
  Pulse& Beats;
  const Id Columns;
  const Id Rows;
  std::vector<Id> Nearest; ///< of each node, the given one; NoId where none is known
};

} // namespace

std::shared_ptr<const GridSource> FillHoles(
  std::shared_ptr<const GridSource> source, Monitor& monitor)
{
  const bool hasHoles = std::any_of(
    source->Values.begin(), source->Values.end(), [](double value) { return std::isnan(value); });
  if (!hasHoles)
  {
    return source;
  }
  auto filled = std::make_shared<GridSource>(*source);
  Pulse pulse(monitor);
  return HoleFiller(*source, pulse).Fill(filled->Values) ? filled : nullptr;
}

} // namespace biting
