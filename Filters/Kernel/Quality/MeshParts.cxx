// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "MeshParts.h"

#include "../Base/DisjointSets.h"
#include "../Base/Tasks.h"
#include "../Base/TriangleSlots.h"

namespace biting
{

namespace
{

// The parts that tasks find, and what connects those of different tasks, for SumAtOnce.
struct ComponentSum
{
  struct Link
  {
    Id Part;
    Id Across; ///< a triangle of an earlier task
  };

  void Join(const ComponentSum& other)
  {
    const Id begin = static_cast<Id>(this->Components.Size());
    this->Begins.push_back(begin);
    this->Components.Append(other.Components);
    for (const Link& link : other.Links)
    {
      this->Links.push_back({ begin + link.Part, link.Across });
    }
  }

  DisjointSets Components;
  std::vector<Link> Links;
  std::vector<Id> Begins; ///< of the parts of each task that was joined
};

// Among the parts of its task. What lies across in an earlier one is kept for later.
Id PartOf(std::size_t triangle, const std::vector<Id>& neighbors, const std::vector<Id>& partOf,
  ComponentSum& sum)
{
  const Id begin = static_cast<Id>(triangle - triangle % StepsPerTask);
  const Id* across = neighbors.data() + 3 * triangle;
  Id part = NoId;
  bool hasEarlier = false;
  for (int corner = 0; corner < 3; ++corner)
  {
    const Id neighbor = across[corner];
    if (neighbor >= begin && neighbor < static_cast<Id>(triangle))
    {
      const Id other = partOf[static_cast<std::size_t>(neighbor)];
      part = part == NoId ? sum.Components.SetOf(other)
        : part == other   ? part
                          : sum.Components.Unite(part, other);
    }
    hasEarlier |= neighbor != NoId && neighbor < begin;
  }
  part = part == NoId ? sum.Components.Add() : part;
  for (int corner = 0; hasEarlier && corner < 3; ++corner)
  {
    if (across[corner] != NoId && across[corner] < begin)
    {
      sum.Links.push_back({ part, across[corner] });
    }
  }
  return part;
}

// Turns about the end of the boundary edge, through its fan of triangles, to the other boundary
// edge of the fan. Neighbors are mutual, so the turn cannot come to a triangle again.
std::size_t NextOnBoundary(
  std::size_t slot, const std::vector<Id>& corners, const std::vector<Id>& neighbors)
{
  std::size_t leaving = NextSlotOf(slot);
  while (neighbors[leaving] != NoId)
  {
    leaving = NextSlotOf(SlotAcross(corners, leaving, neighbors[leaving]));
  }
  return leaving;
}

} // namespace

// Each triangle takes the part of a neighbor before it, or begins a part where there is none; where
// it has neighbors of different parts, these are one. There are few parts, so joining costs little.
// Each task does so with its triangles; then the parts of different tasks are joined.
std::int64_t CountComponents(const std::vector<Id>& neighbors, Pulse& pulse)
{
  std::vector<Id> partOf(neighbors.size() / 3, NoId);
  ComponentSum sum = SumAtOnce(pulse, partOf.size(), ComponentSum(),
    [&neighbors, &partOf](ComponentSum& own, std::size_t triangle)
    { partOf[triangle] = PartOf(triangle, neighbors, partOf, own); });
  if (pulse.HasStopped())
  {
    return 0;
  }
  for (const ComponentSum::Link& link : sum.Links)
  {
    const std::size_t across = static_cast<std::size_t>(link.Across);
    sum.Components.Unite(link.Part, sum.Begins[across / StepsPerTask] + partOf[across]);
  }
  return static_cast<std::int64_t>(sum.Components.NumberOfSets());
}

std::int64_t CountBoundaryLoops(const std::vector<Id>& corners, const std::vector<Id>& neighbors,
  const std::vector<std::size_t>& boundarySlots, Pulse& pulse)
{
  std::vector<bool> isTraced(neighbors.size(), false);
  std::int64_t count = 0;
  for (const std::size_t start : boundarySlots)
  {
    count += isTraced[start] ? 0 : 1;
    for (std::size_t slot = start; !isTraced[slot] && pulse.Beat();
         slot = NextOnBoundary(slot, corners, neighbors))
    {
      isTraced[slot] = true;
    }
  }
  return count;
}

} // namespace biting
