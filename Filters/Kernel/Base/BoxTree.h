// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingBoxTree_h
#define BitingBoxTree_h

#include "Box.h"
#include "Ids.h"
#include "Numbers.h"
#include "Pulse.h"

#include <algorithm> // for nth_element, sort
#include <utility>   // for move, swap
#include <vector>    // for the arrays

namespace biting
{

/// Branch and bound over many items of the plane or of space: each lies in item.Box(), and its cost
/// at x is at least item.Least() plus slope times the distance from x to the box; and which of them
/// meet a box. A balanced binary tree of boxes; the cost of a search is logarithmic in ordinary
/// cases.
template <typename Item, std::size_t D = 2>
class BoxTree
{
public:
  BoxTree() = default;

  /// Empty if the pulse stops.
  BoxTree(std::vector<Item> items, Pulse& pulse);

  /// In the order of the tree: items near each other are mostly near each other there. It depends
  /// on the items alone.
  const std::vector<Item>& Items() const { return this->Ordered; }

  /// Calls visit(item, limit) for all items whose cost at x may be below `limit`, likely ones
  /// first. Each call returns the limit from then on.
  template <typename Visit>
  void Search(const Point<D>& x, double slope, double limit, Visit visit) const
  {
    if (!this->Nodes.empty())
    {
      this->SearchBelow(0, this->Nodes.front().Bound(x, slope), x, slope, limit, visit);
    }
  }

  /// Whether `isSo` holds for all items whose boxes meet `box`: asks in the order of the tree,
  /// until one says no.
  template <typename Question>
  bool AllOf(const biting::Box<D>& box, const Question& isSo) const
  {
    return this->Nodes.empty() || this->AllBelow(this->Nodes.front(), box, isSo);
  }

private:
  static constexpr Id ItemsPerLeaf = 4;

  /// What there is to know of an item when the tree is built.
  struct Entry
  {
    biting::Box<D> Box;
    double Least;
    Id Number;
  };

  /// Leaf: items [First, First + Count). Otherwise the children are nodes First and First + 1.
  struct Node
  {
    biting::Box<D> Box;
    double Least = Infinity;
    Id First = 0;
    Id Count = 0;

    double Bound(const Point<D>& x, double slope) const
    {
      return this->Least + slope * this->Box.DistanceTo(x);
    }
  };

  /// A node that is not made yet, of entries [First, Last).
  struct Branch
  {
    Id Node;
    Id First;
    Id Last;

    Id Middle() const { return this->First + (this->Last - this->First) / 2; }
  };

  template <typename Visit>
  void SearchBelow(
    Id id, double bound, const Point<D>& x, double slope, double& limit, Visit& visit) const;
  template <typename Question>
  bool AllBelow(const Node& node, const biting::Box<D>& box, const Question& isSo) const;
  void Order(std::vector<Entry>& entries, Pulse& pulse);
  static Node Enclose(const Branch& branch, const std::vector<Entry>& entries);
  static void Halve(const Branch& branch, const biting::Box<D>& box, std::vector<Entry>& entries);
  static std::size_t NodesOf(Id items);
  void Build(const Branch& branch, std::vector<Entry>& entries, Pulse& pulse);

  std::vector<Item> Ordered;
  std::vector<Node> Nodes;
};

template <typename Item, std::size_t D>
BoxTree<Item, D>::BoxTree(std::vector<Item> items, Pulse& pulse)
{
  if (items.empty())
  {
    return;
  }
  const PulsePart part(pulse, 0.0, 0.0);
  std::vector<Entry> entries;
  entries.reserve(items.size());
  for (const Item& item : items)
  {
    entries.push_back({ item.Box(), item.Least(), static_cast<Id>(entries.size()) });
  }
  this->Nodes.reserve(NodesOf(static_cast<Id>(items.size())));
  this->Nodes.resize(1);
  if (pulse.Ask())
  {
    this->Build({ 0, 0, static_cast<Id>(entries.size()) }, entries, pulse);
  }
  this->Ordered = std::move(items);
  this->Order(entries, pulse);
  if (!pulse.Ask())
  {
    this->Nodes.clear();
    this->Ordered.clear();
  }
}

/// Item i becomes item entries[i].Number: cycle by cycle, in place.
template <typename Item, std::size_t D>
void BoxTree<Item, D>::Order(std::vector<Entry>& entries, Pulse& pulse)
{
  for (std::size_t first = 0; first < entries.size() && pulse.Beat(1); ++first)
  {
    std::size_t place = first;
    for (auto from = static_cast<std::size_t>(entries[place].Number); from != first;
         from = static_cast<std::size_t>(entries[place].Number))
    {
      std::swap(this->Ordered[place], this->Ordered[from]);
      entries[place].Number = static_cast<Id>(place);
      place = from;
    }
    entries[place].Number = static_cast<Id>(place);
  }
}

/// As a leaf.
template <typename Item, std::size_t D>
typename BoxTree<Item, D>::Node BoxTree<Item, D>::Enclose(
  const Branch& branch, const std::vector<Entry>& entries)
{
  Node node;
  node.First = branch.First;
  node.Count = branch.Last - branch.First;
  for (auto entry = entries.begin() + branch.First; entry < entries.begin() + branch.Last; ++entry)
  {
    node.Box.Add(entry->Box.Low);
    node.Box.Add(entry->Box.High);
    node.Least = std::min(node.Least, entry->Least);
  }
  return node;
}

/// Across the longest side of the box.
template <typename Item, std::size_t D>
void BoxTree<Item, D>::Halve(
  const Branch& branch, const biting::Box<D>& box, std::vector<Entry>& entries)
{
  std::size_t axis = D - 1;
  for (std::size_t d = D - 1; d-- > 0;)
  {
    axis = box.Size(d) > box.Size(axis) ? d : axis;
  }
  const auto begin = entries.begin();
  std::nth_element(begin + branch.First, begin + branch.Middle(), begin + branch.Last,
    [axis](const Entry& a, const Entry& b)
    {
      const double keyA = a.Box.Low[axis] + a.Box.High[axis];
      const double keyB = b.Box.Low[axis] + b.Box.High[axis];
      return keyA < keyB || (keyA == keyB && a.Number < b.Number);
    });
}

/// The number of nodes of a subtree with this many items.
template <typename Item, std::size_t D>
std::size_t BoxTree<Item, D>::NodesOf(Id items)
{
  return items > ItemsPerLeaf ? 1 + NodesOf(items / 2) + NodesOf(items - items / 2) : 1;
}

template <typename Item, std::size_t D>
void BoxTree<Item, D>::Build(const Branch& branch, std::vector<Entry>& entries, Pulse& pulse)
{
  if (!pulse.Beat(4 * static_cast<std::size_t>(branch.Last - branch.First)))
  {
    return;
  }
  Node node = Enclose(branch, entries);
  if (node.Count > ItemsPerLeaf)
  {
    Halve(branch, node.Box, entries);
    node.First = static_cast<Id>(this->Nodes.size());
    node.Count = 0;
    this->Nodes.resize(this->Nodes.size() + 2);
    this->Build({ node.First, branch.First, branch.Middle() }, entries, pulse);
    this->Build({ node.First + 1, branch.Middle(), branch.Last }, entries, pulse);
  }
  else
  {
    std::sort(entries.begin() + branch.First, entries.begin() + branch.Last,
      [](const Entry& a, const Entry& b) { return a.Number < b.Number; });
  }
  this->Nodes[branch.Node] = node;
}

template <typename Item, std::size_t D>
template <typename Visit>
void BoxTree<Item, D>::SearchBelow(
  Id id, double bound, const Point<D>& x, double slope, double& limit, Visit& visit) const
{
  const Node& node = this->Nodes[id];
  for (Id k = 0; k < node.Count && bound < limit; ++k)
  {
    limit = visit(this->Ordered[node.First + k], limit);
  }
  if (node.Count == 0 && bound < limit)
  {
    Id near = node.First;
    Id far = near + 1;
    double nearBound = this->Nodes[near].Bound(x, slope);
    double farBound = this->Nodes[far].Bound(x, slope);
    if (farBound < nearBound)
    {
      std::swap(near, far);
      std::swap(nearBound, farBound);
    }
    this->SearchBelow(near, nearBound, x, slope, limit, visit);
    this->SearchBelow(far, farBound, x, slope, limit, visit);
  }
}

template <typename Item, std::size_t D>
template <typename Question>
bool BoxTree<Item, D>::AllBelow(
  const Node& node, const biting::Box<D>& box, const Question& isSo) const
{
  if (!node.Box.Meets(box))
  {
    return true;
  }
  const auto first = static_cast<std::size_t>(node.First);
  for (std::size_t k = first; k < first + static_cast<std::size_t>(node.Count); ++k)
  {
    if (this->Ordered[k].Box().Meets(box) && !isSo(this->Ordered[k]))
    {
      return false;
    }
  }
  return node.Count > 0 ||
    (this->AllBelow(this->Nodes[first], box, isSo) &&
      this->AllBelow(this->Nodes[first + 1], box, isSo));
}

} // namespace biting

#endif
