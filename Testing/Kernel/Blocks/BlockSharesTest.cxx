// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Blocks/BlockShares.h"

#include <gtest/gtest.h>

#include <algorithm> // for sort
#include <numeric>   // for accumulate

namespace biting
{

namespace
{

using Shares = std::vector<std::vector<std::size_t>>;

std::vector<BlockDomain> BlocksOf(const std::vector<double>& vertices)
{
  std::vector<BlockDomain> blocks(vertices.size());
  for (std::size_t k = 0; k < vertices.size(); ++k)
  {
    blocks[k].ExpectedVertices = vertices[k];
  }
  return blocks;
}

} // namespace

TEST(BlockShares, OneMemberHasAllBlocksTheLargestFirst)
{
  EXPECT_EQ(ShareBlocks(BlocksOf({ 2.0, 5.0, 3.0, 5.0 }), 1), (Shares{ { 1, 3, 2, 0 } }));
}

TEST(BlockShares, EachBlockGoesToTheMemberWithFewestVertices)
{
  EXPECT_EQ(ShareBlocks(BlocksOf({ 2.0, 5.0, 3.0, 4.0 }), 2), (Shares{ { 1, 0 }, { 3, 2 } }));
}

TEST(BlockShares, MoreMembersThanBlocksLeaveSomeWithout)
{
  EXPECT_EQ(ShareBlocks(BlocksOf({ 2.0, 5.0 }), 3), (Shares{ { 1 }, { 0 }, {} }));
  EXPECT_EQ(ShareBlocks({}, 2), (Shares{ {}, {} }));
}

/// No two shares differ by more than a block.
TEST(BlockShares, AreAboutEqual)
{
  std::vector<double> vertices;
  for (int k = 0; k < 100; ++k)
  {
    vertices.push_back(50.0 + 17 * k % 50);
  }
  std::vector<double> sums;
  for (const std::vector<std::size_t>& share : ShareBlocks(BlocksOf(vertices), 7))
  {
    sums.push_back(std::accumulate(share.begin(), share.end(), 0.0,
      [&vertices](double sum, std::size_t block) { return sum + vertices[block]; }));
  }
  std::sort(sums.begin(), sums.end());
  EXPECT_LE(sums.back() - sums.front(), 100.0);
  EXPECT_EQ(std::accumulate(sums.begin(), sums.end(), 0.0),
    std::accumulate(vertices.begin(), vertices.end(), 0.0));
}

} // namespace biting
