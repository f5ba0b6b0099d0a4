// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "TriangleLinks.h"

#include <algorithm> // for find_if, max, min, sort
#include <cstdint>   // for sorted numbers
#include <numeric>   // for partial_sum

namespace biting
{

namespace
{

// The edges of a point are sorted by the other end, then by the slot: both are one number.
using OtherEnd = std::uint64_t;

OtherEnd OtherEndOf(Id end, Id slot)
{
  return (static_cast<OtherEnd>(static_cast<std::uint32_t>(end)) << 32) |
    static_cast<std::uint32_t>(slot);
}

Id EndOf(OtherEnd other)
{
  return static_cast<Id>(other >> 32);
}

Id SlotOf(OtherEnd other)
{
  return static_cast<Id>(other & 0xffffffffu);
}

// Calls visit(slot, a, b) for all slots, with the ends of the edge opposite the slot's corner.
template <typename Visit>
void ForEachSlot(const std::vector<Id>& corners, const Visit& visit)
{
  for (std::size_t first = 0; first + 2 < corners.size(); first += 3)
  {
    const Id a = corners[first];
    const Id b = corners[first + 1];
    const Id c = corners[first + 2];
    const Id slot = static_cast<Id>(first);
    visit(slot, b, c);
    visit(slot + 1, c, a);
    visit(slot + 2, a, b);
  }
}

// Slots by the smaller end of their edge: those of point p are in Slots from Offsets[p] on.
struct SlotsByPoint
{
  std::vector<Id> Offsets;
  std::vector<Id> Slots;
};

SlotsByPoint Distribute(const std::vector<Id>& corners, Id numberOfPoints)
{
  SlotsByPoint result;
  std::vector<Id>& offsets = result.Offsets;
  offsets.assign(static_cast<std::size_t>(numberOfPoints) + 1, 0);
  result.Slots.resize(corners.size());
  ForEachSlot(
    corners, [&offsets](Id, Id a, Id b) { ++offsets[static_cast<std::size_t>(std::min(a, b))]; });
  std::partial_sum(offsets.begin(), offsets.end(), offsets.begin());
  ForEachSlot(corners,
    [&offsets, &result](Id slot, Id a, Id b)
    {
      const Id place = --offsets[static_cast<std::size_t>(std::min(a, b))];
      result.Slots[static_cast<std::size_t>(place)] = slot;
    });
  return result;
}

// Fills `edges` with the other ends of the edges whose smaller end is `point`, sorted.
void SortEdgesOf(const std::vector<Id>& corners, const SlotsByPoint& byPoint, std::size_t point,
  std::vector<OtherEnd>& edges)
{
  edges.clear();
  for (Id k = byPoint.Offsets[point]; k < byPoint.Offsets[point + 1]; ++k)
  {
    const Id slot = byPoint.Slots[static_cast<std::size_t>(k)];
    const Id corner = slot % 3;
    const Id a = corners[static_cast<std::size_t>(corner == 2 ? slot - 2 : slot + 1)];
    const Id b = corners[static_cast<std::size_t>(corner == 0 ? slot + 2 : slot - 1)];
    edges.push_back(OtherEndOf(std::max(a, b), slot));
  }
  std::sort(edges.begin(), edges.end());
}

// Links the slots of one edge, which are ascending.
void LinkEdge(const OtherEnd* begin, const OtherEnd* end, TriangleLinks& links)
{
  for (const OtherEnd* edge = begin; edge != end; ++edge)
  {
    const bool isLast = edge + 1 == end;
    const Id slot = SlotOf(*edge);
    const Id across = SlotOf(isLast ? *begin : edge[1]) / 3;
    const bool isAlone = isLast && across == slot / 3;
    links.Neighbors[static_cast<std::size_t>(slot)] = isAlone ? NoId : across;
  }
  if (end - begin > 2)
  {
    links.Crowded.push_back(SlotOf(*begin) / 3);
  }
}

} // namespace

TriangleLinks LinkTriangles(const std::vector<Id>& corners, Id numberOfPoints)
{
  TriangleLinks links;
  links.Neighbors.assign(corners.size(), NoId);
  const SlotsByPoint byPoint = Distribute(corners, numberOfPoints);
  std::vector<OtherEnd> edges;
  for (std::size_t point = 0; point + 1 < byPoint.Offsets.size(); ++point)
  {
    SortEdgesOf(corners, byPoint, point, edges);
    const OtherEnd* const end = edges.data() + edges.size();
    for (const OtherEnd* begin = edges.data(); begin != end;)
    {
      const Id other = EndOf(*begin);
      const OtherEnd* const next =
        std::find_if(begin, end, [other](OtherEnd edge) { return EndOf(edge) != other; });
      LinkEdge(begin, next, links);
      begin = next;
    }
  }
  return links;
}

} // namespace biting
