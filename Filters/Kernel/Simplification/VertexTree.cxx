// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "VertexTree.h"

#include "../Base/Numbers.h"
#include "../Predicates/Predicates.h"

#include <algorithm> // for nth_element, find
#include <numeric>   // for iota

namespace biting
{

namespace
{

constexpr Id LeafSize = 8;

// Whether the whole box lies strictly on the right of the line from a to b: its leftmost corner
// does.
bool IsRightOf(const Point2& a, const Point2& b, const Box2& box)
{
  const Point2 leftmost{ b.Y < a.Y ? box.High.X : box.Low.X, b.X > a.X ? box.High.Y : box.Low.Y };
  return Orient2D(a, b, leftmost) < 0;
}

bool IsBeside(const std::array<Point2, 3>& corners, const Box2& box)
{
  return IsRightOf(corners[0], corners[1], box) || IsRightOf(corners[1], corners[2], box) ||
    IsRightOf(corners[2], corners[0], box);
}

Box2 Everywhere()
{
  return { { -Infinity, -Infinity }, { Infinity, Infinity } };
}

bool IsStrictlyIn(const Box2& cell, const Box2& box)
{
  return box.Low.X > cell.Low.X && box.Low.Y > cell.Low.Y && box.High.X < cell.High.X &&
    box.High.Y < cell.High.Y;
}

bool IsIn(const std::array<Point2, 3>& corners, const Point2& p)
{
  return Orient2D(corners[0], corners[1], p) >= 0 && Orient2D(corners[1], corners[2], p) >= 0 &&
    Orient2D(corners[2], corners[0], p) >= 0;
}

} // namespace

VertexTree::VertexTree(const std::vector<Point2>& points, Pulse& pulse)
  : Points(points)
  , Items(points.size())
  , Leaves(points.size(), NoId)
  , IsLeft(points.size(), 1)
{
  std::iota(this->Items.begin(), this->Items.end(), 0);
  if (!points.empty())
  {
    this->Build(0, static_cast<Id>(points.size()), Everywhere(), NoId, pulse);
  }
}

void VertexTree::Build(Id first, Id last, const Box2& cell, Id parent, Pulse& pulse)
{
  const Id node = static_cast<Id>(this->Nodes.size());
  this->Nodes.push_back(
    { {}, cell, last - first > LeafSize ? 2 : last - first, parent, NoId, first, last });
  for (Id i = first; i < last; ++i)
  {
    this->Nodes[node].Box.Add(this->Points[this->Items[i]]);
  }
  if (last - first > LeafSize && pulse.Beat(static_cast<std::size_t>(last - first)))
  {
    this->BuildChildren(node, pulse);
  }
  else
  {
    for (Id i = first; i < last; ++i)
    {
      this->Leaves[this->Items[i]] = node;
    }
  }
  this->Nodes[node].Next = static_cast<Id>(this->Nodes.size());
}

void VertexTree::BuildChildren(Id node, Pulse& pulse)
{
  const Id first = this->Nodes[node].First;
  const Id last = this->Nodes[node].Last;
  const Id middle = first + (last - first) / 2;
  const bool isWide = this->Nodes[node].Box.Width() >= this->Nodes[node].Box.Height();
  const auto isBefore = [this, isWide](Id a, Id b)
  {
    const Point2& p = this->Points[a];
    const Point2& q = this->Points[b];
    return isWide ? p.X < q.X : p.Y < q.Y;
  };
  const auto begin = this->Items.begin();
  std::nth_element(begin + first, begin + middle, begin + last, isBefore);
  const Point2 division = this->Points[this->Items[middle]];
  Box2 low = this->Nodes[node].Cell;
  Box2 high = low;
  (isWide ? low.High.X : low.High.Y) = isWide ? division.X : division.Y;
  (isWide ? high.Low.X : high.Low.Y) = isWide ? division.X : division.Y;
  this->Build(first, middle, low, node, pulse);
  this->Build(middle, last, high, node, pulse);
}

void VertexTree::Remove(Id vertex)
{
  this->IsLeft[vertex] = 0;
  Id node = this->Leaves[vertex];
  while (node != NoId && --this->Nodes[node].Count == 0)
  {
    node = this->Nodes[node].Parent;
  }
}

Id VertexTree::FindIn(const std::array<Point2, 3>& corners, const std::array<Id, 3>& passed) const
{
  Box2 box;
  for (const Point2& corner : corners)
  {
    box.Add(corner);
  }
  const Id top = this->FindNodeAround(box, passed[0]);
  const Id end = this->Nodes[top].Next;
  for (Id node = top; node < end;)
  {
    const Node& here = this->Nodes[node];
    if (here.Count == 0 || !here.Box.Meets(box) || IsBeside(corners, here.Box))
    {
      node = here.Next;
      continue;
    }
    for (Id i = here.First; this->IsLeaf(node) && i < here.Last; ++i)
    {
      const Id vertex = this->Items[i];
      const bool isPassed =
        !this->IsLeft[vertex] || std::find(passed.begin(), passed.end(), vertex) != passed.end();
      if (!isPassed && IsIn(corners, this->Points[vertex]))
      {
        return vertex;
      }
    }
    ++node;
  }
  return NoId;
}

Id VertexTree::FindNodeAround(const Box2& box, Id vertex) const
{
  Id node = this->Leaves[vertex];
  while (this->Nodes[node].Parent != NoId && !IsStrictlyIn(this->Nodes[node].Cell, box))
  {
    node = this->Nodes[node].Parent;
  }
  return node;
}

} // namespace biting
