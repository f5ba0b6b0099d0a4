// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "TriangleLinks.h"

#include <algorithm> // for minmax, sort
#include <utility>   // for pairs

namespace biting
{

namespace
{

using Ends = std::pair<Id, Id>;

// The ends of the edge opposite a slot's corner, the smaller id first.
Ends EndsOf(const std::vector<Id>& corners, Id slot)
{
  const Id first = slot / 3 * 3;
  const Id a = corners[static_cast<std::size_t>(first + (slot + 1) % 3)];
  const Id b = corners[static_cast<std::size_t>(first + (slot + 2) % 3)];
  return std::minmax(a, b);
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
  result.Offsets.assign(static_cast<std::size_t>(numberOfPoints) + 1, 0);
  result.Slots.resize(corners.size());
  const auto offset = [&corners, &result](Id slot) -> Id&
  { return result.Offsets[static_cast<std::size_t>(EndsOf(corners, slot).first)]; };
  const Id numberOfSlots = static_cast<Id>(corners.size());
  for (Id slot = 0; slot < numberOfSlots; ++slot)
  {
    ++offset(slot);
  }
  Id sum = 0;
  for (Id& entry : result.Offsets)
  {
    sum += entry;
    entry = sum;
  }
  for (Id slot = numberOfSlots; slot-- > 0;)
  {
    result.Slots[static_cast<std::size_t>(--offset(slot))] = slot;
  }
  return result;
}

// Links the slots of one edge, which are ascending.
void LinkEdge(const Id* begin, const Id* end, TriangleLinks& links)
{
  for (const Id* slot = begin; slot != end; ++slot)
  {
    const bool isLast = slot + 1 == end;
    const Id across = (isLast ? *begin : slot[1]) / 3;
    const bool isAlone = isLast && across == *slot / 3;
    links.Neighbors[static_cast<std::size_t>(*slot)] = isAlone ? NoId : across;
  }
  if (end - begin > 2)
  {
    links.Crowded.push_back(*begin / 3);
  }
}

} // namespace

TriangleLinks LinkTriangles(const std::vector<Id>& corners, Id numberOfPoints)
{
  TriangleLinks links;
  links.Neighbors.assign(corners.size(), NoId);
  SlotsByPoint byPoint = Distribute(corners, numberOfPoints);
  const auto isBefore = [&corners](Id a, Id b)
  { return std::make_pair(EndsOf(corners, a), a) < std::make_pair(EndsOf(corners, b), b); };
  for (std::size_t point = 0; point + 1 < byPoint.Offsets.size(); ++point)
  {
    Id* const end = byPoint.Slots.data() + byPoint.Offsets[point + 1];
    Id* begin = byPoint.Slots.data() + byPoint.Offsets[point];
    std::sort(begin, end, isBefore);
    while (begin != end)
    {
      const Ends ends = EndsOf(corners, *begin);
      const Id* next = std::find_if(
        begin, end, [&corners, &ends](Id slot) { return EndsOf(corners, slot) != ends; });
      LinkEdge(begin, next, links);
      begin += next - begin;
    }
  }
  return links;
}

} // namespace biting
