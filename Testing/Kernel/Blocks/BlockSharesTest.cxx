// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Blocks/BlockDomains.h"

#include <gtest/gtest.h>

#include <vector> // for shares

namespace biting
{

namespace
{

using Shares = std::vector<std::vector<std::size_t>>;

/// Each in a leaf of its own.
std::vector<BlockDomain> BlocksOf(const std::vector<double>& vertices)
{
  std::vector<BlockDomain> blocks(vertices.size());
  for (std::size_t k = 0; k < vertices.size(); ++k)
  {
    blocks[k].ExpectedVertices = vertices[k];
    blocks[k].Leaf = static_cast<Id>(k);
  }
  return blocks;
}

} // namespace

TEST(BlockShares, OneMemberHasAllBlocksTheLargestFirst)
{
  EXPECT_EQ(
    ShareBlocks(BlocksOf({ 2.0, 5.0, 3.0, 5.0 }), { 0, 0, 0, 0 }, 1), (Shares{ { 1, 3, 2, 0 } }));
}

TEST(BlockShares, EachBlockGoesToTheMemberThatItsLeafGoesTo)
{
  EXPECT_EQ(ShareBlocks(BlocksOf({ 2.0, 5.0, 3.0, 4.0 }), { 0, 0, 1, 1 }, 2),
    (Shares{ { 1, 0 }, { 3, 2 } }));
  std::vector<BlockDomain> blocks = BlocksOf({ 2.0, 5.0 });
  blocks[1].Leaf = 2;
  EXPECT_EQ(ShareBlocks(blocks, { 0, 0, 2 }, 3), (Shares{ { 0 }, {}, { 1 } }));
}

TEST(BlockShares, MoreMembersThanBlocksLeaveSomeWithout)
{
  EXPECT_EQ(ShareBlocks(BlocksOf({ 2.0, 5.0 }), { 0, 2 }, 4), (Shares{ { 0 }, {}, { 1 }, {} }));
  EXPECT_EQ(ShareBlocks({}, {}, 2), (Shares{ {}, {} }));
}

} // namespace biting
