// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingBoxTree_h
#define BitingBoxTree_h

#include "../Base/Box2.h"
#include "../Base/Ids.h"
#include "../Base/Numbers.h"
#include "../Base/Pulse.h"
#include "../Base/Tasks.h"

#include <algorithm> // for nth_element, sort
#include <utility>   // for swap, pairs
#include <vector>    // for the arrays

namespace biting
{

/// Branch and bound over many items: each lies in item.Box(), and its cost at x is at least
/// item.Least() plus slope times the distance from x to the box; and which of them meet a box. A
/// balanced binary tree of boxes; the cost of a search is logarithmic in ordinary cases. Items that
/// lead along item.Along(), if that is not 0, are split by their directions, too, where they are
/// about as long as the box of a node: for those whose searches know more than boxes. Built on
/// the threads of the pulse's monitor, level by level, then by subtrees; it does not depend on how
/// many these are.
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
    this->Search(x, slope, limit, visit, [](Id) { return -Infinity; });
  }

  /// The same, where more is known of nodes than their boxes: the cost there is at least
  /// leastIn(node), which is asked where the box does not tell enough.
  template <typename Visit, typename LeastIn>
  void Search(
    const Point2& x, double slope, double limit, Visit visit, const LeastIn& leastIn) const
  {
    if (!this->Nodes.empty())
    {
      this->SearchBelow(0, this->Nodes.front().Bound(x, slope), x, slope, limit, visit, leastIn);
    }
  }

  /// Calls visit(node, first, last) for each node of the tree, which has Items [first, last).
  template <typename Visit>
  void ForEachNode(Visit visit) const
  {
    if (!this->Nodes.empty())
    {
      this->VisitBelow(0, visit);
    }
  }

  /// They are numbered from 0 on.
  std::size_t NumberOfNodes() const { return this->Nodes.size(); }

  /// Whether `isSo` holds for all items whose boxes meet `box`: asks in the order of the tree,
  /// until one says no.
  template <typename Question>
  bool AllOf(const Box2& box, const Question& isSo) const
  {
    return this->Nodes.empty() || this->AllBelow(this->Nodes.front(), box, isSo);
  }

private:
  static constexpr Id ItemsPerLeaf = 4;

  /// A subtree of no more than so many is one task.
  static constexpr Id ItemsPerTask = 1 << 14;

  /// What there is to know of an item when the tree is built.
  struct Entry
  {
    Box2 Box;
    double Least;
    Id Number;
    Point2 Along;
  };

  /// By what a node is split.
  struct Order
  {
    Point2 Axis; ///< of length 1
    bool IsOfSlopes = false;

    /// Twice the middle of an entry's box, along the axis; or twice the sine of the angle from the
    /// axis to the entry.
    double Key(const Entry& entry) const
    {
      if (!this->IsOfSlopes)
      {
        return Dot(this->Axis, entry.Box.Low + entry.Box.High);
      }
      const double length = Length(entry.Along);
      const double ahead = Dot(this->Axis, entry.Along) < 0.0 ? -length : length;
      return length > 0.0 ? 2.0 * Cross(this->Axis, entry.Along) / ahead : 0.0;
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

  /// A node that is not made yet, of entries [First, Last).
  struct Branch
  {
    Id Node;
    Id First;
    Id Last;

    Id Middle() const { return this->First + (this->Last - this->First) / 2; }
  };

  template <typename Visit, typename LeastIn>
  void SearchBelow(Id id, double bound, const Point2& x, double slope, double& limit, Visit& visit,
    const LeastIn& leastIn) const;
  template <typename Visit>
  std::pair<Id, Id> VisitBelow(Id id, Visit& visit) const;
  template <typename Question>
  bool AllBelow(const Node& node, const Box2& box, const Question& isSo) const;
  void Build(std::vector<Entry>& entries, Pulse& pulse);
  std::vector<Branch> SplitAll(
    const std::vector<Branch>& branches, std::vector<Entry>& entries, Pulse& pulse);
  void Graft(const Branch& branch, const std::vector<Node>& nodes);
  static Node Enclose(const Branch& branch, const std::vector<Entry>& entries);
  static Order ChooseOrder(
    const Branch& branch, const Box2& box, const std::vector<Entry>& entries);
  static void Halve(const Branch& branch, const Box2& box, std::vector<Entry>& entries);
  static void BuildBelow(
    const Branch& branch, std::vector<Entry>& entries, std::vector<Node>& nodes, Pulse& pulse);

  std::vector<Item> Ordered;
  std::vector<Node> Nodes;
};

template <typename Item>
BoxTree<Item>::BoxTree(const std::vector<Item>& items, Pulse& pulse)
{
  if (items.empty())
  {
    return;
  }
  const PulsePart part(pulse, 0.0, 0.0);
  std::vector<Entry> entries(items.size());
  ForEachAtOnce(pulse, items.size(),
    [&items, &entries](std::size_t i) {
      entries[i] = { items[i].Box(), items[i].Least(), static_cast<Id>(i), items[i].Along() };
    });
  this->Build(entries, pulse);
  this->Ordered = items;
  ForEachAtOnce(pulse, items.size(),
    [this, &items, &entries](std::size_t i)
    { this->Ordered[i] = items[static_cast<std::size_t>(entries[i].Number)]; });
  if (pulse.HasStopped())
  {
    this->Nodes.clear();
    this->Ordered.clear();
  }
}

template <typename Item>
void BoxTree<Item>::Build(std::vector<Entry>& entries, Pulse& pulse)
{
  this->Nodes.resize(1);
  std::vector<Branch> branches{ { 0, 0, static_cast<Id>(entries.size()) } };
  while (branches.back().Last - branches.back().First > ItemsPerTask && !pulse.HasStopped())
  {
    branches = this->SplitAll(branches, entries, pulse);
  }
  std::vector<std::vector<Node>> parts(branches.size());
  DoTasks(pulse, branches.size(),
    [&branches, &entries, &parts](std::size_t k, Monitor& monitor)
    {
      Pulse own(monitor);
      parts[k].resize(1);
      BuildBelow({ 0, branches[k].First, branches[k].Last }, entries, parts[k], own);
    });
  for (std::size_t k = 0; k < branches.size(); ++k)
  {
    this->Graft(branches[k], parts[k]);
  }
}

/// Makes the nodes of the branches; returns those below them. The last of each level is the
/// largest.
template <typename Item>
std::vector<typename BoxTree<Item>::Branch> BoxTree<Item>::SplitAll(
  const std::vector<Branch>& branches, std::vector<Entry>& entries, Pulse& pulse)
{
  const auto firstChild = static_cast<Id>(this->Nodes.size());
  this->Nodes.resize(this->Nodes.size() + 2 * branches.size());
  std::vector<Branch> below;
  for (const Branch& branch : branches)
  {
    const Id child = firstChild + static_cast<Id>(below.size());
    below.push_back({ child, branch.First, branch.Middle() });
    below.push_back({ child + 1, branch.Middle(), branch.Last });
  }
  DoTasks(pulse, branches.size(),
    [this, &branches, &below, &entries](std::size_t k, Monitor&)
    {
      Node node = Enclose(branches[k], entries);
      Halve(branches[k], node.Box, entries);
      node.First = below[2 * k].Node;
      node.Count = 0;
      this->Nodes[static_cast<std::size_t>(branches[k].Node)] = node;
    });
  return below;
}

/// Takes the nodes of a subtree over, the first as that of the branch.
template <typename Item>
void BoxTree<Item>::Graft(const Branch& branch, const std::vector<Node>& nodes)
{
  const auto shift = static_cast<Id>(this->Nodes.size()) - 1;
  for (std::size_t k = 0; k < nodes.size(); ++k)
  {
    Node node = nodes[k];
    node.First += node.Count == 0 ? shift : 0;
    if (k == 0)
    {
      this->Nodes[static_cast<std::size_t>(branch.Node)] = node;
    }
    else
    {
      this->Nodes.push_back(node);
    }
  }
}

/// As a leaf.
template <typename Item>
typename BoxTree<Item>::Node BoxTree<Item>::Enclose(
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

/// Across the longer side of the box. Where items are about as long as that their boxes overlap
/// however they are split: there the two halves shall be narrow, seen along the longest item.
template <typename Item>
typename BoxTree<Item>::Order BoxTree<Item>::ChooseOrder(
  const Branch& branch, const Box2& box, const std::vector<Entry>& entries)
{
  constexpr double LengthOfLong = 0.6;
  const auto begin = entries.begin() + branch.First;
  const auto end = entries.begin() + branch.Last;
  Point2 longest;
  double sum = 0.0;
  for (auto entry = begin; entry < end; ++entry)
  {
    sum += Length(entry->Along);
    longest = Dot(longest, longest) < Dot(entry->Along, entry->Along) ? entry->Along : longest;
  }
  if (sum <= LengthOfLong * (branch.Last - branch.First) * std::max(box.Width(), box.Height()))
  {
    return { box.Width() > box.Height() ? Point2{ 1.0, 0.0 } : Point2{ 0.0, 1.0 } };
  }
  const auto rangeOf = [begin, end](const Order& order)
  {
    double low = Infinity;
    double high = -Infinity;
    for (auto entry = begin; entry < end; ++entry)
    {
      low = std::min(low, order.Key(*entry));
      high = std::max(high, order.Key(*entry));
    }
    return high - low;
  };
  const double length = Length(longest);
  const Order along{ (1.0 / length) * longest };
  const Order across{ Perpendicular(along.Axis) };
  const Order slope{ along.Axis, true };
  const double width = rangeOf(across);
  const double turn = 0.5 * length * rangeOf(slope);
  if (rangeOf(along) - length > std::max(width, turn))
  {
    return along;
  }
  return width > turn ? across : slope;
}

template <typename Item>
void BoxTree<Item>::Halve(const Branch& branch, const Box2& box, std::vector<Entry>& entries)
{
  const Order order = ChooseOrder(branch, box, entries);
  const auto begin = entries.begin();
  std::nth_element(begin + branch.First, begin + branch.Middle(), begin + branch.Last,
    [order](const Entry& a, const Entry& b)
    {
      const double keyA = order.Key(a);
      const double keyB = order.Key(b);
      return keyA < keyB || (keyA == keyB && a.Number < b.Number);
    });
}

template <typename Item>
void BoxTree<Item>::BuildBelow(
  const Branch& branch, std::vector<Entry>& entries, std::vector<Node>& nodes, Pulse& pulse)
{
  if (!pulse.Beat(4 * static_cast<std::size_t>(branch.Last - branch.First)))
  {
    return;
  }
  Node node = Enclose(branch, entries);
  if (node.Count > ItemsPerLeaf)
  {
    Halve(branch, node.Box, entries);
    node.First = static_cast<Id>(nodes.size());
    node.Count = 0;
    nodes.resize(nodes.size() + 2);
    BuildBelow({ node.First, branch.First, branch.Middle() }, entries, nodes, pulse);
    BuildBelow({ node.First + 1, branch.Middle(), branch.Last }, entries, nodes, pulse);
  }
  else
  {
    std::sort(entries.begin() + branch.First, entries.begin() + branch.Last,
      [](const Entry& a, const Entry& b) { return a.Number < b.Number; });
  }
  nodes[static_cast<std::size_t>(branch.Node)] = node;
}

template <typename Item>
template <typename Visit, typename LeastIn>
void BoxTree<Item>::SearchBelow(Id id, double bound, const Point2& x, double slope, double& limit,
  Visit& visit, const LeastIn& leastIn) const
{
  const Node& node = this->Nodes[static_cast<std::size_t>(id)];
  for (Id k = 0; k < node.Count && bound < limit; ++k)
  {
    limit = visit(this->Ordered[static_cast<std::size_t>(node.First + k)], limit);
  }
  if (node.Count == 0 && bound < limit)
  {
    Id near = node.First;
    Id far = near + 1;
    const auto boundOf = [this, &x, slope, limit, &leastIn](Id child)
    {
      const double least = this->Nodes[static_cast<std::size_t>(child)].Bound(x, slope);
      return least < limit ? std::max(least, leastIn(child)) : least;
    };
    double nearBound = boundOf(near);
    double farBound = boundOf(far);
    if (farBound < nearBound)
    {
      std::swap(near, far);
      std::swap(nearBound, farBound);
    }
    this->SearchBelow(near, nearBound, x, slope, limit, visit, leastIn);
    this->SearchBelow(far, farBound, x, slope, limit, visit, leastIn);
  }
}

/// Returns its items.
template <typename Item>
template <typename Visit>
std::pair<Id, Id> BoxTree<Item>::VisitBelow(Id id, Visit& visit) const
{
  const Node& node = this->Nodes[static_cast<std::size_t>(id)];
  const std::pair<Id, Id> items = node.Count > 0
    ? std::make_pair(node.First, node.First + node.Count)
    : std::make_pair(
        this->VisitBelow(node.First, visit).first, this->VisitBelow(node.First + 1, visit).second);
  visit(id, items.first, items.second);
  return items;
}

template <typename Item>
template <typename Question>
bool BoxTree<Item>::AllBelow(const Node& node, const Box2& box, const Question& isSo) const
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
