// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSegmentTree_h
#define BitingSegmentTree_h

#include "../Base/Box.h"
#include "../Base/BoxTree.h"
#include "../Base/Ids.h"
#include "../Base/Numbers.h" // for Infinity
#include "../Base/Point.h"
#include "../Base/Pulse.h"

#include <algorithm> // for min
#include <cstddef>   // for size_t
#include <cstdint>   // for masks
#include <vector>    // for items

namespace biting
{

/// A segment by the numbers of its end vertices.
struct SegmentEnds
{
  Id Start = NoId;
  Id End = NoId;

  bool Has(Id vertex) const { return this->Start == vertex || this->End == vertex; }
  bool Meets(const SegmentEnds& other) const
  {
    return this->Has(other.Start) || this->Has(other.End);
  }
};

struct Domain;

/// The segments of the domain by their numbers, then its embedded points as segments from a vertex
/// to itself.
std::vector<SegmentEnds> SegmentsAndPoints(const Domain& domain);

/// The boxes of segments in a tree: which segments may come near a place. Built in O(n log n).
/// Segments that share an end are not asked about one another (see VertexStars).
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

  /// Where the monitor wants to stop it is empty.
  SegmentTree(const std::vector<Point2>& points, const std::vector<SegmentEnds>& segments,
    const Margins& margins, Pulse& pulse)
    : Tree(ItemsOf(points, segments, margins), pulse)
  {
  }

  std::size_t Size() const { return this->Tree.Items().size(); }

  /// Calls visit(segment) for each segment without an end in `skipped` whose grown box meets `box`.
  /// The order is that of the tree.
  template <typename Visitor>
  void Visit(const Box2& box, const SegmentEnds& skipped, Visitor&& visit) const
  {
    this->Tree.AllOf(box,
      [&skipped, &visit](const Item& item)
      {
        if (!item.Ends.Meets(skipped))
        {
          visit(item.Segment);
        }
        return true;
      });
  }

  /// Calls visitor(first, second) once for each pair of segments without a common end whose grown
  /// boxes meet and of which one is wanted; the order is that of the tree. Before each step it asks
  /// visitor.GoesOn(), and ends where that is false; visitor.SetFraction(x) hears how far it is.
  template <typename Visitor>
  void VisitPairs(const std::vector<std::uint8_t>& isWanted, Visitor& visitor) const
  {
    this->VisitPairsOf(0, this->Size(), isWanted, visitor);
  }

  /// A part of these pairs: for the items first .. last - 1 of all there are, Size().
  template <typename Visitor>
  void VisitPairsOf(std::size_t first, std::size_t last, const std::vector<std::uint8_t>& isWanted,
    Visitor& visitor) const
  {
    const std::vector<Item>& items = this->Tree.Items();
    for (std::size_t k = first; k < last && visitor.GoesOn(); ++k)
    {
      const Item& own = items[k];
      visitor.SetFraction(static_cast<double>(k) / static_cast<double>(items.size()));
      if (isWanted[own.Segment])
      {
        this->Tree.AllOf(own.Bounds,
          [&own, &isWanted, &visitor](const Item& other)
          {
            const bool isDone = isWanted[other.Segment] && other.Segment < own.Segment;
            if (isDone || own.Ends.Meets(other.Ends))
            {
              return true;
            }
            const bool goesOn = visitor.GoesOn();
            if (goesOn)
            {
              visitor(own.Segment, other.Segment);
            }
            return goesOn;
          });
      }
    }
  }

private:
  struct Item
  {
    Box2 Bounds; ///< grown
    SegmentEnds Ends;
    Id Segment = NoId;

    // For a BoxTree.
    const Box2& Box() const { return this->Bounds; }
    double Least() const { return 0.0; }
  };

  static std::vector<Item> ItemsOf(const std::vector<Point2>& points,
    const std::vector<SegmentEnds>& segments, const Margins& margins);

  BoxTree<Item> Tree;
};

} // namespace biting

#endif
