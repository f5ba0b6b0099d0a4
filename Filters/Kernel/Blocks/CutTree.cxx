// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "CutTree.h"

#include <algorithm> // for clamp

namespace biting
{

namespace
{

// From low to high, at each line.
std::vector<Id> LeavesInOrder(const CutTree& tree)
{
  std::vector<Id> leaves;
  std::vector<Id> pending(tree.Nodes.empty() ? 0 : 1, 0);
  while (!pending.empty())
  {
    const Id node = pending.back();
    const Id children = tree.Nodes[node].Children;
    pending.pop_back();
    if (children == NoId)
    {
      leaves.push_back(node);
    }
    else
    {
      pending.push_back(children + 1);
      pending.push_back(children);
    }
  }
  return leaves;
}

} // namespace

std::vector<Id> DealLeaves(const CutTree& tree, Id parts)
{
  const std::vector<Id> leaves = LeavesInOrder(tree);
  double all = 0.0;
  for (const Id node : leaves)
  {
    all += tree.Nodes[node].Vertices;
  }
  std::vector<Id> dealt(static_cast<std::size_t>(tree.NumberOfLeaves), 0);
  double before = 0.0;
  for (const Id node : leaves)
  {
    const CutTree::Node& leaf = tree.Nodes[node];
    const double middle = (before + 0.5 * leaf.Vertices) / all;
    dealt[leaf.Leaf] = all > 0.0 ? std::clamp(static_cast<Id>(parts * middle), 0, parts - 1) : 0;
    before += leaf.Vertices;
  }
  return dealt;
}

} // namespace biting
