// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingConstrainedEdges_h
#define BitingConstrainedEdges_h

#include "../Base/Ids.h"
#include "../Base/Pulse.h"

#include <cstddef> // for size_t

namespace biting
{

/// Calls visit(constraint, start, end) once for each mesh edge on a constraint, in the order of the
/// triangles. `mesh` has Corners, Neighbors and Constraints as Triangulation has. Goes on until
/// the monitor wants to stop.
template <typename Mesh, typename Visitor>
void ForEachConstrainedEdge(const Mesh& mesh, Pulse& pulse, const Visitor& visit)
{
  pulse.ForEach(mesh.Corners.size(),
    [&mesh, &visit](std::size_t half)
    {
      const Id constraint = mesh.Constraints[half];
      const bool isFirst = mesh.Neighbors[half] < static_cast<Id>(half / 3);
      if (constraint != NoId && isFirst)
      {
        const std::size_t corner = half % 3;
        visit(constraint, mesh.Corners[half - corner + (corner + 1) % 3],
          mesh.Corners[half - corner + (corner + 2) % 3]);
      }
    });
}

} // namespace biting

#endif
