// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "BoxTree.h"

#include "../Base/Numbers.h"

#include <algorithm> // for nth_element, sort
#include <numeric>   // for iota

namespace biting
{
namespace
{

constexpr Id ItemsPerLeaf = 4;

/// Twice the middle of a box along x or y.
double SortKey(const Box2& box, bool alongX)
{
  return alongX ? box.Low.X + box.High.X : box.Low.Y + box.High.Y;
}

} // namespace

BoxTree::BoxTree(const std::vector<Item>& items, Pulse& pulse)
  : Items(items.size())
{
  std::iota(this->Items.begin(), this->Items.end(), 0);
  if (!items.empty())
  {
    this->Nodes.reserve(items.size());
    this->Nodes.resize(1);
    this->Build(items, 0, 0, static_cast<Id>(items.size()), pulse);
  }
  if (pulse.HasStopped())
  {
    *this = BoxTree();
  }
}

void BoxTree::Build(const std::vector<Item>& items, Id nodeId, Id first, Id last, Pulse& pulse)
{
  if (!pulse.Beat(4 * static_cast<std::size_t>(last - first)))
  {
    return;
  }
  const auto begin = this->Items.begin() + first;
  const auto end = this->Items.begin() + last;
  Node node{ {}, Infinity, first, last - first };
  std::for_each(begin, end,
    [&items, &node](Id id)
    {
      const Item& item = items[static_cast<std::size_t>(id)];
      node.Box.Add(item.Box.Low);
      node.Box.Add(item.Box.High);
      node.Value = std::min(node.Value, item.Value);
    });
  if (node.Count > ItemsPerLeaf)
  {
    const Id middle = first + node.Count / 2;
    const bool alongX = node.Box.Width() > node.Box.Height();
    std::nth_element(begin, this->Items.begin() + middle, end,
      [&items, alongX](Id a, Id b)
      {
        const double keyA = SortKey(items[static_cast<std::size_t>(a)].Box, alongX);
        const double keyB = SortKey(items[static_cast<std::size_t>(b)].Box, alongX);
        return keyA < keyB || (keyA == keyB && a < b);
      });
    node.First = static_cast<Id>(this->Nodes.size());
    node.Count = 0;
    this->Nodes.resize(this->Nodes.size() + 2);
    this->Build(items, node.First, first, middle, pulse);
    this->Build(items, node.First + 1, middle, last, pulse);
  }
  else
  {
    std::sort(begin, end);
  }
  this->Nodes[static_cast<std::size_t>(nodeId)] = node;
}

} // namespace biting
