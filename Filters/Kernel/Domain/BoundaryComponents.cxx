// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "BoundaryComponents.h"

#include "VertexStars.h"

#include <algorithm> // for min_element, all_of
#include <cstddef>   // for size_t

namespace biting
{

namespace
{

/// Part of a graph: some of its segments, and the number that each has in the whole.
struct Subgraph
{
  std::vector<SegmentEnds> Segments;
  std::vector<Id> Numbers;
  std::vector<Id> Counts;

  void Add(const SegmentEnds& segment, Id number, Id count)
  {
    this->Segments.push_back(segment);
    this->Numbers.push_back(number);
    this->Counts.push_back(count);
  }
};

Subgraph DrawnEdges(const Arrangement& arrangement, const std::vector<Id>& counts)
{
  Subgraph drawn;
  for (std::size_t e = 0; e < counts.size(); ++e)
  {
    if (counts[e] > 0)
    {
      drawn.Add(arrangement.Edges[e].Ends, static_cast<Id>(e), counts[e]);
    }
  }
  return drawn;
}

std::vector<std::uint8_t> OddVertices(std::size_t vertices, const Subgraph& graph)
{
  std::vector<std::uint8_t> isOdd(vertices, 0);
  for (std::size_t s = 0; s < graph.Segments.size(); ++s)
  {
    const auto parity = static_cast<std::uint8_t>(graph.Counts[s] % 2);
    isOdd[graph.Segments[s].Start] ^= parity;
    isOdd[graph.Segments[s].End] ^= parity;
  }
  return isOdd;
}

/// Walks along the faces of a plane graph.
class FaceWalk
{
public:
  FaceWalk(const std::vector<Point2>& vertices, const Subgraph& graph, Pulse& pulse);

  /// Each component has one walk a face: a bridge is passed twice, there and back, by one of them.
  /// A segment drawn more than once is no bridge: its copies close a loop.
  std::vector<std::uint8_t> FindBridges() const;

private:
  Id SideOf(Id segment, Id start) const
  {
    return 2 * segment + (this->Graph.Segments[segment].Start == start ? 0 : 1);
  }

  const Subgraph& Graph;
  std::vector<Id> Nexts; ///< of both sides of each segment: the side that follows at the end
};

FaceWalk::FaceWalk(const std::vector<Point2>& vertices, const Subgraph& graph, Pulse& pulse)
  : Graph(graph)
  , Nexts(2 * graph.Segments.size())
{
  const VertexStars stars(vertices, graph.Segments, pulse);
  for (Id vertex = 0; vertex < stars.NumberOfVertices(); ++vertex)
  {
    const Id* star = stars.Begin(vertex);
    for (Id i = 0; i < stars.Degree(vertex); ++i)
    {
      const Id arriving = this->SideOf(star[i], OtherEnd(graph.Segments[star[i]], vertex));
      this->Nexts[arriving] = this->SideOf(star[(i + 1) % stars.Degree(vertex)], vertex);
    }
  }
}

std::vector<std::uint8_t> FaceWalk::FindBridges() const
{
  std::vector<Id> walks(this->Nexts.size(), NoId);
  for (std::size_t first = 0; first < walks.size(); ++first)
  {
    for (Id side = static_cast<Id>(first); walks[side] == NoId; side = this->Nexts[side])
    {
      walks[side] = static_cast<Id>(first);
    }
  }
  std::vector<std::uint8_t> isBridge(this->Graph.Segments.size());
  for (std::size_t s = 0; s < isBridge.size(); ++s)
  {
    isBridge[s] = this->Graph.Counts[s] == 1 && walks[2 * s] == walks[2 * s + 1];
  }
  return isBridge;
}

Subgraph WithoutBridges(const std::vector<Point2>& vertices, const Subgraph& graph, Pulse& pulse)
{
  const std::vector<std::uint8_t> isBridge = FaceWalk(vertices, graph, pulse).FindBridges();
  Subgraph rest;
  for (std::size_t s = 0; s < isBridge.size(); ++s)
  {
    if (!isBridge[s])
    {
      rest.Add(graph.Segments[s], graph.Numbers[s], graph.Counts[s]);
    }
  }
  return rest;
}

/// Judges the components of a graph without bridges, one by one.
class ComponentJudge
{
public:
  ComponentJudge(const Arrangement& arrangement, const Subgraph& graph, Pulse& pulse)
    : Drawing(arrangement)
    , Graph(graph)
    , Beats(pulse)
    , Stars(arrangement.Vertices, graph.Segments, pulse)
    , IsOdd(OddVertices(arrangement.Vertices.size(), graph))
    , IsSeen(arrangement.Vertices.size(), 0)
  {
  }

  std::vector<BoundaryComponent> Run();

private:
  BoundaryComponent Judge(const std::vector<Id>& vertices) const;
  bool IsSimpleLoop(const std::vector<Id>& vertices) const;
  std::vector<Id> Connected(Id seed);
  std::vector<Id> OddEdges(const std::vector<Id>& vertices) const;
  std::vector<Id> Outline(Id leftmost) const;
  const SegmentEnds& Ends(Id segment) const { return this->Graph.Segments[segment]; }
  Id NumberOf(Id segment) const { return this->Graph.Numbers[segment]; }

  const Arrangement& Drawing;
  const Subgraph& Graph;
  Pulse& Beats;
  const VertexStars Stars;
  const std::vector<std::uint8_t> IsOdd;
  std::vector<std::uint8_t> IsSeen;
};

std::vector<BoundaryComponent> ComponentJudge::Run()
{
  std::vector<BoundaryComponent> components;
  for (Id seed = 0; seed < this->Stars.NumberOfVertices() && this->Beats.Beat(1); ++seed)
  {
    if (this->Stars.Degree(seed) > 0 && !this->IsSeen[seed])
    {
      components.push_back(this->Judge(this->Connected(seed)));
    }
  }
  return components;
}

BoundaryComponent ComponentJudge::Judge(const std::vector<Id>& vertices) const
{
  const auto isLeft = [this](Id a, Id b) { return this->Drawing.At(a) < this->Drawing.At(b); };
  const auto isEven = [this](Id vertex) { return !this->IsOdd[vertex]; };
  const Id leftmost = *std::min_element(vertices.begin(), vertices.end(), isLeft);
  const Id lowest = *this->Stars.Begin(leftmost);
  BoundaryComponent component;
  component.Lowest = { leftmost, OtherEnd(this->Ends(lowest), leftmost) };
  component.LowestEdge = this->NumberOf(lowest);
  component.IsSimpleLoop = this->IsSimpleLoop(vertices);
  component.Edges = std::all_of(vertices.begin(), vertices.end(), isEven) ? this->OddEdges(vertices)
                                                                          : this->Outline(leftmost);
  return component;
}

bool ComponentJudge::IsSimpleLoop(const std::vector<Id>& vertices) const
{
  return std::all_of(vertices.begin(), vertices.end(),
    [this](Id vertex)
    {
      const bool isCrossing = this->Drawing.VertexPoints[vertex] == NoId;
      return this->Stars.Degree(vertex) == 2 && !isCrossing;
    });
}

std::vector<Id> ComponentJudge::Connected(Id seed)
{
  std::vector<Id> component{ seed };
  this->IsSeen[seed] = 1;
  for (std::size_t i = 0; i < component.size(); ++i)
  {
    const Id vertex = component[i];
    this->Beats.Beat();
    for (const Id* s = this->Stars.Begin(vertex); s != this->Stars.End(vertex); ++s)
    {
      const Id other = OtherEnd(this->Ends(*s), vertex);
      if (!this->IsSeen[other])
      {
        this->IsSeen[other] = 1;
        component.push_back(other);
      }
    }
  }
  return component;
}

std::vector<Id> ComponentJudge::OddEdges(const std::vector<Id>& vertices) const
{
  std::vector<Id> edges;
  for (const Id vertex : vertices)
  {
    for (const Id* s = this->Stars.Begin(vertex); s != this->Stars.End(vertex); ++s)
    {
      const bool isOdd = this->Graph.Counts[*s] % 2 != 0;
      if (isOdd && this->Ends(*s).Start == vertex)
      {
        edges.push_back(this->NumberOf(*s));
      }
    }
  }
  return edges;
}

/// Walks the outer face with the component on the left, from the lowest edge of its leftmost
/// vertex. An edge walked both ways is a doubled bridge, with the outside on both sides: it is
/// there twice.
std::vector<Id> ComponentJudge::Outline(Id leftmost) const
{
  const Id first = *this->Stars.Begin(leftmost);
  Id vertex = leftmost;
  Id segment = first;
  std::vector<Id> edges;
  do
  {
    edges.push_back(this->NumberOf(segment));
    vertex = OtherEnd(this->Ends(segment), vertex);
    segment = this->Stars.Next(vertex, segment);
  } while (vertex != leftmost || segment != first);
  return edges;
}

} // namespace

std::vector<BoundaryComponent> FindBoundaryComponents(
  const Arrangement& arrangement, const std::vector<Id>& counts, Pulse& pulse)
{
  const Subgraph drawn = DrawnEdges(arrangement, counts);
  if (drawn.Segments.empty())
  {
    return {};
  }
  return ComponentJudge(arrangement, WithoutBridges(arrangement.Vertices, drawn, pulse), pulse)
    .Run();
}

} // namespace biting
