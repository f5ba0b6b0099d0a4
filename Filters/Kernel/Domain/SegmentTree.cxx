// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SegmentTree.h"

#include "Domain.h"

#include <algorithm> // for nth_element, partition, min, max
#include <cmath>     // for sqrt
#include <limits>    // for epsilon

namespace biting
{

namespace
{

constexpr Id LeafSize = 6;
constexpr Id ItemsPerPart = 8192; // of pairs, in one or two nodes: milliseconds
constexpr double SimilarLengths =
  16.0; // the most that those in one node differ by, where it has many

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

/// Makes the nodes and brings the items into their order.
class SegmentTree::Builder
{
public:
  Builder(SegmentTree& tree, Pulse& pulse)
    : Tree(tree)
    , Beats(pulse)
  {
  }

  void FileItems(const std::vector<Point2>& points, const std::vector<SegmentEnds>& segments);
  void Build(Id first, Id last);

private:
  double Enclose(Node& node) const;
  Id Part(const Node& node, double longest);
  Id PartByLength(Id first, Id last, double length);
  void Halve(Id first, Id middle, Id last);
  void EncloseItems(Node& leaf) const;

  SegmentTree& Tree;
  Pulse& Beats;
};

SegmentTree::SegmentTree(const std::vector<Point2>& points,
  const std::vector<SegmentEnds>& segments, const Margins& margins, Pulse& pulse)
{
  this->Grown = margins;
  Builder builder(*this, pulse);
  builder.FileItems(points, segments);
  if (!this->Items.empty() && pulse.Ask())
  {
    this->Nodes.reserve(this->Items.size());
    builder.Build(0, static_cast<Id>(this->Items.size()));
  }
}

/// With u the unit roundoff and M the largest coordinate, the center of a box and half its sides
/// are off by at most 2 u M, a direction of length one by 2 u, a slanted box in units of M by some
/// 10 u for each level of the tree, of which there are less than 100.
void SegmentTree::Builder::FileItems(
  const std::vector<Point2>& points, const std::vector<SegmentEnds>& segments)
{
  double largest = 0.0;
  this->Tree.Items.reserve(segments.size());
  for (const SegmentEnds& ends : segments)
  {
    Item item;
    const Point2& start = points[ends.Start];
    const Point2& end = points[ends.End];
    item.Shortest = LengthOf(start, end);
    item.Bounds = Box2::Around(start, end);
    item.Bounds.Grow(this->Tree.Grown.Of(item.Shortest));
    item.Ends = ends;
    item.Segment = static_cast<Id>(this->Tree.Items.size());
    item.Rises = (end.X >= start.X) == (end.Y >= start.Y);
    this->Tree.Items.push_back(item);
    largest = std::max({ largest, std::abs(item.Bounds.Low.X), std::abs(item.Bounds.Low.Y),
      std::abs(item.Bounds.High.X), std::abs(item.Bounds.High.Y) });
  }
  this->Tree.Slack = 1024.0 * std::numeric_limits<double>::epsilon() * largest;
}

void SegmentTree::Builder::Build(Id first, Id last)
{
  const std::size_t index = this->Tree.Nodes.size();
  Node node;
  node.FirstItem = first;
  node.LastItem = last;
  const double longest = this->Enclose(node);
  this->Tree.Nodes.push_back(node);
  if (last - first > LeafSize && this->Beats.Beat(static_cast<std::size_t>(last - first)))
  {
    const Id middle = this->Part(node, longest);
    this->Build(first, middle);
    const std::size_t second = this->Tree.Nodes.size();
    this->Build(middle, last);
    this->Tree.Nodes[index].SlantAround(this->Tree.Nodes[index + 1], this->Tree.Nodes[second]);
  }
  else
  {
    this->EncloseItems(this->Tree.Nodes[index]);
  }
  this->Tree.Nodes[index].Next = static_cast<Id>(this->Tree.Nodes.size());
}

/// All but the slanted box; returns the length of the longest item.
double SegmentTree::Builder::Enclose(Node& node) const
{
  double longest = 0.0;
  node.Common = this->Tree.ItemAt(node.FirstItem).Ends;
  node.Shortest = this->Tree.ItemAt(node.FirstItem).Shortest;
  for (Id i = node.FirstItem; i < node.LastItem; ++i)
  {
    const Item& item = this->Tree.ItemAt(i);
    AddBox(node.Bounds, item.Bounds);
    node.Common = CommonVertices(node.Common, item.Ends);
    node.Shortest = std::min(node.Shortest, item.Shortest);
    longest = std::max(longest, item.Shortest);
  }
  return longest;
}

/// By length where that differs much, else by place; returns where the second part begins.
Id SegmentTree::Builder::Part(const Node& node, double longest)
{
  if (longest > SimilarLengths * node.Shortest)
  {
    const double between = std::sqrt(longest) * std::sqrt(node.Shortest);
    const Id middle = this->PartByLength(node.FirstItem, node.LastItem, between);
    if (middle > node.FirstItem && middle < node.LastItem)
    {
      return middle;
    }
  }
  const Id middle = node.FirstItem + (node.LastItem - node.FirstItem) / 2;
  this->Halve(node.FirstItem, middle, node.LastItem);
  return middle;
}

/// The longer ones go first.
Id SegmentTree::Builder::PartByLength(Id first, Id last, double length)
{
  const auto begin = this->Tree.Items.begin();
  const auto middle = std::partition(
    begin + first, begin + last, [length](const Item& item) { return item.Shortest > length; });
  return static_cast<Id>(middle - begin);
}

/// Parts the items at the median of their centres, along the longer side of the centres' box.
void SegmentTree::Builder::Halve(Id first, Id middle, Id last)
{
  Box2 centers;
  for (Id i = first; i < last; ++i)
  {
    centers.Add(this->Tree.Items[i].Bounds.Center());
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
  const auto begin = this->Tree.Items.begin();
  std::nth_element(begin + first, begin + middle, begin + last, isBefore);
}

/// Along the longest item.
void SegmentTree::Builder::EncloseItems(Node& leaf) const
{
  for (Id i = leaf.FirstItem; i < leaf.LastItem; ++i)
  {
    const SlantedBox item = this->Tree.BoxOf(this->Tree.ItemAt(i));
    const SlantedBox before = leaf;
    leaf.SlantAround(i == leaf.FirstItem ? item : before, item);
  }
}

/// A segment is a diagonal of its box, and stays within two margins of that of the grown box, which
/// its grown box leaves by no more than that.
SlantedBox SegmentTree::BoxOf(const Item& item) const
{
  SlantedBox extent;
  extent.Bounds = item.Bounds;
  extent.Center = item.Bounds.Center();
  const double height = item.Bounds.Height();
  const Point2 diagonal{ item.Bounds.Width(), item.Rises ? height : -height };
  const double length = Length(diagonal);
  extent.Axis = length > 0.0 ? (1.0 / length) * diagonal : extent.Axis;
  const double margin = this->Grown.Of(item.Shortest);
  extent.Along = 0.5 * length + 4.0 * margin;
  extent.Across = 4.0 * margin;
  return extent;
}

std::vector<SegmentTree::PairPart> SegmentTree::PairParts() const
{
  std::vector<PairPart> parts;
  std::vector<PairPart> left;
  if (!this->Nodes.empty())
  {
    left.push_back({ 0, 0 });
  }
  while (!left.empty())
  {
    const PairPart part = left.back();
    left.pop_back();
    const Id size =
      this->NodeAt(part.First).NumberOfItems() + this->NodeAt(part.Second).NumberOfItems();
    if (size > ItemsPerPart && !this->IsLeaf(part.First) && this->MayMeet(part))
    {
      this->VisitBelow(part, [&left](const PairPart& below) { left.push_back(below); });
    }
    else
    {
      parts.push_back(part);
    }
  }
  return parts;
}

std::vector<Id> SegmentTree::WantedBefore(const std::vector<std::uint8_t>& isWanted) const
{
  std::vector<Id> before{ 0 };
  before.reserve(this->Items.size() + 1);
  for (const Item& item : this->Items)
  {
    before.push_back(before.back() + (isWanted[item.Segment] ? 1 : 0));
  }
  return before;
}

std::vector<SegmentEnds> SegmentsAndPoints(const Domain& domain)
{
  std::vector<SegmentEnds> segments;
  segments.reserve(domain.Starts.size());
  for (Id segment = 0; segment < domain.NumberOfSegments(); ++segment)
  {
    segments.push_back({ domain.Starts[segment], domain.Ends[segment] });
  }
  for (Id vertex = 0; vertex < domain.NumberOfVertices(); ++vertex)
  {
    if (domain.IsEmbedded[vertex] != 0)
    {
      segments.push_back({ vertex, vertex });
    }
  }
  return segments;
}

} // namespace biting
