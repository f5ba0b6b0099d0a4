// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "GridHoles.h"

#include "GridSweeps.h"

#include <algorithm> // for any_of

namespace biting
{
namespace
{

void Fill(const GridSource& source, std::vector<double>& values, Pulse& pulse)
{
  const std::size_t columns = source.XNodes.size();
  GridSweeps sweeps(columns, source.YNodes.size());
  constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
  std::vector<std::size_t> nearest(values.size(), none); // the given node whose value each takes
  for (std::size_t node = 0; node < values.size(); ++node)
  {
    if (std::isnan(values[node]))
    {
      sweeps.Add(node % columns, node / columns);
    }
    else
    {
      nearest[node] = node;
    }
  }
  const auto away = [&source, columns](const Point2& place, std::size_t given) {
    return Distance(place, { source.XNodes[given % columns], source.YNodes[given / columns] });
  };
  sweeps.Run(pulse,
    [&](std::size_t from, std::size_t to, std::size_t column, std::size_t row)
    {
      const std::size_t offered = nearest[from];
      if (nearest[to] == to || offered == none || offered == nearest[to])
      {
        return false;
      }
      const Point2 place{ source.XNodes[column], source.YNodes[row] };
      const bool isNearer = nearest[to] == none || away(place, offered) < away(place, nearest[to]);
      nearest[to] = isNearer ? offered : nearest[to];
      return isNearer;
    });
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

} // namespace biting
