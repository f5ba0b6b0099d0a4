// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "GridHoles.h"

#include "../Base/Pulse.h"

#include <algorithm> // for any_of
#include <limits>    // for nodes that have no value yet
#include <numeric>   // for iota

namespace biting
{
namespace
{

/// The numbers of the nodes, the first and last one once more where they do not reach low and high.
std::vector<std::size_t> ReachingNodes(const std::vector<double>& nodes, double low, double high)
{
  std::vector<std::size_t> numbers(nodes.size());
  std::iota(numbers.begin(), numbers.end(), 0);
  numbers.insert(numbers.begin(), low < nodes.front() ? 1 : 0, 0);
  numbers.insert(numbers.end(), high > nodes.back() ? 1 : 0, nodes.size() - 1);
  return numbers;
}

/// Two sweeps over the rows, up and down; in each, holes are offered what their neighbors in the
/// row before have, and those on both sides.
void Fill(const GridSource& source, std::vector<double>& values, Pulse& pulse)
{
  const std::size_t columns = source.XNodes.size();
  const std::size_t rows = source.YNodes.size();
  constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
  std::vector<std::size_t> nearest(values.size(), none); // the given node whose value each takes
  for (std::size_t node = 0; node < values.size(); ++node)
  {
    nearest[node] = std::isnan(values[node]) ? none : node;
  }
  const auto away = [&source, columns](std::size_t node, std::size_t given)
  {
    return Distance(Point2{ source.XNodes[node % columns], source.YNodes[node / columns] },
      Point2{ source.XNodes[given % columns], source.YNodes[given / columns] });
  };
  const auto offer = [&nearest, &away](std::size_t from, std::size_t to)
  {
    const std::size_t offered = nearest[from];
    if (nearest[to] != to && offered != none && offered != nearest[to] &&
      (nearest[to] == none || away(to, offered) < away(to, nearest[to])))
    {
      nearest[to] = offered;
    }
  };
  const auto sweep = [&nearest, &offer, columns](std::size_t row, std::size_t before)
  {
    for (std::size_t column = 0; column < columns; ++column)
    {
      if (nearest[column + columns * row] == column + columns * row)
      {
        continue;
      }
      const std::size_t left = column > 0 ? column - 1 : column;
      const std::size_t right = std::min(column + 1, columns - 1);
      for (const std::size_t from : { left, column, right })
      {
        offer(from + columns * before, column + columns * row);
      }
      offer(left + columns * row, column + columns * row);
    }
    for (std::size_t column = columns - 1; column > 0; --column)
    {
      offer(column + columns * row, column - 1 + columns * row);
    }
  };
  for (std::size_t row = 0; row < rows && pulse.Beat(columns); ++row)
  {
    sweep(row, row > 0 ? row - 1 : row);
  }
  for (std::size_t row = rows - 1; row > 0 && pulse.Beat(columns); --row)
  {
    sweep(row - 1, row);
  }
  for (std::size_t node = 0; node < values.size() && !pulse.HasStopped(); ++node)
  {
    values[node] = source.Values[nearest[node]];
  }
}

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
  Fill(*source, filled->Values, pulse);
  return pulse.HasStopped() ? nullptr : filled;
}

std::shared_ptr<const GridSource> ReachingOver(
  const std::shared_ptr<const GridSource>& source, const Box2& bounds)
{
  const std::vector<double>& xs = source->XNodes;
  const std::vector<double>& ys = source->YNodes;
  const std::vector<std::size_t> columns = ReachingNodes(xs, bounds.Low.X, bounds.High.X);
  const std::vector<std::size_t> rows = ReachingNodes(ys, bounds.Low.Y, bounds.High.Y);
  if (columns.size() == xs.size() && rows.size() == ys.size())
  {
    return source;
  }
  auto reaching = std::make_shared<GridSource>();
  for (const std::size_t column : columns)
  {
    reaching->XNodes.push_back(xs[column]);
  }
  for (const std::size_t row : rows)
  {
    reaching->YNodes.push_back(ys[row]);
    for (const std::size_t column : columns)
    {
      reaching->Values.push_back(source->Values[column + row * xs.size()]);
    }
  }
  reaching->XNodes.front() = std::min(xs.front(), bounds.Low.X);
  reaching->XNodes.back() = std::max(xs.back(), bounds.High.X);
  reaching->YNodes.front() = std::min(ys.front(), bounds.Low.Y);
  reaching->YNodes.back() = std::max(ys.back(), bounds.High.Y);
  return reaching;
}

} // namespace biting
