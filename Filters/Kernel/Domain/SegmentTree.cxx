// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SegmentTree.h"

#include "Domain.h"

#include <cmath> // for abs

namespace biting
{

std::vector<SegmentTree::Item> SegmentTree::ItemsOf(const std::vector<Point2>& points,
  const std::vector<SegmentEnds>& segments, const Margins& margins)
{
  std::vector<Item> items;
  items.reserve(segments.size());
  for (const SegmentEnds& ends : segments)
  {
    const Point2& start = points[ends.Start];
    const Point2& end = points[ends.End];
    Box2 box = Box2::Around(start, end);
    box.Grow(margins.Of(std::abs(end.X - start.X) + std::abs(end.Y - start.Y)));
    items.push_back({ box, ends, static_cast<Id>(items.size()) });
  }
  return items;
}

std::vector<SegmentEnds> SegmentsAndPoints(const Domain& domain)
{
  std::vector<SegmentEnds> segments;
  segments.reserve(domain.Starts.size());
  for (Id segment = 0; segment < domain.NumberOfSegments(); ++segment)
  {
    segments.push_back({ domain.Starts[segment], domain.Ends[segment] });
  }
  for (Id vertex = 0; vertex < domain.NumberOfVertices(); ++vertex)
  {
    if (domain.IsEmbedded[vertex] != 0)
    {
      segments.push_back({ vertex, vertex });
    }
  }
  return segments;
}

} // namespace biting
