// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "ChainKinds.h"

#include "AreaSum.h"
#include "BoundaryComponents.h"
#include "Nesting.h"

#include <algorithm> // for any_of, binary_search, set_symmetric_difference, sort
#include <cstddef>   // for size_t
#include <iterator>  // for back_inserter
#include <map>       // for areas

namespace biting
{

namespace
{

using Flags = std::vector<std::uint8_t>;
using Counts = std::vector<Id>;

Flags FindGivenBoundary(const Arrangement& arrangement, Pulse& pulse);
void AddFaces(const Arrangement& arrangement, Flags& bounds);
void AddOpenChains(const Arrangement& arrangement, Flags& bounds, Pulse& pulse);

/// The loops and faces that enclose a place, ascending.
using Cover = std::vector<Id>;

/// The covers on both sides of each edge: above and below, where it is passed from left to right.
struct EdgeCovers
{
  std::vector<Cover> Above;
  std::vector<Id> Below; ///< the edge whose Above it is; NoId: nothing encloses the place

  const Cover& BelowOf(std::size_t edge) const
  {
    static const Cover nothing;
    return this->Below[edge] == NoId ? nothing : this->Above[this->Below[edge]];
  }
};

/// Crossing an edge enters or leaves all that runs along it an odd number of times.
EdgeCovers FindCovers(const Arrangement& arrangement, Pulse& pulse)
{
  const std::vector<Id> noTurns(arrangement.Edges.size(), 0);
  SegmentDepths depths = FindDepths(arrangement.Vertices, arrangement.EdgeEnds(), noTurns, pulse);
  EdgeCovers covers;
  covers.Above.resize(arrangement.Edges.size());
  covers.Below = std::move(depths.Below);
  covers.Below.resize(arrangement.Edges.size(), NoId);
  for (std::size_t k = 0; k < depths.Order.size() && pulse.Beat(1); ++k)
  {
    const Id edge = depths.Order[k];
    std::vector<Id> odd = arrangement.Edge(edge).Faces.OddFaces();
    std::sort(odd.begin(), odd.end());
    const Cover& below = covers.BelowOf(edge);
    std::set_symmetric_difference(
      below.begin(), below.end(), odd.begin(), odd.end(), std::back_inserter(covers.Above[edge]));
  }
  return covers;
}

/// The loop or face of the largest area, the first of equals; NoId where there is none.
Id FindLargest(const Arrangement& arrangement, const EdgeCovers& covers)
{
  std::map<Id, AreaSum> areas;
  for (std::size_t e = 0; e < covers.Above.size(); ++e)
  {
    const auto [a, b] = arrangement.Edges[e].Ends;
    const bool isForward = arrangement.At(a) < arrangement.At(b);
    for (const Id face : arrangement.Edges[e].Faces.OddFaces())
    {
      const Cover& above = covers.Above[e];
      const bool isLeft = std::binary_search(above.begin(), above.end(), face) == isForward;
      areas.try_emplace(face, arrangement.At(0))
        .first->second.Add(arrangement.At(isLeft ? a : b), arrangement.At(isLeft ? b : a));
    }
  }
  Id largest = NoId;
  for (const auto& [face, area] : areas)
  {
    largest = largest == NoId || area.Area() > areas.at(largest).Area() ? face : largest;
  }
  return largest;
}

} // namespace

std::vector<std::uint8_t> FindBoundary(const Arrangement& arrangement, Pulse& pulse)
{
  Flags bounds = FindGivenBoundary(arrangement, pulse);
  AddFaces(arrangement, bounds);
  AddOpenChains(arrangement, bounds, pulse);
  return bounds;
}

namespace
{

bool LeavesEndsOpen(const Arrangement& arrangement, const Flags& bounds)
{
  Flags isOdd(arrangement.Vertices.size(), 0);
  for (std::size_t e = 0; e < bounds.size(); ++e)
  {
    isOdd[arrangement.Edges[e].Ends.Start] ^= bounds[e];
    isOdd[arrangement.Edges[e].Ends.End] ^= bounds[e];
  }
  return std::any_of(isOdd.begin(), isOdd.end(), [](std::uint8_t odd) { return odd != 0; });
}

void Toggle(const BoundaryComponent& component, Flags& bounds)
{
  for (const Id edge : component.Edges)
  {
    bounds[edge] ^= 1;
  }
}

/// Of chains that are boundary by kind or because they are closed.
Flags FindGivenBoundary(const Arrangement& arrangement, Pulse& pulse)
{
  Counts counts;
  Flags parity;
  for (const ArrangementEdge& edge : arrangement.Edges)
  {
    counts.push_back(edge.BoundaryCount);
    parity.push_back(static_cast<std::uint8_t>(edge.BoundaryCount % 2));
  }
  if (!LeavesEndsOpen(arrangement, parity))
  {
    return parity;
  }
  Flags bounds(counts.size(), 0);
  for (const BoundaryComponent& component : FindBoundaryComponents(arrangement, counts, pulse))
  {
    Toggle(component, bounds);
  }
  return bounds;
}

/// Outlines of faces are closed, whatever lines leave open.
void AddFaces(const Arrangement& arrangement, Flags& bounds)
{
  for (std::size_t e = 0; e < bounds.size(); ++e)
  {
    bounds[e] ^= static_cast<std::uint8_t>(arrangement.Edges[e].Faces.Count % 2);
  }
}

/// Whether the place just outside the component is inside the domain.
bool IsWithin(
  const BoundaryComponent& component, const Arrangement& arrangement, const InsideFlags& inside)
{
  const auto edge = static_cast<std::size_t>(component.LowestEdge);
  const bool isForward = arrangement.Edges[edge].Ends.Start == component.Lowest.Start;
  return (isForward ? inside.Right[edge] : inside.Left[edge]) != 0;
}

void AddOpenChains(const Arrangement& arrangement, Flags& bounds, Pulse& pulse)
{
  Counts counts;
  for (const ArrangementEdge& edge : arrangement.Edges)
  {
    counts.push_back(edge.OpenCount);
  }
  const auto components = FindBoundaryComponents(arrangement, counts, pulse);
  for (const BoundaryComponent& component : components)
  {
    Toggle(component, bounds);
  }
  const auto isSimple = [](const BoundaryComponent& component) { return component.IsSimpleLoop; };
  if (std::all_of(components.begin(), components.end(), isSimple))
  {
    return;
  }
  const InsideFlags inside =
    FindInside(arrangement.Vertices, arrangement.EdgeEnds(), bounds, pulse);
  if (pulse.HasStopped())
  {
    return;
  }
  for (const BoundaryComponent& component : components)
  {
    if (!component.IsSimpleLoop && IsWithin(component, arrangement, inside))
    {
      Toggle(component, bounds);
    }
  }
}

} // namespace

std::vector<std::uint8_t> FindBoundaryByRule(
  Arrangement& arrangement, const DomainOptions& options, Pulse& pulse)
{
  const EdgeCovers covers = FindCovers(arrangement, pulse);
  const bool isUnion = options.Rule == DomainRule::Union;
  const Id outer = isUnion ? NoId : FindLargest(arrangement, covers);
  /// The part of the domain in which a place lies; NoId: it is outside.
  const auto partOf = [&arrangement, isUnion, outer](const Cover& cover)
  {
    const bool isInside = isUnion ? !cover.empty() : cover == Cover{ outer };
    return !isInside                ? NoId
      : arrangement.Regions.empty() ? cover.back()
                                    : arrangement.Regions[cover.back()];
  };
  std::vector<std::uint8_t> bounds(arrangement.Edges.size(), 0);
  for (std::size_t e = 0; e < bounds.size() && !pulse.HasStopped(); ++e)
  {
    const Id above = partOf(covers.Above[e]);
    const Id below = partOf(covers.BelowOf(e));
    FaceEdge& faces = arrangement.Edges[e].Faces;
    const bool isEdgeOfFace = faces.Count > 0;
    bounds[e] = (above == NoId) != (below == NoId);
    faces = FaceEdge();
    faces.Stays = above != below || (isEdgeOfFace && options.KeepCellEdges);
  }
  return bounds;
}

} // namespace biting
