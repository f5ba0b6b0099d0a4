// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "ChainKinds.h"

#include "BoundaryComponents.h"
#include "Nesting.h"

#include <algorithm> // for any_of
#include <cstddef>   // for size_t

namespace biting
{

namespace
{

using Flags = std::vector<std::uint8_t>;
using Counts = std::vector<Id>;

Flags FindGivenBoundary(const Arrangement& arrangement, Pulse& pulse);
void AddFaces(const Arrangement& arrangement, Flags& bounds);
void AddOpenChains(const Arrangement& arrangement, Flags& bounds, Pulse& pulse);

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

} // namespace biting
