// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingRegionFill_h
#define BitingRegionFill_h

#include "../Base/Ids.h"
#include "../Base/Pulse.h"
#include "HalfEdgeMesh.h"
#include "Triangulation.h"

#include <vector> // for the order

namespace biting
{

/// The inside of the mesh: triangles that are an odd number of boundaries away from the ghosts.
/// `constraints` have vertices of the mesh as ends; `order` maps these to the points of the caller,
/// which the result refers to.
/// Regions are numbered as one meets them along the constraints, in order of number, from start to
/// end, the left side of each edge before the right. Triangles are ordered region by region, and
/// within by the last of their corners, as a point of the caller: where points near each other are
/// so in the caller's order, neighbors are near each other in memory, too.
/// The arrays of `mesh` are given back as they are read. On abort the result is empty.
Triangulation TakeInside(HalfEdgeMesh& mesh, const ConstraintEdges& constraints,
  const std::vector<Id>& order, Pulse& pulse);

} // namespace biting

#endif
