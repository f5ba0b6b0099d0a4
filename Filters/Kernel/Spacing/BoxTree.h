// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingBoxTree_h
#define BitingBoxTree_h

#include "../Base/Box2.h"
#include "../Base/Ids.h"
#include "../Base/Numbers.h"
#include "../Base/Pulse.h"

#include <algorithm> // for nth_element, sort
#include <utility>   // for move, swap
#include <vector>    // for the arrays

namespace biting
{

/// Branch and bound over many items: each lies in item.Box(), and its cost at x is at least
/// item.Least() plus slope times the distance from x to the box. A balanced binary tree of boxes;
/// the cost of a search is logarithmic in ordinary cases.
template <typename Item>
class BoxTree
{
public:
  BoxTree() = default;

  /// Empty if the pulse stops.
  BoxTree(const std::vector<Item>& items, Pulse& pulse);

  /// In the order of the tree: items near each other are mostly near each other there. It depends
  /// on the items alone.
  const std::vector<Item>& Items() const { return this->Ordered; }

  /// Calls visit(item, limit) for all items whose cost at x may be below `limit`, likely ones
  /// first. Each call returns the limit from then on.
  template <typename Visit>
  void Search(const Point2& x, double slope, double limit, Visit visit) const
  {
    if (!this->Nodes.empty())
    {
      const Node& root = this->Nodes.front();
      this->SearchBelow(root, root.Bound(x, slope), x, slope, limit, visit);
    }
  }

private:
  static constexpr Id ItemsPerLeaf = 4;

  /// What there is to know of an item when the tree is built.
  struct Entry
  {
    Box2 Box;
    double Least;
    Id Number;

    /// Twice the middle of the box along x or y.
    double Key(bool alongX) const
    {
      return alongX ? this->Box.Low.X + this->Box.High.X : this->Box.Low.Y + this->Box.High.Y;
    }
  };

  /// Leaf: items [First, First + Count). Otherwise the children are nodes First and First + 1.
  struct Node
  {
    Box2 Box;
    double Least = Infinity;
    Id First = 0;
    Id Count = 0;

    double Bound(const Point2& x, double slope) const
    {
      const double left = this->Box.Low.X - x.X;
      const double right = x.X - this->Box.High.X;
      const double below = this->Box.Low.Y - x.Y;
      const double above = x.Y - this->Box.High.Y;
      const double across = std::max(std::max(left, right), 0.0);
      const double along = std::max(std::max(below, above), 0.0);
      return this->Least + slope * Length({ across, along });
    }
  };

  template <typename Visit>
  void SearchBelow(const Node& node, double bound, const Point2& x, double slope, double& limit,
    Visit& visit) const;
  void Build(std::vector<Entry>& entries, Id nodeId, Id first, Id last, Pulse& pulse);

  std::vector<Item> Ordered;
  std::vector<Node> Nodes;
};

template <typename Item>
BoxTree<Item>::BoxTree(const std::vector<Item>& items, Pulse& pulse)
{
  std::vector<Entry> entries;
  entries.reserve(items.size());
  for (const Item& item : items)
  {
    entries.push_back({ item.Box(), item.Least(), static_cast<Id>(entries.size()) });
  }
  if (!items.empty())
  {
    this->Nodes.reserve(items.size());
    this->Nodes.resize(1);
    this->Build(entries, 0, 0, static_cast<Id>(items.size()), pulse);
  }
  if (pulse.HasStopped())
  {
    this->Nodes.clear();
    return;
  }
  this->Ordered.reserve(items.size());
  for (const Entry& entry : entries)
  {
    this->Ordered.push_back(items[static_cast<std::size_t>(entry.Number)]);
  }
}

template <typename Item>
void BoxTree<Item>::Build(std::vector<Entry>& entries, Id nodeId, Id first, Id last, Pulse& pulse)
{
  if (!pulse.Beat(4 * static_cast<std::size_t>(last - first)))
  {
    return;
  }
  const auto begin = entries.begin() + first;
  const auto end = entries.begin() + last;
  Node node;
  node.First = first;
  node.Count = last - first;
  for (auto entry = begin; entry < end; ++entry)
  {
    node.Box.Add(entry->Box.Low);
    node.Box.Add(entry->Box.High);
    node.Least = std::min(node.Least, entry->Least);
  }
  if (node.Count > ItemsPerLeaf)
  {
    const Id middle = first + node.Count / 2;
    const bool alongX = node.Box.Width() > node.Box.Height();
    std::nth_element(begin, entries.begin() + middle, end,
      [alongX](const Entry& a, const Entry& b)
      {
        const double keyA = a.Key(alongX);
        const double keyB = b.Key(alongX);
        return keyA < keyB || (keyA == keyB && a.Number < b.Number);
      });
    node.First = static_cast<Id>(this->Nodes.size());
    node.Count = 0;
    this->Nodes.resize(this->Nodes.size() + 2);
    this->Build(entries, node.First, first, middle, pulse);
    this->Build(entries, node.First + 1, middle, last, pulse);
  }
  else
  {
    std::sort(begin, end, [](const Entry& a, const Entry& b) { return a.Number < b.Number; });
  }
  this->Nodes[static_cast<std::size_t>(nodeId)] = node;
}

template <typename Item>
template <typename Visit>
void BoxTree<Item>::SearchBelow(
  const Node& node, double bound, const Point2& x, double slope, double& limit, Visit& visit) const
{
  for (Id k = 0; k < node.Count && bound < limit; ++k)
  {
    limit = visit(this->Ordered[static_cast<std::size_t>(node.First + k)], limit);
  }
  if (node.Count == 0 && bound < limit)
  {
    const Node* near = &this->Nodes[static_cast<std::size_t>(node.First)];
    const Node* far = near + 1;
    double nearBound = near->Bound(x, slope);
    double farBound = far->Bound(x, slope);
    if (farBound < nearBound)
    {
      std::swap(near, far);
      std::swap(nearBound, farBound);
    }
    this->SearchBelow(*near, nearBound, x, slope, limit, visit);
    this->SearchBelow(*far, farBound, x, slope, limit, visit);
  }
}

} // namespace biting

#endif
