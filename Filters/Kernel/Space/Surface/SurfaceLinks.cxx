// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SurfaceLinks.h"

#include "../../Base/Numbers.h"

#include <algorithm> // for any_of, max, sort
#include <cstdint>   // for marks
#include <utility>   // for move, pair

namespace biting
{

namespace
{

// An edge as it is seen from its lower vertex: the higher one, and the slot.
using EdgeEnd = std::pair<Id, Id>;

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
    links.Across[static_cast<std::size_t>(first[0].second)] = first[1].second;
    links.Across[static_cast<std::size_t>(first[1].second)] = first[0].second;
  }
  else
  {
    for (const EdgeEnd* end = first; end != last; ++end)
    {
      links.Across[static_cast<std::size_t>(end->second)] = CrowdedEdge;
      links.CrowdedSlots.push_back(end->second);
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

// Follows open edges.
class BorderWalk
{
public:
  BorderWalk(const SurfaceMesh& mesh, const SurfaceLinks& links)
    : Mesh(mesh)
    , Links(links)
    , SlotsAt(mesh.Points.size(),
        [&mesh, &links](const auto& add)
        {
          for (std::size_t slot = 0; slot < mesh.Corners.size(); ++slot)
          {
            if (links.Across[slot] == OpenEdge)
            {
              add(mesh.Corners[NextSlotOf(slot)], static_cast<Id>(slot));
              add(mesh.Corners[PreviousSlotOf(slot)], static_cast<Id>(slot));
            }
          }
        })
    , IsSeen(mesh.Corners.size(), 0)
    , PlaceOf(mesh.Points.size(), NoId)
  {
  }

  std::vector<BorderChain> Run(Pulse& pulse)
  {
    for (const bool isLoop : { false, true })
    {
      pulse.ForEach(this->Mesh.Corners.size(),
        [this, isLoop](std::size_t slot)
        {
          const auto ends = EndsOf(this->Mesh, slot);
          for (const Id vertex : { ends.first, ends.second })
          {
            const Id begin = static_cast<Id>(slot);
            if (this->IsLeft(begin) && (isLoop || this->IsOpen(begin, vertex)))
            {
              this->Follow(begin, vertex);
            }
          }
        });
    }
    return std::move(this->Chains);
  }

private:
  bool IsLeft(Id slot) const
  {
    return this->Links.Across[At(slot)] == OpenEdge && this->IsSeen[At(slot)] == 0;
  }

  Id EndOfFan(Id slot, Id vertex) const
  {
    return WalkFan(this->Mesh, this->Links, vertex, slot, [](std::size_t) {});
  }

  // Whether the border ends at the vertex, an end of the open edge `slot`.
  bool IsOpen(Id slot, Id vertex) const
  {
    return this->Links.Across[At(this->EndOfFan(slot, vertex))] == CrowdedEdge;
  }

  Id OtherEnd(Id slot, Id vertex) const
  {
    const auto ends = EndsOf(this->Mesh, At(slot));
    return ends.first == vertex ? ends.second : ends.first;
  }

  // The edge behind `vertex`, where the open edge `slot` ends; NoId where the border does.
  Id Next(Id slot, Id vertex) const
  {
    const Id own = this->EndOfFan(slot, vertex);
    const auto wayOf = [this, vertex](Id of)
    {
      const Point3 way =
        this->Mesh.Points[At(this->OtherEnd(of, vertex))] - this->Mesh.Points[At(vertex)];
      return (1.0 / Length(way)) * way;
    };
    Id next = this->IsLeft(own) ? own : NoId;
    double largest = -Infinity;
    for (const Id other : this->SlotsAt[vertex])
    {
      const bool isPossible =
        other != own && this->IsLeft(other) && this->Links.Across[At(own)] == OpenEdge;
      const double cosine = isPossible ? Dot(wayOf(slot), wayOf(other)) : -Infinity;
      next = cosine > largest ? other : next;
      largest = std::max(largest, cosine);
    }
    return next;
  }

  void Follow(Id slot, Id vertex)
  {
    BorderChain chain;
    chain.IsLoop = false;
    chain.Vertices.push_back(vertex);
    this->PlaceOf[At(vertex)] = 0;
    while (slot != NoId)
    {
      this->IsSeen[At(slot)] = 1;
      chain.Slots.push_back(slot);
      vertex = this->OtherEnd(slot, vertex);
      chain.Vertices.push_back(vertex);
      if (this->PlaceOf[At(vertex)] != NoId)
      {
        this->CutLoop(chain, this->PlaceOf[At(vertex)]);
      }
      this->PlaceOf[At(vertex)] = static_cast<Id>(chain.Slots.size());
      slot = chain.Slots.empty() ? NoId : this->Next(chain.Slots.back(), vertex);
    }
    this->Forget(chain);
    if (!chain.Slots.empty())
    {
      Measure(this->Mesh, chain);
      this->Chains.push_back(std::move(chain));
    }
  }

  void Forget(const BorderChain& chain)
  {
    for (const Id vertex : chain.Vertices)
    {
      this->PlaceOf[At(vertex)] = NoId;
    }
  }

  // The chain has come back to its vertex `place`.
  void CutLoop(BorderChain& chain, Id place)
  {
    BorderChain loop;
    loop.Slots.assign(chain.Slots.begin() + place, chain.Slots.end());
    loop.Vertices.assign(chain.Vertices.begin() + place, chain.Vertices.end());
    this->Forget(loop);
    chain.Slots.resize(At(place));
    chain.Vertices.resize(At(place) + 1);
    Measure(this->Mesh, loop);
    this->Chains.push_back(std::move(loop));
  }

  const SurfaceMesh& Mesh;
  const SurfaceLinks& Links;
  IdLists SlotsAt;                  ///< open edges at vertices
  std::vector<std::uint8_t> IsSeen; ///< of slots
  std::vector<Id> PlaceOf;          ///< of vertices in the chain at hand
  std::vector<BorderChain> Chains;
};

} // namespace

SurfaceLinks LinkSurface(const SurfaceMesh& mesh, Pulse& pulse)
{
  SurfaceLinks links;
  const std::size_t slots = mesh.Corners.size();
  links.Across.assign(slots, OpenEdge);
  const IdLists slotsAt(mesh.Points.size(),
    [&mesh, slots](const auto& add)
    {
      for (std::size_t slot = 0; slot < slots; ++slot)
      {
        add(EndsOf(mesh, slot).first, static_cast<Id>(slot));
      }
    });
  std::vector<EdgeEnd> ends;
  pulse.ForEach(mesh.Points.size(),
    [&mesh, &slotsAt, &ends, &links](std::size_t vertex)
    {
      ends.clear();
      for (const Id slot : slotsAt[static_cast<Id>(vertex)])
      {
        ends.emplace_back(EndsOf(mesh, At(slot)).second, slot);
      }
      std::sort(ends.begin(), ends.end());
      std::size_t last = 0;
      for (std::size_t first = 0; first < ends.size(); first = last)
      {
        while (last < ends.size() && ends[last].first == ends[first].first)
        {
          ++last;
        }
        LinkEdge(ends.data() + first, ends.data() + last, links);
      }
    });
  return links;
}

IdLists CornersOfVertices(const SurfaceMesh& mesh)
{
  return IdLists(mesh.Points.size(),
    [&mesh](const auto& add)
    {
      for (std::size_t slot = 0; slot < mesh.Corners.size(); ++slot)
      {
        add(mesh.Corners[slot], static_cast<Id>(slot));
      }
    });
}

bool HasEdge(const SurfaceMesh& mesh, const IdLists& slotsAt, Id one, Id other)
{
  const IdLists::List slots = slotsAt[one];
  return std::any_of(slots.begin(), slots.end(),
    [&mesh, other](Id slot)
    {
      return mesh.Corners[NextSlotOf(At(slot))] == other ||
        mesh.Corners[PreviousSlotOf(At(slot))] == other;
    });
}

bool AreAlike(const SurfaceMesh& mesh, const SurfaceLinks& links, std::size_t slot)
{
  return mesh.Corners[NextSlotOf(slot)] != mesh.Corners[NextSlotOf(At(links.Across[slot]))];
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
  return links.NumberOfOpen > 0 ? BorderWalk(mesh, links).Run(pulse) : std::vector<BorderChain>();
}

} // namespace biting
