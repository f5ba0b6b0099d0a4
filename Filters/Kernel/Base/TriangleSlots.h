// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingTriangleSlots_h
#define BitingTriangleSlots_h

#include "Ids.h"

#include <cstddef> // for slots
#include <vector>  // for the arrays

// Slots of triangles: slot 3 t + k is corner k of triangle t, and the edge opposite it, from the
// next corner to the previous one.

namespace biting
{

constexpr std::size_t NextSlotOf(std::size_t slot)
{
  return slot % 3 == 2 ? slot - 2 : slot + 1;
}

constexpr std::size_t PreviousSlotOf(std::size_t slot)
{
  return slot % 3 == 0 ? slot + 2 : slot - 1;
}

/// The slot of the triangle `neighbor` whose edge starts where that of `slot` ends; any where there
/// is none. Without branches: which corner it is cannot be predicted.
inline std::size_t SlotAcross(const std::vector<Id>& corners, std::size_t slot, Id neighbor)
{
  constexpr std::size_t SlotBefore[] = { 2, 0, 1, 1 };
  const std::size_t first = 3 * static_cast<std::size_t>(neighbor);
  const Id end = corners[PreviousSlotOf(slot)];
  const std::size_t isSecond = corners[first + 1] == end ? 1 : 0;
  const std::size_t isThird = corners[first + 2] == end ? 2 : 0;
  return first + SlotBefore[isSecond + isThird];
}

} // namespace biting

#endif
