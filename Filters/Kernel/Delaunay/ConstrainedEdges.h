// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingConstrainedEdges_h
#define BitingConstrainedEdges_h

#include "../Base/Ids.h"
#include "../Base/Pulse.h"
#include "../Base/Tasks.h"

#include <cstddef> // for size_t
#include <vector>  // for lists

namespace biting
{

/// Slots of triangles, found part by part.
struct SlotList
{
  std::vector<std::size_t> Slots;

  void Join(const SlotList& other)
  {
    this->Slots.insert(this->Slots.end(), other.Slots.begin(), other.Slots.end());
  }
};

/// Calls visit(constraint, start, end) once for each mesh edge on a constraint, in the order of the
/// triangles; these are looked through on all threads. `mesh` has Corners, Neighbors and
/// Constraints as Triangulation has. Goes on until the monitor wants to stop.
template <typename Mesh, typename Visitor>
void ForEachConstrainedEdge(const Mesh& mesh, Pulse& pulse, const Visitor& visit)
{
  const SlotList list = SumAtOnce(pulse, mesh.Corners.size() / 3, SlotList(),
    [&mesh](SlotList& sum, std::size_t triangle)
    {
      const Id* constraints = &mesh.Constraints[3 * triangle];
      if ((constraints[0] & constraints[1] & constraints[2]) == NoId)
      {
        return; // nearly all: each is NoId, which has all bits
      }
      for (std::size_t half = 3 * triangle; half < 3 * triangle + 3; ++half)
      {
        if (mesh.Constraints[half] != NoId && mesh.Neighbors[half] < static_cast<Id>(triangle))
        {
          sum.Slots.push_back(half);
        }
      }
    });
  for (std::size_t k = 0; k < list.Slots.size() && pulse.Beat(); ++k)
  {
    const std::size_t half = list.Slots[k];
    const std::size_t corner = half % 3;
    visit(mesh.Constraints[half], mesh.Corners[half - corner + (corner + 1) % 3],
      mesh.Corners[half - corner + (corner + 2) % 3]);
  }
}

} // namespace biting

#endif
