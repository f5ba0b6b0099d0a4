// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "BorderTree.h"

#include <algorithm> // for nth_element
#include <array>     // for the stack
#include <utility>   // for move, swap

namespace biting
{
namespace
{

constexpr Id EdgesPerLeaf = 4;

/// The tree is halved at every level: ids of 32 bits need less.
constexpr std::size_t StackSize = 64;

double DistanceSquared(const Box2& box, const Point2& x)
{
  const double across = std::max({ box.Low.X - x.X, x.X - box.High.X, 0.0 });
  const double along = std::max({ box.Low.Y - x.Y, x.Y - box.High.Y, 0.0 });
  return across * across + along * along;
}

/// Twice the middle of an edge along the longer side of a box.
double SortKey(const BorderEdge& edge, bool alongX)
{
  return alongX ? edge.Start.X + edge.End.X : edge.Start.Y + edge.End.Y;
}

} // namespace

NearestValue NearestOnEdge(const BorderEdge& edge, const Point2& x)
{
  const Point2 direction = edge.End - edge.Start;
  const Point2 offset = x - edge.Start;
  const double length = Dot(direction, direction);
  const double along = length > 0.0 ? Dot(offset, direction) / length : 0.0;
  const double weight = std::min(std::max(0.0, along), 1.0);
  const Point2 gap = offset - weight * direction;
  return { Dot(gap, gap), (1.0 - weight) * edge.StartValue + weight * edge.EndValue };
}

BorderTree::BorderTree(std::vector<BorderEdge> edges)
  : Edges(std::move(edges))
{
  if (!this->Edges.empty())
  {
    this->Nodes.resize(1);
    this->Build(0, 0, static_cast<Id>(this->Edges.size()));
  }
}

void BorderTree::Build(Id nodeId, Id first, Id last)
{
  Box2 box;
  for (Id edge = first; edge < last; ++edge)
  {
    box.Add(this->Edges[static_cast<std::size_t>(edge)].Start);
    box.Add(this->Edges[static_cast<std::size_t>(edge)].End);
  }
  Node node{ box, first, last - first };
  if (node.Count > EdgesPerLeaf)
  {
    const Id middle = first + node.Count / 2;
    const bool alongX = box.Width() > box.Height();
    std::nth_element(this->Edges.begin() + first, this->Edges.begin() + middle,
      this->Edges.begin() + last,
      [alongX](const BorderEdge& a, const BorderEdge& b)
      { return SortKey(a, alongX) < SortKey(b, alongX); });
    node.First = static_cast<Id>(this->Nodes.size());
    node.Count = 0;
    this->Nodes.resize(this->Nodes.size() + 2);
    this->Build(node.First, first, middle);
    this->Build(node.First + 1, middle, last);
  }
  this->Nodes[static_cast<std::size_t>(nodeId)] = node;
}

NearestValue BorderTree::Nearest(const Point2& x, const NearestValue& known) const
{
  NearestValue best = known;
  std::array<Id, StackSize> stack{};
  std::size_t depth = this->Nodes.empty() ? 0 : 1;
  while (depth > 0)
  {
    const Node& node = this->Nodes[static_cast<std::size_t>(stack[--depth])];
    if (!(DistanceSquared(node.Box, x) < best.DistanceSquared))
    {
      continue;
    }
    for (Id edge = node.First; edge < node.First + node.Count; ++edge)
    {
      const NearestValue found = NearestOnEdge(this->Edges[static_cast<std::size_t>(edge)], x);
      best = found.DistanceSquared < best.DistanceSquared ? found : best;
    }
    if (node.Count == 0)
    {
      const Box2& low = this->Nodes[static_cast<std::size_t>(node.First)].Box;
      const Box2& high = this->Nodes[static_cast<std::size_t>(node.First + 1)].Box;
      const Id nearerHigh = DistanceSquared(high, x) < DistanceSquared(low, x) ? 1 : 0;
      stack[depth++] = node.First + 1 - nearerHigh;
      stack[depth++] = node.First + nearerHigh;
    }
  }
  return best;
}

} // namespace biting
