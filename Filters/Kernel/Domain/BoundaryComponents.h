// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingBoundaryComponents_h
#define BitingBoundaryComponents_h

#include "../Base/Ids.h"
#include "Arrangement.h"

#include <vector> // for the components

namespace biting
{

/// A connected piece of the drawing that can bound a domain.
struct BoundaryComponent
{
  std::vector<Id> Edges;     ///< the inside changes across them; those listed twice do not count
  SegmentEnds Lowest;        ///< from its leftmost vertex along the lowest edge there
  Id LowestEdge = NoId;      ///< the same by number
  bool IsSimpleLoop = false; ///< two edges at each vertex, and no vertex made by a crossing
};

/// Finds what can bound among the edges of an arrangement that have a count, which says how often
/// each is drawn. The edges of each component have even degree at every vertex.
///
/// Bridges bound nothing and are taken away first. A component that is left bounds by parity where
/// all its vertices have even degree, each edge counted as often as drawn; else by its outline: the
/// edges that its outer face touches.
/// Cost O(n log n).
std::vector<BoundaryComponent> FindBoundaryComponents(
  const Arrangement& arrangement, const std::vector<Id>& counts, Pulse& pulse);

} // namespace biting

#endif
