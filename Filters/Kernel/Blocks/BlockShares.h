// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingBlockShares_h
#define BitingBlockShares_h

#include "BlockDomains.h"

#include <cstddef> // for numbers of blocks
#include <vector>  // for the shares

namespace biting
{

/// The blocks of each of `members`, as numbers: `dealtLeaves` (DealLeaves) says to whom each leaf
/// goes, and with it the blocks that lie there. A member's share begins with its largest block:
/// while that is at work, other threads do several of the others. Depends on the blocks alone.
std::vector<std::vector<std::size_t>> ShareBlocks(
  const std::vector<BlockDomain>& blocks, const std::vector<Id>& dealtLeaves, std::size_t members);

} // namespace biting

#endif
