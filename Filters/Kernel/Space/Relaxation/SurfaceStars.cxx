// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SurfaceStars.h"

#include "../../Base/SortInSteps.h"

#include <algorithm>  // for min, max
#include <functional> // for less
#include <utility>    // for pairs

namespace biting
{

SurfaceStars::SurfaceStars(
  std::vector<Id>& corners, std::size_t points, const std::vector<Id>& keptEdges, Pulse& pulse)
  : Corners(corners)
  , Twins(corners.size(), NoId)
  , Slots(points, NoId)
  , Degrees(points, 0)
{
  using Ends = std::pair<Id, Id>;
  std::vector<std::pair<Ends, Id>> edges;
  edges.reserve(corners.size() + keptEdges.size() / 2);
  const auto add = [&edges](Id a, Id b, Id slot) {
    edges.push_back({ { std::min(a, b), std::max(a, b) }, slot });
  };
  for (std::size_t slot = 0; slot < corners.size(); ++slot)
  {
    add(corners[NextSlotOf(slot)], corners[PreviousSlotOf(slot)], static_cast<Id>(slot));
    const auto vertex = static_cast<std::size_t>(corners[slot]);
    this->Slots[vertex] = static_cast<Id>(slot);
    ++this->Degrees[vertex];
  }
  for (std::size_t k = 0; k < keptEdges.size(); k += 2)
  {
    add(keptEdges[k], keptEdges[k + 1], NoId);
  }
  SortInSteps(edges, std::less<>(), pulse);
  if (pulse.HasStopped())
  {
    return;
  }
  std::size_t end = 0;
  for (std::size_t begin = 0; begin < edges.size(); begin = end)
  {
    while (end < edges.size() && edges[end].first == edges[begin].first)
    {
      ++end;
    }
    if (end - begin == 2 && edges[begin].second != NoId)
    {
      this->Link(static_cast<std::size_t>(edges[begin].second), edges[begin + 1].second);
    }
  }
}

void SurfaceStars::Link(std::size_t slot, Id across)
{
  this->Twins[slot] = across;
  if (across != NoId)
  {
    this->Twins[static_cast<std::size_t>(across)] = static_cast<Id>(slot);
  }
}

// The triangles (a, b, c) and (d, c, b) become (a, b, d) and (d, c, a).
void SurfaceStars::Flip(std::size_t slot)
{
  const auto other = static_cast<std::size_t>(this->Twins[slot]);
  const std::size_t next = NextSlotOf(slot);
  const std::size_t otherNext = NextSlotOf(other);
  const Id acrossOther = this->Twins[otherNext];
  const Id acrossOwn = this->Twins[next];
  const Id a = this->Corners[slot];
  const Id d = this->Corners[other];
  const auto index = [](Id id) { return static_cast<std::size_t>(id); };
  --this->Degrees[index(this->Corners[next])];
  --this->Degrees[index(this->Corners[otherNext])];
  ++this->Degrees[index(a)];
  ++this->Degrees[index(d)];
  this->Corners[PreviousSlotOf(slot)] = d;
  this->Corners[PreviousSlotOf(other)] = a;
  this->Link(slot, acrossOther);
  this->Link(other, acrossOwn);
  this->Link(next, static_cast<Id>(otherNext));
  this->Slots[index(a)] = static_cast<Id>(slot);
  this->Slots[index(d)] = static_cast<Id>(other);
  this->Slots[index(this->Corners[next])] = static_cast<Id>(next);
  this->Slots[index(this->Corners[otherNext])] = static_cast<Id>(otherNext);
}

} // namespace biting
