// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SegmentTree.h"

#include <algorithm> // for nth_element
#include <cstddef>   // for size_t

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
  this->Items.reserve(segments.size());
  for (const SegmentEnds& ends : segments)
  {
    Item item;
    item.Bounds.Add(points[static_cast<std::size_t>(ends.Start)]);
    item.Bounds.Add(points[static_cast<std::size_t>(ends.End)]);
    item.Bounds.Grow(margin);
    item.Ends = ends;
    item.Segment = static_cast<Id>(this->Items.size());
    this->Items.push_back(item);
  }
  if (!this->Items.empty())
  {
    this->Build(0, static_cast<Id>(this->Items.size()));
  }
}

void SegmentTree::Build(Id first, Id last)
{
  const std::size_t index = this->Nodes.size();
  Node node;
  node.Common = this->Items[static_cast<std::size_t>(first)].Ends;
  for (Id i = first; i < last; ++i)
  {
    AddBox(node.Bounds, this->Items[static_cast<std::size_t>(i)].Bounds);
    node.Common = CommonVertices(node.Common, this->Items[static_cast<std::size_t>(i)].Ends);
  }
  const bool isLeaf = last - first <= LeafSize;
  node.FirstItem = first;
  node.ItemCount = isLeaf ? last - first : 0;
  this->Nodes.push_back(node);
  if (!isLeaf)
  {
    const Id middle = first + (last - first) / 2;
    this->Halve(first, middle, last);
    this->Build(first, middle);
    this->Build(middle, last);
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
