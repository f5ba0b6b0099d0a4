// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Blocks/CutTree.h"

#include <gtest/gtest.h>

#include <algorithm> // for count, is_sorted

namespace biting
{

namespace
{

/// Cuts at x = 1, 2, ... into columns of so many vertices. Each cut has all that is left to its
/// right.
CutTree Columns(const std::vector<double>& vertices)
{
  CutTree tree;
  tree.Nodes.resize(1);
  for (std::size_t k = 0; k < vertices.size(); ++k)
  {
    CutTree::Node& node = tree.Nodes.back();
    if (k + 1 < vertices.size())
    {
      node.At = static_cast<double>(k + 1);
      node.Children = static_cast<Id>(tree.Nodes.size());
      CutTree::Node leaf;
      leaf.Leaf = tree.NumberOfLeaves++;
      leaf.Vertices = vertices[k];
      tree.Nodes.push_back(leaf);
      tree.Nodes.emplace_back();
    }
    else
    {
      node.Leaf = tree.NumberOfLeaves++;
      node.Vertices = vertices[k];
    }
  }
  return tree;
}

} // namespace

TEST(CutTree, APlaceIsInTheLeafOnItsSideOfEachCut)
{
  const CutTree tree = Columns({ 1.0, 1.0, 1.0, 1.0 });
  for (int k = 0; k < 4; ++k)
  {
    EXPECT_EQ(tree.Nodes[tree.NodeAt({ k + 0.5, 7.0 })].Leaf, k);
  }
}

TEST(CutTree, PartsAreLeavesInARowWithAboutAsManyVertices)
{
  const CutTree tree = Columns(std::vector<double>(64, 3.0));
  for (const Id parts : { 1, 2, 3, 7, 64 })
  {
    const std::vector<Id> dealt = DealLeaves(tree, parts);
    EXPECT_TRUE(std::is_sorted(dealt.begin(), dealt.end()));
    for (Id part = 0; part < parts; ++part)
    {
      const auto count = std::count(dealt.begin(), dealt.end(), part);
      EXPECT_GE(count, 64 / parts) << parts;
      EXPECT_LE(count, 64 / parts + 1) << parts;
    }
  }
}

TEST(CutTree, ALeafWithMostOfTheVerticesIsAPartOfItsOwn)
{
  EXPECT_EQ(DealLeaves(Columns({ 1.0, 1.0, 98.0, 0.0 }), 2), (std::vector<Id>{ 0, 0, 1, 1 }));
}

TEST(CutTree, MorePartsThanLeavesLeaveSomeEmpty)
{
  const std::vector<Id> dealt = DealLeaves(Columns({ 1.0, 1.0 }), 5);
  ASSERT_EQ(dealt.size(), 2u);
  EXPECT_LT(dealt[0], dealt[1]);
  EXPECT_LT(dealt[1], 5);
}

TEST(CutTree, OfNoLeavesOrNoVerticesNothingIsDealt)
{
  EXPECT_TRUE(DealLeaves(CutTree(), 3).empty());
  EXPECT_EQ(DealLeaves(Columns({ 0.0, 0.0 }), 3), (std::vector<Id>{ 0, 0 }));
}

} // namespace biting
