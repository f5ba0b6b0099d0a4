// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "BlockShares.h"

#include <algorithm> // for stable_sort
#include <numeric>   // for iota

namespace biting
{

std::vector<std::vector<std::size_t>> ShareBlocks(
  const std::vector<BlockDomain>& blocks, const std::vector<Id>& dealtLeaves, std::size_t members)
{
  std::vector<std::size_t> largestFirst(blocks.size());
  std::iota(largestFirst.begin(), largestFirst.end(), std::size_t{ 0 });
  std::stable_sort(largestFirst.begin(), largestFirst.end(),
    [&blocks](std::size_t a, std::size_t b)
    { return blocks[a].ExpectedVertices > blocks[b].ExpectedVertices; });
  std::vector<std::vector<std::size_t>> shares(members);
  for (const std::size_t block : largestFirst)
  {
    shares[static_cast<std::size_t>(dealtLeaves[blocks[block].Leaf])].push_back(block);
  }
  return shares;
}

} // namespace biting
