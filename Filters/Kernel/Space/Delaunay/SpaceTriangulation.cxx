// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SpaceTriangulation.h"

#include "../../Base/Pulse.h"
#include "../../Delaunay/SpatialOrder.h"
#include "RegularTriangulation.h"

#include <algorithm> // for any_of
#include <utility>   // for move

namespace biting
{

namespace
{

constexpr double OrderEnd = 0.05; // as a share of the time

} // namespace

SpaceTriangulation TriangulateSpace(
  const std::vector<Point3>& points, const std::vector<double>& weights, Monitor& monitor)
{
  Pulse pulse(monitor);
  SpaceTriangulation result;
  std::vector<Id>& order = result.Order;
  {
    const PulsePart part(pulse, 0.0, OrderEnd);
    order = SpatialOrder(points, pulse);
  }
  const PulsePart part(pulse, OrderEnd, 1.0);
  const bool areWeighted =
    std::any_of(weights.begin(), weights.end(), [](double weight) { return weight != 0.0; });
  RegularTriangulation triangulation(areWeighted);
  triangulation.Reserve(points.size());
  std::size_t numberOfVertices = 0;
  for (std::size_t i = 0; i < order.size() && pulse.Beat(); ++i)
  {
    const Id id = order[i];
    const auto k = static_cast<std::size_t>(id);
    const PointInsertion insertion =
      triangulation.Insert(points[k], areWeighted ? weights[k] : 0.0);
    if (insertion.What == PointOutcome::Duplicate)
    {
      result.Duplicates.push_back({ id, order[static_cast<std::size_t>(insertion.Vertex)] });
    }
    else
    {
      order[numberOfVertices++] = id;
    }
    pulse.SetFraction(static_cast<double>(i) / static_cast<double>(order.size()));
  }
  result.WasAborted = pulse.HasStopped();
  result.Dimension = triangulation.Dimension();
  order.resize(numberOfVertices);
  const auto pointOf = [&order](Id vertex) { return order[static_cast<std::size_t>(vertex)]; };
  for (const LateDuplicate& late : triangulation.LateDuplicates())
  {
    result.Duplicates.push_back({ pointOf(late.Vertex), pointOf(late.Of) });
  }
  for (const Id vertex : triangulation.HiddenVertices())
  {
    result.Hidden.push_back(pointOf(vertex));
  }
  result.Mesh = triangulation.TakeMesh();
  return result;
}

} // namespace biting
