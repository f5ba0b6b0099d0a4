// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSegmentTree_h
#define BitingSegmentTree_h

#include "../Base/Box.h"
#include "../Base/Ids.h"
#include "../Base/Numbers.h" // for Infinity
#include "../Base/Point.h"
#include "../Base/Pulse.h"
#include "SlantedBox.h"

#include <algorithm> // for min
#include <cmath>     // for abs
#include <cstddef>   // for size_t
#include <cstdint>   // for masks
#include <vector>    // for nodes and items

namespace biting
{

/// A segment by the numbers of its end vertices.
struct SegmentEnds
{
  Id Start = NoId;
  Id End = NoId;

  bool Has(Id vertex) const { return this->Start == vertex || this->End == vertex; }
};

struct Domain;

/// The segments of the domain by their numbers, then its embedded points as segments from a vertex
/// to itself.
std::vector<SegmentEnds> SegmentsAndPoints(const Domain& domain);

/// A tree of boxes over segments: which segments may come near a place. Built in O(n log n).
///
/// Segments that share an end are not asked about one another (see VertexStars): a node whose
/// segments all end at one vertex is passed over as a whole, so that a fan of n spokes does not
/// cost n^2 pairs.
///
/// A node also has a slanted box along its longest segment, so that segments which run side by side
/// are told apart in any direction. Segments of very different lengths lie in different nodes, as a
/// long one makes the boxes of short ones large.
class SegmentTree
{
public:
  /// What is added to a box, on all sides: `Most`, but no more than `PerLength` times the length
  /// (1-norm) of a segment that has one.
  struct Margins
  {
    double Most;
    double PerLength;

    Margins(double most = 0.0, double perLength = Infinity)
      : Most(most)
      , PerLength(perLength)
    {
    }

    double Of(double length) const
    {
      return length > 0.0 ? std::min(this->Most, this->PerLength * length) : this->Most;
    }
  };

  /// Where the monitor wants to stop, the tree is left unfinished: not to be asked.
  SegmentTree(const std::vector<Point2>& points, const std::vector<SegmentEnds>& segments,
    const Margins& margins, Pulse& pulse);

  /// Calls visit(segment) for each segment without an end in `skipped` that may come within its
  /// margin of `extent`, at least all that do. The order is that of the tree.
  template <typename Visitor>
  void Visit(const SlantedBox& extent, const SegmentEnds& skipped, Visitor&& visit) const
  {
    if (this->Nodes.empty())
    {
      return;
    }
    this->WalkBelow(
      0,
      [this, &extent, &skipped](const Node& node)
      { return !IsFanOf(node.Common, skipped) && this->MayMeet(extent, node); },
      [this, &extent, &skipped, &visit](const Item& item)
      {
        if (!item.Ends.Has(skipped.Start) && !item.Ends.Has(skipped.End) &&
          this->MayMeet(extent, item.Bounds))
        {
          visit(item.Segment);
        }
      });
  }

  /// Calls visitor(first, second) once for each pair of segments without a common end whose grown
  /// boxes meet and of which one is wanted; the order is that of the tree. Before each step it asks
  /// visitor.GoesOn(), and ends where that is false; visitor.SetFraction(x) hears how far it is.
  ///
  /// Walks down the tree in pairs of nodes, the larger first: short segments share all of the way.
  template <typename Visitor>
  void VisitPairs(const std::vector<std::uint8_t>& isWanted, Visitor& visitor) const
  {
    if (!this->Nodes.empty())
    {
      this->VisitPairsOf({ 0, 0 }, isWanted, this->WantedBefore(isWanted), visitor);
    }
  }

  /// Two nodes, the larger first, or one twice: part of the pairs.
  struct PairPart
  {
    Id First;
    Id Second;
  };

  /// Parts that have all pairs together, each once, of some thousand segments each. They do not
  /// depend on threads.
  std::vector<PairPart> PairParts() const;

  /// VisitPairs for one part. `wantedBefore` is WantedBefore(isWanted).
  template <typename Visitor>
  void VisitPairsOf(const PairPart& part, const std::vector<std::uint8_t>& isWanted,
    const std::vector<Id>& wantedBefore, Visitor& visitor) const
  {
    PairWalk<Visitor>(*this, isWanted, wantedBefore, visitor).Join(part);
  }

  /// How many of the items of the tree before each are wanted.
  std::vector<Id> WantedBefore(const std::vector<std::uint8_t>& isWanted) const;

  /// By which segments are longer than others: in the 1-norm.
  static double LengthOf(const Point2& start, const Point2& end)
  {
    return std::abs(end.X - start.X) + std::abs(end.Y - start.Y);
  }

private:
  class Builder;

  struct Item
  {
    Box2 Bounds;
    SegmentEnds Ends;
    Id Segment = NoId;
    bool Rises = true;     ///< from the low left to the high right of its box, or it falls
    double Shortest = 0.0; ///< its own length
  };

  /// Nodes lie in preorder: the first child follows its parent, Next is the node after the subtree.
  struct Node : SlantedBox
  {
    SegmentEnds Common; ///< vertices at which every segment of the subtree ends
    Id Next = NoId;
    Id FirstItem = 0;
    Id LastItem = 0; ///< one past
    double Shortest = 0.0;

    Id NumberOfItems() const { return this->LastItem - this->FirstItem; }
  };

  /// Joins nodes, and items with nodes.
  template <typename Visitor>
  class PairWalk
  {
  public:
    PairWalk(const SegmentTree& tree, const std::vector<std::uint8_t>& isWanted,
      const std::vector<Id>& wantedBefore, Visitor& visitor)
      : Tree(tree)
      , IsWanted(isWanted)
      , WantedBefore(wantedBefore)
      , Visit(visitor)
    {
    }

    void Join(const PairPart& part)
    {
      const Node& a = this->Tree.NodeAt(part.First);
      const Node& b = this->Tree.NodeAt(part.Second);
      const bool isWanted = this->HasWanted(a) || this->HasWanted(b);
      if (!isWanted || !this->Tree.MayMeet(part) || !this->Visit.GoesOn())
      {
        return;
      }
      if (this->Tree.IsLeaf(part.First))
      {
        part.First == part.Second ? this->JoinItemsOf(a) : this->JoinItems(a, part.Second);
        return;
      }
      this->Tree.VisitBelow(part, [this](const PairPart& below) { this->Join(below); });
    }

  private:
    void JoinItemsOf(const Node& leaf)
    {
      for (Id i = leaf.FirstItem; i < leaf.LastItem; ++i)
      {
        for (Id j = i + 1; j < leaf.LastItem; ++j)
        {
          this->Pair(this->Tree.ItemAt(i), this->Tree.ItemAt(j));
        }
      }
      this->Visit.SetFraction(
        static_cast<double>(leaf.LastItem) / static_cast<double>(this->Tree.Items.size()));
    }

    void JoinItems(const Node& leaf, Id top)
    {
      for (Id i = leaf.FirstItem; i < leaf.LastItem && this->Visit.GoesOn(); ++i)
      {
        const Item& item = this->Tree.ItemAt(i);
        const SlantedBox extent = this->Tree.BoxOf(item);
        this->Tree.WalkBelow(
          top,
          [this, &item, &extent](const Node& node)
          { return !IsFanOf(node.Common, item.Ends) && this->Tree.MayMeet(extent, node); },
          [this, &item](const Item& other) { this->Pair(item, other); });
      }
    }

    void Pair(const Item& a, const Item& b)
    {
      const bool isWanted = this->IsWanted[a.Segment] || this->IsWanted[b.Segment];
      if (isWanted && a.Bounds.Meets(b.Bounds) && !a.Ends.Has(b.Ends.Start) &&
        !a.Ends.Has(b.Ends.End) && this->Visit.GoesOn())
      {
        this->Visit(a.Segment, b.Segment);
      }
    }

    bool HasWanted(const Node& node) const
    {
      return this->WantedBefore[node.FirstItem] != this->WantedBefore[node.LastItem];
    }

    const SegmentTree& Tree;
    const std::vector<std::uint8_t>& IsWanted;
    const std::vector<Id>& WantedBefore; ///< how many of the items before each
    Visitor& Visit;
  };

  /// Calls visit(item) for the items of all leaves, from node `top` down, that the condition leads
  /// to.
  template <typename Condition, typename Visitor>
  void WalkBelow(Id top, const Condition& leads, const Visitor& visit) const
  {
    const Id end = this->NodeAt(top).Next;
    for (Id node = top; node < end;)
    {
      const Node& here = this->NodeAt(node);
      if (!leads(here))
      {
        node = here.Next;
        continue;
      }
      const Id last = this->IsLeaf(node) ? here.LastItem : here.FirstItem;
      for (Id i = here.FirstItem; i < last; ++i)
      {
        visit(this->ItemAt(i));
      }
      ++node;
    }
  }

  static bool IsFanOf(const SegmentEnds& common, const SegmentEnds& skipped)
  {
    return (common.Start != NoId && skipped.Has(common.Start)) ||
      (common.End != NoId && skipped.Has(common.End));
  }

  bool MayMeet(const SlantedBox& a, const SlantedBox& b) const
  {
    return a.Bounds.Meets(b.Bounds) && !a.IsBeside(b, this->Slack) && !b.IsBeside(a, this->Slack);
  }

  bool MayMeet(const PairPart& part) const
  {
    const Node& a = this->NodeAt(part.First);
    const Node& b = this->NodeAt(part.Second);
    return !IsFanOf(a.Common, b.Common) && (part.First == part.Second || this->MayMeet(a, b));
  }

  /// Calls visit(part) for what a part consists of whose larger node is no leaf.
  template <typename Visitor>
  void VisitBelow(const PairPart& part, const Visitor& visit) const
  {
    const Id first = part.First + 1;
    const Id second = this->NodeAt(first).Next;
    if (part.First == part.Second)
    {
      visit(PairPart{ first, first });
      visit(PairPart{ second, second });
      visit(this->LargerFirst(first, second));
      return;
    }
    visit(this->LargerFirst(first, part.Second));
    visit(this->LargerFirst(second, part.Second));
  }

  PairPart LargerFirst(Id a, Id b) const
  {
    return this->NodeAt(a).Size() >= this->NodeAt(b).Size() ? PairPart{ a, b } : PairPart{ b, a };
  }

  const Node& NodeAt(Id node) const { return this->Nodes[node]; }
  const Item& ItemAt(Id item) const { return this->Items[item]; }
  bool IsLeaf(Id node) const { return this->NodeAt(node).Next == node + 1; }
  SlantedBox BoxOf(const Item& item) const;

  std::vector<Item> Items;
  std::vector<Node> Nodes;
  Margins Grown;
  double Slack = 0.0; ///< rounding of the sides of slanted boxes
};

} // namespace biting

#endif
