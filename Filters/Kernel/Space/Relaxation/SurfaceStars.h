// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSurfaceStars_h
#define BitingSurfaceStars_h

#include "../../Base/Ids.h"
#include "../../Base/Pulse.h"
#include "../../Base/TriangleSlots.h"

#include <cstddef> // for slots
#include <vector>  // for the arrays

namespace biting
{

/// The triangles of a surface with what is across their edges. Edges that are kept, and those that
/// have not two triangles, have nothing across.
class SurfaceStars
{
public:
  SurfaceStars(
    std::vector<Id>& corners, std::size_t points, const std::vector<Id>& keptEdges, Pulse& pulse);

  /// The slot across, or NoId.
  Id Across(std::size_t slot) const { return this->Twins[slot]; }

  /// Puts the other diagonal in place of the edge of the slot. Precondition: something is across.
  void Flip(std::size_t slot);

  /// Calls visit(slot) for the slot of the vertex in each of its triangles. Precondition: no edge
  /// of it is kept or open.
  template <typename Visit>
  void ForStar(Id vertex, Visit visit) const
  {
    const std::size_t first = this->SlotOf(vertex);
    std::size_t slot = first;
    do
    {
      visit(slot);
      slot = PreviousSlotOf(static_cast<std::size_t>(this->Twins[PreviousSlotOf(slot)]));
    } while (slot != first);
  }

  std::size_t SlotOf(Id vertex) const
  {
    return static_cast<std::size_t>(this->Slots[static_cast<std::size_t>(vertex)]);
  }

  Id Degree(Id vertex) const { return this->Degrees[static_cast<std::size_t>(vertex)]; }

private:
  void Link(std::size_t slot, Id across);

  std::vector<Id>& Corners;
  std::vector<Id> Twins;
  std::vector<Id> Slots;   ///< of vertices: one of theirs
  std::vector<Id> Degrees; ///< of vertices: triangles
};

} // namespace biting

#endif
