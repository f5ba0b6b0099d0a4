// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SurfaceLinks.h"

#include <algorithm> // for minmax, sort
#include <cstdint>   // for marks
#include <utility>   // for move, pair

namespace biting
{

namespace
{

std::pair<Id, Id> EndsOf(const SurfaceMesh& mesh, std::size_t slot)
{
  return std::minmax({ mesh.Corners[NextSlotOf(slot)], mesh.Corners[PreviousSlotOf(slot)] });
}

// An edge as it is seen from its lower vertex.
struct EdgeEnd
{
  Id High;
  Id Slot;

  bool operator<(const EdgeEnd& other) const
  {
    return this->High < other.High || (this->High == other.High && this->Slot < other.Slot);
  }
};

// The triangles that have the edges from `first` on, up to `last`, which are one edge.
void LinkEdge(const EdgeEnd* first, const EdgeEnd* last, SurfaceLinks& links)
{
  ++links.NumberOfEdges;
  if (last - first == 1)
  {
    ++links.NumberOfOpen;
  }
  else if (last - first == 2)
  {
    links.Across[static_cast<std::size_t>(first[0].Slot)] = first[1].Slot;
    links.Across[static_cast<std::size_t>(first[1].Slot)] = first[0].Slot;
  }
  else
  {
    for (const EdgeEnd* end = first; end != last; ++end)
    {
      links.Across[static_cast<std::size_t>(end->Slot)] = CrowdedEdge;
      links.CrowdedSlots.push_back(end->Slot);
    }
    links.CrowdedOffsets.push_back(static_cast<Id>(links.CrowdedSlots.size()));
  }
}

void Measure(const SurfaceMesh& mesh, BorderChain& chain)
{
  Point3 sum;
  for (std::size_t k = 0; k + 1 < chain.Vertices.size(); ++k)
  {
    sum = sum + mesh.Points[static_cast<std::size_t>(chain.Vertices[k])];
  }
  const Point3 middle = (1.0 / static_cast<double>(chain.Slots.size())) * sum;
  for (std::size_t k = 0; k + 1 < chain.Vertices.size(); ++k)
  {
    const Point3& a = mesh.Points[static_cast<std::size_t>(chain.Vertices[k])];
    const Point3& b = mesh.Points[static_cast<std::size_t>(chain.Vertices[k + 1])];
    chain.Length += Distance(a, b);
    chain.Area += 0.5 * Length(Cross(a - middle, b - middle));
  }
}

} // namespace

SurfaceLinks LinkSurface(const SurfaceMesh& mesh, Pulse& pulse)
{
  SurfaceLinks links;
  const std::size_t slots = mesh.Corners.size();
  links.Across.assign(slots, OpenEdge);
  std::vector<Id> offsets(mesh.Points.size() + 1, 0);
  pulse.ForEach(slots,
    [&mesh, &offsets](std::size_t slot)
    { ++offsets[static_cast<std::size_t>(EndsOf(mesh, slot).first) + 1]; });
  for (std::size_t k = 1; k < offsets.size(); ++k)
  {
    offsets[k] += offsets[k - 1];
  }
  std::vector<EdgeEnd> ends(slots);
  std::vector<Id> next(offsets.begin(), offsets.end() - 1);
  pulse.ForEach(slots,
    [&mesh, &ends, &next](std::size_t slot)
    {
      const auto edge = EndsOf(mesh, slot);
      Id& place = next[static_cast<std::size_t>(edge.first)];
      ends[static_cast<std::size_t>(place++)] = { edge.second, static_cast<Id>(slot) };
    });
  pulse.ForEach(mesh.Points.size(),
    [&ends, &offsets, &links](std::size_t vertex)
    {
      EdgeEnd* const end = ends.data() + offsets[vertex + 1];
      EdgeEnd* first = ends.data() + offsets[vertex];
      std::sort(first, end);
      while (first != end)
      {
        EdgeEnd* last = first;
        while (last != end && last->High == first->High)
        {
          ++last;
        }
        LinkEdge(first, last, links);
        first = last;
      }
    });
  return links;
}

bool AreAlike(const SurfaceMesh& mesh, const SurfaceLinks& links, std::size_t slot)
{
  const auto other = static_cast<std::size_t>(links.Across[slot]);
  return mesh.Corners[NextSlotOf(slot)] != mesh.Corners[NextSlotOf(other)];
}

std::vector<Id> PinchedVertices(const SurfaceMesh& mesh, const SurfaceLinks& links, Pulse& pulse)
{
  // 0: no fan was seen; 1: one; 2: several; 3: on a crowded edge.
  std::vector<std::uint8_t> fans(mesh.Points.size(), 0);
  for (const Id slot : links.CrowdedSlots)
  {
    const auto edge = EndsOf(mesh, static_cast<std::size_t>(slot));
    fans[static_cast<std::size_t>(edge.first)] = 3;
    fans[static_cast<std::size_t>(edge.second)] = 3;
  }
  std::vector<std::uint8_t> isSeen(mesh.Corners.size(), 0);
  std::vector<Id> pinched;
  pulse.ForEach(mesh.Corners.size(),
    [&mesh, &links, &fans, &isSeen, &pinched](std::size_t corner)
    {
      const Id vertex = mesh.Corners[corner];
      std::uint8_t& count = fans[static_cast<std::size_t>(vertex)];
      if (isSeen[corner] || count == 3)
      {
        return;
      }
      const auto mark = [&isSeen](std::size_t other) { isSeen[other] = 1; };
      // To one end of the fan, and from there through all of it.
      const Id end = WalkFan(mesh, links, vertex, static_cast<Id>(NextSlotOf(corner)), mark);
      if (end != NoId)
      {
        WalkFan(mesh, links, vertex, end, mark);
      }
      if (count == 1)
      {
        pinched.push_back(vertex);
      }
      count = count == 0 ? 1 : 2;
    });
  std::sort(pinched.begin(), pinched.end());
  return pinched;
}

std::vector<BorderChain> BorderChains(
  const SurfaceMesh& mesh, const SurfaceLinks& links, Pulse& pulse)
{
  std::vector<BorderChain> chains;
  std::vector<std::uint8_t> isSeen(mesh.Corners.size(), 0);
  const auto nothing = [](std::size_t) {};
  // Appends open edges behind `vertex`, an end of the open edge `slot`; returns whether the chain
  // comes back to an edge that was seen.
  const auto follow = [&](Id slot, Id vertex, BorderChain& chain)
  {
    while (links.Across[static_cast<std::size_t>(slot)] == OpenEdge &&
      !isSeen[static_cast<std::size_t>(slot)])
    {
      isSeen[static_cast<std::size_t>(slot)] = 1;
      chain.Slots.push_back(slot);
      chain.Vertices.push_back(vertex);
      const auto edge = EndsOf(mesh, static_cast<std::size_t>(slot));
      vertex = edge.first == vertex ? edge.second : edge.first;
      slot = WalkFan(mesh, links, vertex, slot, nothing);
    }
    chain.Vertices.push_back(vertex);
    return links.Across[static_cast<std::size_t>(slot)] == OpenEdge;
  };
  pulse.ForEach(mesh.Corners.size(),
    [&](std::size_t slot)
    {
      if (links.Across[slot] != OpenEdge || isSeen[slot])
      {
        return;
      }
      BorderChain chain;
      const auto edge = EndsOf(mesh, slot);
      chain.IsLoop = follow(static_cast<Id>(slot), edge.first, chain);
      if (!chain.IsLoop)
      {
        // The part before the first edge, which goes in front.
        BorderChain before;
        follow(
          WalkFan(mesh, links, edge.first, static_cast<Id>(slot), nothing), edge.first, before);
        std::reverse(before.Slots.begin(), before.Slots.end());
        std::reverse(before.Vertices.begin(), before.Vertices.end());
        chain.Slots.insert(chain.Slots.begin(), before.Slots.begin(), before.Slots.end());
        chain.Vertices.insert(
          chain.Vertices.begin(), before.Vertices.begin(), before.Vertices.end() - 1);
      }
      Measure(mesh, chain);
      chains.push_back(std::move(chain));
    });
  return chains;
}

} // namespace biting
