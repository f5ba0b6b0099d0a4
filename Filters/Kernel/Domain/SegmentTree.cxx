// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SegmentTree.h"

#include <algorithm> // for nth_element, min, max
#include <cstddef>   // for size_t
#include <limits>    // for epsilon

namespace biting
{

namespace
{

constexpr Id LeafSize = 6;

SegmentEnds CommonVertices(const SegmentEnds& a, const SegmentEnds& b)
{
  return { a.Start != NoId && b.Has(a.Start) ? a.Start : NoId,
    a.End != NoId && b.Has(a.End) ? a.End : NoId };
}

void AddBox(Box2& bounds, const Box2& other)
{
  bounds.Add(other.Low);
  bounds.Add(other.High);
}

} // namespace

SegmentTree::SegmentTree(
  const std::vector<Point2>& points, const std::vector<SegmentEnds>& segments, double margin)
{
  SilentMonitor monitor;
  Pulse pulse(monitor);
  *this = SegmentTree(points, segments, margin, pulse);
}

SegmentTree::SegmentTree(const std::vector<Point2>& points,
  const std::vector<SegmentEnds>& segments, double margin, Pulse& pulse)
{
  this->FileItems(points, segments, margin);
  if (!this->Items.empty() && pulse.Ask())
  {
    this->Nodes.reserve(this->Items.size());
    this->Build(0, static_cast<Id>(this->Items.size()), pulse);
  }
}

/// With u the unit roundoff and M the largest coordinate, the centre of a box and half its sides are
/// off by at most 2 u M, so their products with a direction by 8 u M times its 1-norm.
void SegmentTree::FileItems(
  const std::vector<Point2>& points, const std::vector<SegmentEnds>& segments, double margin)
{
  double largest = 0.0;
  this->Items.reserve(segments.size());
  for (const SegmentEnds& ends : segments)
  {
    Item item;
    const Point2& start = points[static_cast<std::size_t>(ends.Start)];
    const Point2& end = points[static_cast<std::size_t>(ends.End)];
    item.Shortest = LengthOf(start, end);
    item.Bounds.Add(start);
    item.Bounds.Add(end);
    item.Bounds.Grow(margin);
    item.Ends = ends;
    item.Segment = static_cast<Id>(this->Items.size());
    this->Items.push_back(item);
    largest = std::max({ largest, std::abs(item.Bounds.Low.X), std::abs(item.Bounds.Low.Y),
      std::abs(item.Bounds.High.X), std::abs(item.Bounds.High.Y) });
  }
  this->Rounding = 8.0 * std::numeric_limits<double>::epsilon() * largest;
}

void SegmentTree::Build(Id first, Id last, Pulse& pulse)
{
  const std::size_t index = this->Nodes.size();
  Node node;
  node.Common = this->Items[static_cast<std::size_t>(first)].Ends;
  node.Shortest = this->Items[static_cast<std::size_t>(first)].Shortest;
  for (Id i = first; i < last; ++i)
  {
    const Item& item = this->Items[static_cast<std::size_t>(i)];
    AddBox(node.Bounds, item.Bounds);
    node.Common = CommonVertices(node.Common, item.Ends);
    node.Shortest = std::min(node.Shortest, item.Shortest);
  }
  const bool isLeaf = last - first <= LeafSize;
  node.FirstItem = first;
  node.ItemCount = isLeaf ? last - first : 0;
  this->Nodes.push_back(node);
  if (!isLeaf && pulse.Beat(last - first))
  {
    const Id middle = first + (last - first) / 2;
    this->Halve(first, middle, last);
    this->Build(first, middle, pulse);
    this->Build(middle, last, pulse);
  }
  this->Nodes[index].Next = static_cast<Id>(this->Nodes.size());
}

/// Parts the items at the median of their centres, along the longer side of the centres' box.
void SegmentTree::Halve(Id first, Id middle, Id last)
{
  Box2 centers;
  for (Id i = first; i < last; ++i)
  {
    centers.Add(this->Items[static_cast<std::size_t>(i)].Bounds.Center());
  }
  const bool alongX = centers.Width() >= centers.Height();
  const auto isBefore = [alongX](const Item& a, const Item& b)
  {
    const Point2 p = a.Bounds.Center();
    const Point2 q = b.Bounds.Center();
    const double left = alongX ? p.X : p.Y;
    const double right = alongX ? q.X : q.Y;
    return left < right || (left == right && a.Segment < b.Segment);
  };
  const auto begin = this->Items.begin();
  std::nth_element(begin + first, begin + middle, begin + last, isBefore);
}

} // namespace biting
