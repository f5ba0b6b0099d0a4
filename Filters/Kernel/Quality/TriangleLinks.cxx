// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "TriangleLinks.h"

#include "../Base/TriangleSlots.h"

#include <algorithm> // for find_if, max, min, sort
#include <cstddef>   // for slots
#include <numeric>   // for partial_sum
#include <utility>   // for pairs

namespace biting
{

namespace
{

/// A slot by the larger end of its edge.
using EdgeSlot = std::pair<Id, Id>;

// Links the slots of one edge, which are ascending.
void LinkEdge(const EdgeSlot* begin, const EdgeSlot* end, TriangleLinks& links)
{
  for (const EdgeSlot* edge = begin; edge != end; ++edge)
  {
    const bool isLast = edge + 1 == end;
    const Id slot = edge->second;
    const Id across = (isLast ? *begin : edge[1]).second / 3;
    const bool isAlone = isLast && across == slot / 3;
    links.Neighbors[slot] = isAlone ? NoId : across;
  }
  if (end - begin > 2)
  {
    links.Crowded.push_back(begin->second / 3);
  }
}

} // namespace

// Edges are distributed to their smaller ends, by counting, and sorted there by the larger ones.
TriangleLinks LinkTriangles(const std::vector<Id>& corners, Id numberOfPoints)
{
  TriangleLinks links;
  links.Neighbors.assign(corners.size(), NoId);
  const auto endsOf = [&corners](std::size_t slot) {
    return std::minmax({ corners[NextSlotOf(slot)], corners[PreviousSlotOf(slot)] });
  };
  std::vector<Id> offsets(static_cast<std::size_t>(numberOfPoints) + 1, 0);
  for (std::size_t slot = 0; slot < corners.size(); ++slot)
  {
    ++offsets[endsOf(slot).first];
  }
  std::partial_sum(offsets.begin(), offsets.end(), offsets.begin());
  std::vector<EdgeSlot> edges(corners.size());
  for (std::size_t slot = 0; slot < corners.size(); ++slot)
  {
    const auto [smaller, larger] = endsOf(slot);
    const Id place = --offsets[smaller];
    edges[place] = { larger, static_cast<Id>(slot) };
  }
  for (std::size_t point = 0; point + 1 < offsets.size(); ++point)
  {
    const EdgeSlot* const end = edges.data() + offsets[point + 1];
    std::sort(edges.data() + offsets[point], edges.data() + offsets[point + 1]);
    for (const EdgeSlot* begin = edges.data() + offsets[point]; begin != end;)
    {
      const EdgeSlot* const next = std::find_if(
        begin, end, [begin](const EdgeSlot& edge) { return edge.first != begin->first; });
      LinkEdge(begin, next, links);
      begin = next;
    }
  }
  return links;
}

} // namespace biting
