// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingBlockShares_h
#define BitingBlockShares_h

#include "BlockDomains.h"

#include <cstddef> // for numbers of blocks
#include <vector>  // for the shares

namespace biting
{

/// The blocks of each of `members`, as numbers: one after the other, the largest first, goes to the
/// member that has fewest expected vertices so far, the first of those. So a member's share begins
/// with its largest: while that is at work, other threads do several of the others. Depends on the
/// blocks alone.
std::vector<std::vector<std::size_t>> ShareBlocks(
  const std::vector<BlockDomain>& blocks, std::size_t members);

} // namespace biting

#endif
