// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "NearestQueries.h"

#include "../Base/Pulse.h"
#include "../Base/Tasks.h"
#include "CellMask.h"
#include "PointTree.h"

#include <algorithm> // for min
#include <cmath>     // for sqrt
#include <utility>   // for move

namespace biting
{

// The tree is over what lies in cells that the discs of the queries touch.
std::vector<double> NearestDistances(
  const std::vector<Point2>& points, const std::vector<NearestQuery>& queries, Monitor& monitor)
{
  Pulse pulse(monitor);
  if (points.empty())
  {
    std::vector<double> known;
    pulse.ForEach(
      queries.size(), [&queries, &known](std::size_t k) { known.push_back(queries[k].Distance); });
    return known;
  }
  CellMask cells(points, queries.size(), pulse);
  for (const NearestQuery& query : queries)
  {
    cells.Add(query.Place, query.Distance);
  }
  std::vector<PointTree::Item> items;
  pulse.ForEach(points.size(),
    [&points, &cells, &items](std::size_t i)
    {
      if (cells.IsFull() || cells.Contains(points[i]))
      {
        items.push_back({ points[i], static_cast<Id>(i) });
      }
    });
  const PointTree tree(std::move(items), pulse);
  std::vector<double> distances(queries.size());
  ForEachAtOnce(pulse, queries.size(),
    [&queries, &tree, &distances](std::size_t k)
    {
      // The square of a rounded root may be a little too small.
      const NearestQuery& query = queries[k];
      const double limit = query.Distance * query.Distance * (1.0 + 1e-12);
      const double square = tree.NearestSquaredDistance(query.Place, query.Vertex, limit);
      distances[k] = std::min(query.Distance, std::sqrt(square));
    });
  return pulse.HasStopped() ? std::vector<double>() : distances;
}

} // namespace biting
