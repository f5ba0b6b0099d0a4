// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SourceBorder.h"

#include "../Kernel/Base/SortInSteps.h"
#include "SourceOrder.h"

#include <cmath>      // for isnan
#include <cstddef>    // for size_t
#include <functional> // for less
#include <utility>    // for pair
#include <vector>     // for edges

namespace biting
{

namespace
{

using Edge = std::pair<Id, Id>;

std::vector<Edge> SortedEdges(const TriangulatedSource& source, Pulse& pulse)
{
  std::vector<Edge> edges;
  edges.reserve(source.Triangles.size());
  for (std::size_t k = 0; k + 2 < source.Triangles.size() && pulse.Beat(); k += 3)
  {
    const Id* corners = &source.Triangles[k];
    edges.emplace_back(corners[0], corners[1]);
    edges.emplace_back(corners[1], corners[2]);
    edges.emplace_back(corners[0], corners[2]);
  }
  SortInSteps(edges, std::less<>(), pulse);
  return edges;
}

void AddEdge(const TriangulatedSource& source, const Edge& edge, SegmentSource& segments)
{
  for (const Id end : { edge.first, edge.second })
  {
    segments.Segments.push_back(static_cast<Id>(segments.Points.size()));
    segments.Points.push_back(source.Points[static_cast<std::size_t>(end)]);
    segments.Values.push_back(source.Values[static_cast<std::size_t>(end)]);
  }
}

bool IsKnown(const TriangulatedSource& source, const Edge& edge)
{
  return !std::isnan(source.Values[static_cast<std::size_t>(edge.first)]) &&
    !std::isnan(source.Values[static_cast<std::size_t>(edge.second)]);
}

} // namespace

void AddBorderOf(const TriangulatedSource& source, SpacingOptions& options, Pulse& pulse)
{
  if (options.Gradation == 0.0)
  {
    return;
  }
  const std::vector<Edge> edges = SortedEdges(source, pulse);
  auto segments = options.Segments ? std::make_shared<SegmentSource>(*options.Segments)
                                   : std::make_shared<SegmentSource>();
  for (std::size_t k = 0; k < edges.size() && pulse.Beat(); ++k)
  {
    const bool isFirst = k == 0 || edges[k - 1] != edges[k];
    const bool isLast = k + 1 == edges.size() || edges[k + 1] != edges[k];
    if (isFirst && isLast && IsKnown(source, edges[k]))
    {
      AddEdge(source, edges[k], *segments);
    }
  }
  SortSource(*segments, pulse);
  options.Segments = segments;
}

} // namespace biting
