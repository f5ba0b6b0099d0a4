// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingMeshParts_h
#define BitingMeshParts_h

#include "../Base/Ids.h"
#include "../Base/Pulse.h"

#include <cstddef> // for slots
#include <cstdint> // for counts
#include <vector>  // for the arrays

// What Euler's formula asks of a mesh besides its size. Arrays as in Triangulation, neighbors
// mutual. Where the pulse has stopped the counts have no meaning. Cost O(n).

namespace biting
{

/// How many parts a mesh has: triangles of one part are connected over edges.
std::int64_t CountComponents(const std::vector<Id>& neighbors, Pulse& pulse);

/// How many closed chains the boundary edges make, which are those of `boundarySlots`, where each
/// goes on with the boundary edge of the same fan of triangles about its end.
std::int64_t CountBoundaryLoops(const std::vector<Id>& corners, const std::vector<Id>& neighbors,
  const std::vector<std::size_t>& boundarySlots, Pulse& pulse);

} // namespace biting

#endif
