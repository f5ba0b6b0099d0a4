// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "GridHoles.h"

#include "GridSweeps.h"

#include <algorithm> // for any_of

namespace biting
{
namespace
{

/// For each node the given one whose value it takes.
class HoleFiller
{
public:
  explicit HoleFiller(const GridSource& source)
    : Source(source)
    , Columns(source.XNodes.size())
    , Nearest(source.Values.size(), NoId)
  {
  }

  void Fill(std::vector<double>& values, Pulse& pulse)
  {
    GridSweeps sweeps(this->Columns, this->Source.YNodes.size());
    for (std::size_t node = 0; node < values.size(); ++node)
    {
      if (std::isnan(values[node]))
      {
        sweeps.Add(node % this->Columns, node / this->Columns);
      }
      else
      {
        this->Nearest[node] = static_cast<Id>(node);
      }
    }
    sweeps.Run(pulse,
      [this](std::size_t from, std::size_t to, std::size_t column, std::size_t row)
      {
        Id& nearest = this->Nearest[to];
        return nearest != static_cast<Id>(to) &&
          this->Offer(this->Nearest[from], nearest, { column, row });
      });
    for (std::size_t node = 0; node < values.size() && !pulse.HasStopped(); ++node)
    {
      values[node] = this->Source.Values[static_cast<std::size_t>(this->Nearest[node])];
    }
  }

private:
  struct Node
  {
    std::size_t Column;
    std::size_t Row;
  };

  bool Offer(Id offered, Id& nearest, const Node& node) const
  {
    const bool isNearer = offered != NoId && offered != nearest &&
      (nearest == NoId || this->Away(node, offered) < this->Away(node, nearest));
    nearest = isNearer ? offered : nearest;
    return isNearer;
  }

  double Away(const Node& node, Id given) const
  {
    const auto other = static_cast<std::size_t>(given);
    return Distance({ this->Source.XNodes[node.Column], this->Source.YNodes[node.Row] },
      { this->Source.XNodes[other % this->Columns], this->Source.YNodes[other / this->Columns] });
  }

  const GridSource& Source;
  const std::size_t Columns;
  std::vector<Id> Nearest; ///< NoId where none is known
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
  HoleFiller(*source).Fill(filled->Values, pulse);
  return pulse.HasStopped() ? nullptr : filled;
}

} // namespace biting
