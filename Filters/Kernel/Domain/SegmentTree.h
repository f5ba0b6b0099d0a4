// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSegmentTree_h
#define BitingSegmentTree_h

#include "../Base/Box2.h"
#include "../Base/Ids.h"
#include "../Base/Point2.h"

#include <vector> // for nodes and items

namespace biting
{

/// A segment by the numbers of its end vertices.
struct SegmentEnds
{
  Id Start = NoId;
  Id End = NoId;

  bool Has(Id vertex) const { return this->Start == vertex || this->End == vertex; }
};

/// A tree of boxes over segments: which segments may come near a place. Built in O(n log n).
///
/// Segments that share an end are not asked about one another (see VertexStars): a node whose
/// segments all end at one vertex is passed over as a whole, so that a fan of n spokes does not cost
/// n^2 pairs.
class SegmentTree
{
public:
  /// `margin` is added to every box, on all sides.
  SegmentTree(
    const std::vector<Point2>& points, const std::vector<SegmentEnds>& segments, double margin);

  /// Calls visit(segment) for each segment whose grown box meets `box` and that has no end in
  /// `skipped`. The order is that of the tree.
  template <typename Visitor>
  void Visit(const Box2& box, const SegmentEnds& skipped, Visitor&& visit) const
  {
    Id node = 0;
    while (node < static_cast<Id>(this->Nodes.size()))
    {
      const Node& here = this->Nodes[static_cast<std::size_t>(node)];
      if (!here.Bounds.Meets(box) || IsFanOf(here.Common, skipped))
      {
        node = here.Next;
        continue;
      }
      this->VisitItems(here, box, skipped, visit);
      ++node;
    }
  }

private:
  struct Item
  {
    Box2 Bounds;
    SegmentEnds Ends;
    Id Segment = NoId;
  };

  /// Nodes lie in preorder: the first child follows its parent, Next is the node after the subtree.
  struct Node
  {
    Box2 Bounds;
    SegmentEnds Common; ///< vertices at which every segment of the subtree ends
    Id Next = NoId;
    Id FirstItem = 0; ///< leaves only
    Id ItemCount = 0; ///< 0: an inner node
  };

  static bool IsFanOf(const SegmentEnds& common, const SegmentEnds& skipped)
  {
    return (common.Start != NoId && skipped.Has(common.Start)) ||
      (common.End != NoId && skipped.Has(common.End));
  }

  template <typename Visitor>
  void VisitItems(
    const Node& node, const Box2& box, const SegmentEnds& skipped, Visitor& visit) const
  {
    for (Id i = node.FirstItem; i < node.FirstItem + node.ItemCount; ++i)
    {
      const Item& item = this->Items[static_cast<std::size_t>(i)];
      if (item.Bounds.Meets(box) && !item.Ends.Has(skipped.Start) && !item.Ends.Has(skipped.End))
      {
        visit(item.Segment);
      }
    }
  }

  void Build(Id first, Id last);
  void Halve(Id first, Id middle, Id last);

  std::vector<Item> Items;
  std::vector<Node> Nodes;
};

} // namespace biting

#endif
