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

/// Which of the three corners of a triangle the vertex is, 0 to 2; any, or 3, where it is none.
/// Without branches: which it is cannot be predicted.
inline std::size_t CornerOf(const Id* corners, Id vertex)
{
  const std::size_t isSecond = corners[1] == vertex ? 1 : 0;
  const std::size_t isThird = corners[2] == vertex ? 2 : 0;
  return isSecond + isThird;
}

/// The slot of the triangle `neighbor` whose edge starts where that of `slot` ends; any where there
/// is none.
inline std::size_t SlotAcross(const std::vector<Id>& corners, std::size_t slot, Id neighbor)
{
  constexpr std::size_t Before[] = { 2, 0, 1, 1 };
  const std::size_t first = 3 * static_cast<std::size_t>(neighbor);
  return first + Before[CornerOf(&corners[first], corners[PreviousSlotOf(slot)])];
}

} // namespace biting

#endif
