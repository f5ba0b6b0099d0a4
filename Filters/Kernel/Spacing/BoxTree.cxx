// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "BoxTree.h"

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
  Node node = this->Enclose(items, first, last);
  if (node.Count > ItemsPerLeaf)
  {
    const Id middle = first + node.Count / 2;
    const bool alongX = node.Box.Width() > node.Box.Height();
    std::nth_element(this->Items.begin() + first, this->Items.begin() + middle,
      this->Items.begin() + last,
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
    std::sort(this->Items.begin() + first, this->Items.begin() + last);
  }
  this->Nodes[static_cast<std::size_t>(nodeId)] = node;
}

BoxTree::Node BoxTree::Enclose(const std::vector<Item>& items, Id first, Id last) const
{
  Node node;
  node.First = first;
  node.Count = last - first;
  node.Value = items[static_cast<std::size_t>(this->Items[static_cast<std::size_t>(first)])].Value;
  for (Id position = first; position < last; ++position)
  {
    const Id id = this->Items[static_cast<std::size_t>(position)];
    const Item& item = items[static_cast<std::size_t>(id)];
    node.Box.Add(item.Box.Low);
    node.Box.Add(item.Box.High);
    node.Value = std::min(node.Value, item.Value);
  }
  return node;
}

} // namespace biting
