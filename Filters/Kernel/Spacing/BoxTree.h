// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingBoxTree_h
#define BitingBoxTree_h

#include "../Base/Box2.h"
#include "../Base/Ids.h"
#include "../Base/Pulse.h"

#include <utility> // for swap
#include <vector>  // for the arrays

namespace biting
{

/// Branch and bound over many items: each lies in a box, and its cost at x is at least its value
/// plus slope times the distance from x to the box. A balanced binary tree of boxes; the cost of a
/// search is logarithmic in ordinary cases.
class BoxTree
{
public:
  struct Item
  {
    Box2 Box;
    double Value = 0.0;
  };

  BoxTree() = default;

  /// Empty if the pulse stops.
  BoxTree(const std::vector<Item>& items, Pulse& pulse);

  /// The items in the order of the tree: items near each other have positions near each other. It
  /// depends on the items alone.
  const std::vector<Id>& Order() const { return this->Items; }

  /// Calls visit(position, limit) for all items whose cost at x may be below `limit`, likely ones
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
  /// Leaf: positions [First, First + Count). Otherwise the children are nodes First and First + 1.
  struct Node
  {
    Box2 Box;
    double Value = 0.0;
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
      return this->Value + slope * Length({ across, along });
    }
  };

  template <typename Visit>
  void SearchBelow(const Node& node, double bound, const Point2& x, double slope, double& limit,
    Visit& visit) const;
  void Build(const std::vector<Item>& items, Id nodeId, Id first, Id last, Pulse& pulse);

  std::vector<Id> Items;
  std::vector<Node> Nodes;
};

template <typename Visit>
void BoxTree::SearchBelow(
  const Node& node, double bound, const Point2& x, double slope, double& limit, Visit& visit) const
{
  for (Id k = 0; k < node.Count && bound < limit; ++k)
  {
    limit = visit(node.First + k, limit);
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
