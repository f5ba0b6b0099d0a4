// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSegmentTree_h
#define BitingSegmentTree_h

#include "../Base/Box2.h"
#include "../Base/Ids.h"
#include "../Base/Point2.h"
#include "../Base/Pulse.h"

#include <cmath>  // for abs
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
  /// `margin` is added to every box, on all sides. Where the monitor wants to stop, the tree is left
  /// unfinished: not to be asked.
  SegmentTree(const std::vector<Point2>& points, const std::vector<SegmentEnds>& segments,
    double margin, Pulse& pulse);
  SegmentTree(
    const std::vector<Point2>& points, const std::vector<SegmentEnds>& segments, double margin);

  /// Calls visit(segment) for each segment whose grown box meets `box` and that has no end in
  /// `skipped`. The order is that of the tree.
  template <typename Visitor>
  void Visit(const Box2& box, const SegmentEnds& skipped, Visitor&& visit) const
  {
    const auto meets = [&box](const auto& part) { return part.Bounds.Meets(box); };
    this->VisitWhere(meets, skipped, visit);
  }

  /// Calls visit(segment) for each segment without an end in `skipped` whose grown box the segment
  /// from `start` to `end` meets; and for some whose box it passes within a few roundings. Segments
  /// longer than `longest` may be left out.
  ///
  /// A box says much about where a short segment is and little about a long one. Where each pair is
  /// asked for by the longer of the two, a crowd of long segments costs the short ones nothing.
  template <typename Visitor>
  void VisitAlong(const Point2& start, const Point2& end, double longest,
    const SegmentEnds& skipped, Visitor&& visit) const
  {
    const Probe probe(start, end, this->Rounding);
    const auto meets = [&probe, longest](const auto& part)
    { return part.Shortest <= longest && probe.Meets(part.Bounds); };
    this->VisitWhere(meets, skipped, visit);
  }

  /// By which segments are longer than others: in the 1-norm.
  static double LengthOf(const Point2& start, const Point2& end)
  {
    return std::abs(end.X - start.X) + std::abs(end.Y - start.Y);
  }

private:
  struct Item
  {
    Box2 Bounds;
    SegmentEnds Ends;
    Id Segment = NoId;
    double Shortest = 0.0; ///< its own length
  };

  /// Nodes lie in preorder: the first child follows its parent, Next is the node after the subtree.
  struct Node
  {
    Box2 Bounds;
    SegmentEnds Common; ///< vertices at which every segment of the subtree ends
    Id Next = NoId;
    Id FirstItem = 0; ///< leaves only
    Id ItemCount = 0; ///< 0: an inner node
    double Shortest = 0.0;
  };

  /// A segment that asks which boxes it meets.
  class Probe
  {
  public:
    Probe(const Point2& start, const Point2& end, double rounding)
      : Start(start)
      , Direction(end - start)
      , Slack(rounding * (std::abs(this->Direction.X) + std::abs(this->Direction.Y)))
    {
      this->Bounds.Add(start);
      this->Bounds.Add(end);
    }

    /// Whether the line through the segment separates the corners of a box that meets its own.
    bool Meets(const Box2& box) const
    {
      const double reach = 0.5 *
        (std::abs(this->Direction.X) * box.Height() + std::abs(this->Direction.Y) * box.Width());
      return this->Bounds.Meets(box) &&
        std::abs(Cross(this->Direction, box.Center() - this->Start)) <= reach + this->Slack;
    }

  private:
    Point2 Start;
    Point2 Direction;
    double Slack;
    Box2 Bounds;
  };

  template <typename Condition, typename Visitor>
  void VisitWhere(const Condition& meets, const SegmentEnds& skipped, Visitor& visit) const
  {
    Id node = 0;
    while (node < static_cast<Id>(this->Nodes.size()))
    {
      const Node& here = this->Nodes[static_cast<std::size_t>(node)];
      if (IsFanOf(here.Common, skipped) || !meets(here))
      {
        node = here.Next;
        continue;
      }
      this->VisitItems(here, meets, skipped, visit);
      ++node;
    }
  }

  static bool IsFanOf(const SegmentEnds& common, const SegmentEnds& skipped)
  {
    return (common.Start != NoId && skipped.Has(common.Start)) ||
      (common.End != NoId && skipped.Has(common.End));
  }

  template <typename Condition, typename Visitor>
  void VisitItems(
    const Node& node, const Condition& meets, const SegmentEnds& skipped, Visitor& visit) const
  {
    for (Id i = node.FirstItem; i < node.FirstItem + node.ItemCount; ++i)
    {
      const Item& item = this->Items[static_cast<std::size_t>(i)];
      if (!item.Ends.Has(skipped.Start) && !item.Ends.Has(skipped.End) && meets(item))
      {
        visit(item.Segment);
      }
    }
  }

  void FileItems(
    const std::vector<Point2>& points, const std::vector<SegmentEnds>& segments, double margin);
  void Build(Id first, Id last, Pulse& pulse);
  void Halve(Id first, Id middle, Id last);

  std::vector<Item> Items;
  std::vector<Node> Nodes;
  double Rounding = 0.0; ///< of a cross product with a direction, over the latter's 1-norm
};

} // namespace biting

#endif
