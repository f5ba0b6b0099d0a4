// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "FreedMemory.h"

#include <cstddef> // for a size
#include <cstdlib> // for malloc

namespace biting
{

// From the size of the largest block that was freed so far glibc tells what is a large one, to be
// taken from the system and given back alone; and it keeps twice that size at the end of the heap.
// The block is the largest that it looks at (mallopt(3), M_MMAP_THRESHOLD). It is never touched, so
// it takes no memory; but sanitizers mark all of it, so it is taken once.
void KeepFreedMemory()
{
  constexpr std::size_t Largest = std::size_t{ 1 } << 25;
  constexpr std::size_t Heading = 1u << 13; // of a block: more than a page
  static const bool isFreed = []
  {
    void* volatile block = std::malloc(Largest - Heading);
    std::free(block);
    return true;
  }();
  static_cast<void>(isFreed);
}

} // namespace biting
