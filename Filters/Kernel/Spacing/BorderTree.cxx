// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "BorderTree.h"

#include <algorithm> // for min, max, max_element
#include <array>     // for parts

namespace biting
{

NearestValue NearestOnEdge(const BorderEdge& edge, const Point2& x)
{
  const Point2 direction = edge.End - edge.Start;
  const Point2 offset = x - edge.Start;
  const double length = Dot(direction, direction);
  const double along = length > 0.0 ? Dot(offset, direction) / length : 0.0;
  const double weight = std::min(std::max(0.0, along), 1.0);
  const Point2 toFoot = weight * direction;
  return { Length(offset - toFoot), (1.0 - weight) * edge.StartValue + weight * edge.EndValue,
    edge.Start + toFoot, &edge };
}

namespace
{

/// Those in one tree differ by no more, as a factor; but the shortest may.
constexpr double SimilarLengths = 64.0;
constexpr std::size_t MostTrees = 6;

} // namespace

/// Along the longest edge. The sides lead through the places that are farthest from it in both
/// halves, or beside.
BorderTree::Wedge::Wedge(const BorderEdge* begin, const BorderEdge* end)
{
  const auto isShorter = [](const BorderEdge& a, const BorderEdge& b)
  { return Distance(a.Start, a.End) < Distance(b.Start, b.End); };
  const BorderEdge& longest = *std::max_element(begin, end, isShorter);
  const double length = Distance(longest.Start, longest.End);
  this->Start = longest.Start;
  this->Axis = length > 0.0 ? (1.0 / length) * (longest.End - longest.Start) : Point2{ 1.0, 0.0 };
  Point2 low;
  Point2 high{ length, 0.0 };
  const auto forEachEnd = [this, begin, end](auto visit)
  {
    for (const BorderEdge* edge = begin; edge != end; ++edge)
    {
      for (const Point2& place : { edge->Start, edge->End })
      {
        const Point2 offset = place - this->Start;
        visit(Point2{ Dot(this->Axis, offset), std::abs(Cross(this->Axis, offset)) });
      }
    }
  };
  forEachEnd(
    [&low, &high, length](const Point2& place)
    {
      Point2& farthest = place.X < 0.5 * length ? low : high;
      farthest = place.Y > farthest.Y ? place : farthest;
    });
  const double ahead = high.X - low.X;
  const double slope = ahead > 0.25 * length ? (high.Y - low.Y) / ahead : 0.0;
  double width = 0.0;
  double largest = 0.0;
  forEachEnd(
    [&width, &largest, slope](const Point2& place)
    {
      width = std::max(width, place.Y - slope * place.X);
      largest = std::max(largest, Length(place));
    });
  this->Cosine = 1.0 / Length({ 1.0, slope });
  this->Width = this->Cosine * width + Rounding * largest;
  this->Growth = this->Cosine * slope;
}

BorderTree::Part::Part(const std::vector<BorderEdge>& edges, Pulse& pulse)
  : Tree(edges, pulse)
  , Wedges(this->Tree.NumberOfNodes())
{
  const BorderEdge* items = this->Tree.Items().data();
  this->Tree.ForEachNode(
    [this, items, &pulse](Id node, Id first, Id last)
    {
      if (pulse.Beat(8 * static_cast<std::size_t>(last - first)))
      {
        this->Wedges[static_cast<std::size_t>(node)] = Wedge(items + first, items + last);
      }
    });
}

BorderTree::BorderTree(const std::vector<BorderEdge>& edges, Pulse& pulse)
{
  double longest = 0.0;
  for (const BorderEdge& edge : edges)
  {
    longest = std::max(longest, Distance(edge.Start, edge.End));
  }
  std::array<std::vector<BorderEdge>, MostTrees> parts;
  for (const BorderEdge& edge : edges)
  {
    const double ratio = longest / Distance(edge.Start, edge.End);
    const double part = std::floor(std::log2(ratio) / std::log2(SimilarLengths));
    parts[part < MostTrees ? static_cast<std::size_t>(part) : MostTrees - 1].push_back(edge);
  }
  for (const std::vector<BorderEdge>& part : parts)
  {
    if (!part.empty())
    {
      const std::vector<BorderEdge>& items = this->Parts.emplace_back(part, pulse).Tree.Items();
      this->Edges.insert(this->Edges.end(), items.begin(), items.end());
    }
  }
}

NearestValue BorderTree::Nearest(const Point2& x, const NearestValue& known) const
{
  NearestValue best = known;
  this->Search(x, known.Distance,
    [&x, &best](const BorderEdge& edge, double)
    {
      const NearestValue found = NearestOnEdge(edge, x);
      best = found.Distance < best.Distance ? found : best;
      return best.Distance;
    });
  return best;
}

} // namespace biting
