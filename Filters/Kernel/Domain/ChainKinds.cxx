// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "ChainKinds.h"

#include "VertexStars.h"

#include <algorithm> // for min, min_element, all_of
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

Subgraph DrawnSegments(const std::vector<SegmentEnds>& segments, const std::vector<Id>& counts)
{
  Subgraph drawn;
  for (std::size_t s = 0; s < segments.size(); ++s)
  {
    if (counts[s] > 0)
    {
      drawn.Add(segments[s], static_cast<Id>(s), counts[s]);
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
    isOdd[static_cast<std::size_t>(graph.Segments[s].Start)] ^= parity;
    isOdd[static_cast<std::size_t>(graph.Segments[s].End)] ^= parity;
  }
  return isOdd;
}

bool HasOdd(const std::vector<std::uint8_t>& isOdd)
{
  return std::any_of(isOdd.begin(), isOdd.end(), [](std::uint8_t odd) { return odd != 0; });
}

/// Depth-first search with an explicit stack.
class BridgeFinder
{
public:
  BridgeFinder(const std::vector<Point2>& vertices, const Subgraph& graph)
    : Graph(graph)
    , Stars(vertices, graph.Segments)
    , Entry(vertices.size(), NoId)
    , Low(vertices.size(), NoId)
    , Next(vertices.size(), 0)
    , IsBridge(graph.Segments.size(), 0)
  {
  }

  std::vector<std::uint8_t> Run();

private:
  struct Visit
  {
    Id Vertex = NoId;
    Id Arrival = NoId; ///< the segment by which the search came
  };

  void Search(Id root);
  void Enter(Id vertex, Id arrival);
  void Leave();

  const Subgraph& Graph;
  const VertexStars Stars;
  std::vector<Id> Entry; ///< when the search entered each vertex
  std::vector<Id> Low;   ///< the earliest entry that its subtree reaches by another way
  std::vector<Id> Next;  ///< how much of its star has been followed
  std::vector<std::uint8_t> IsBridge;
  std::vector<Visit> Path;
  Id Clock = 0;
};

std::vector<std::uint8_t> BridgeFinder::Run()
{
  for (Id vertex = 0; vertex < this->Stars.NumberOfVertices(); ++vertex)
  {
    if (this->Stars.Degree(vertex) > 0 && this->Entry[static_cast<std::size_t>(vertex)] == NoId)
    {
      this->Search(vertex);
    }
  }
  return std::move(this->IsBridge);
}

void BridgeFinder::Search(Id root)
{
  this->Enter(root, NoId);
  while (!this->Path.empty())
  {
    const Visit here = this->Path.back();
    const auto vertex = static_cast<std::size_t>(here.Vertex);
    if (this->Next[vertex] == this->Stars.Degree(here.Vertex))
    {
      this->Leave();
      continue;
    }
    const Id segment = this->Stars.Begin(here.Vertex)[this->Next[vertex]++];
    const Id other = OtherEnd(this->Graph.Segments[static_cast<std::size_t>(segment)], here.Vertex);
    const Id entry = this->Entry[static_cast<std::size_t>(other)];
    if (entry == NoId)
    {
      this->Enter(other, segment);
    }
    else if (segment != here.Arrival)
    {
      this->Low[vertex] = std::min(this->Low[vertex], entry);
    }
  }
}

void BridgeFinder::Enter(Id vertex, Id arrival)
{
  this->Entry[static_cast<std::size_t>(vertex)] = this->Clock;
  this->Low[static_cast<std::size_t>(vertex)] = this->Clock++;
  this->Path.push_back({ vertex, arrival });
}

/// A segment drawn more than once is no bridge: its copies close a loop.
void BridgeFinder::Leave()
{
  const Visit left = this->Path.back();
  this->Path.pop_back();
  if (this->Path.empty())
  {
    return;
  }
  const auto parent = static_cast<std::size_t>(this->Path.back().Vertex);
  const Id low = this->Low[static_cast<std::size_t>(left.Vertex)];
  this->Low[parent] = std::min(this->Low[parent], low);
  const auto arrival = static_cast<std::size_t>(left.Arrival);
  const bool isLone = this->Graph.Counts[arrival] == 1;
  this->IsBridge[arrival] = isLone && low > this->Entry[parent] ? 1 : 0;
}

Subgraph WithoutBridges(const std::vector<Point2>& vertices, const Subgraph& graph)
{
  const std::vector<std::uint8_t> isBridge = BridgeFinder(vertices, graph).Run();
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
  ComponentJudge(const std::vector<Point2>& vertices, const Subgraph& graph)
    : Vertices(vertices)
    , Graph(graph)
    , Stars(vertices, graph.Segments)
    , IsOdd(OddVertices(vertices.size(), graph))
    , IsSeen(vertices.size(), 0)
  {
  }

  void Run(std::vector<std::uint8_t>& bounds);

private:
  std::vector<Id> Component(Id seed);
  void MarkParity(const std::vector<Id>& component, std::vector<std::uint8_t>& bounds) const;
  void MarkOutline(Id leftmost, std::vector<std::uint8_t>& bounds) const;
  const SegmentEnds& Ends(Id segment) const
  {
    return this->Graph.Segments[static_cast<std::size_t>(segment)];
  }
  std::size_t NumberOf(Id segment) const
  {
    return static_cast<std::size_t>(this->Graph.Numbers[static_cast<std::size_t>(segment)]);
  }

  const std::vector<Point2>& Vertices;
  const Subgraph& Graph;
  const VertexStars Stars;
  const std::vector<std::uint8_t> IsOdd;
  std::vector<std::uint8_t> IsSeen;
};

void ComponentJudge::Run(std::vector<std::uint8_t>& bounds)
{
  const auto isLeft = [this](Id a, Id b)
  {
    return this->Vertices[static_cast<std::size_t>(a)] <
      this->Vertices[static_cast<std::size_t>(b)];
  };
  const auto isEven = [this](Id vertex) { return !this->IsOdd[static_cast<std::size_t>(vertex)]; };
  for (Id seed = 0; seed < this->Stars.NumberOfVertices(); ++seed)
  {
    if (this->Stars.Degree(seed) == 0 || this->IsSeen[static_cast<std::size_t>(seed)])
    {
      continue;
    }
    const std::vector<Id> component = this->Component(seed);
    if (std::all_of(component.begin(), component.end(), isEven))
    {
      this->MarkParity(component, bounds);
    }
    else
    {
      this->MarkOutline(*std::min_element(component.begin(), component.end(), isLeft), bounds);
    }
  }
}

std::vector<Id> ComponentJudge::Component(Id seed)
{
  std::vector<Id> component{ seed };
  this->IsSeen[static_cast<std::size_t>(seed)] = 1;
  for (std::size_t i = 0; i < component.size(); ++i)
  {
    const Id vertex = component[i];
    for (const Id* s = this->Stars.Begin(vertex); s != this->Stars.End(vertex); ++s)
    {
      const Id other = OtherEnd(this->Ends(*s), vertex);
      if (!this->IsSeen[static_cast<std::size_t>(other)])
      {
        this->IsSeen[static_cast<std::size_t>(other)] = 1;
        component.push_back(other);
      }
    }
  }
  return component;
}

void ComponentJudge::MarkParity(
  const std::vector<Id>& component, std::vector<std::uint8_t>& bounds) const
{
  for (const Id vertex : component)
  {
    for (const Id* s = this->Stars.Begin(vertex); s != this->Stars.End(vertex); ++s)
    {
      const Id count = this->Graph.Counts[static_cast<std::size_t>(*s)];
      bounds[this->NumberOf(*s)] = static_cast<std::uint8_t>(count % 2);
    }
  }
}

/// Walks the outer face with the component on the left, from the lowest segment of its leftmost
/// vertex. A segment walked both ways is a doubled bridge, with the outside on both sides.
void ComponentJudge::MarkOutline(Id leftmost, std::vector<std::uint8_t>& bounds) const
{
  const Id first = *this->Stars.Begin(leftmost);
  Id vertex = leftmost;
  Id segment = first;
  do
  {
    bounds[this->NumberOf(segment)] ^= 1;
    vertex = OtherEnd(this->Ends(segment), vertex);
    segment = this->Stars.Next(vertex, segment);
  } while (vertex != leftmost || segment != first);
}

} // namespace

std::vector<std::uint8_t> FindBoundary(const std::vector<Point2>& vertices,
  const std::vector<SegmentEnds>& segments, const std::vector<Id>& counts)
{
  std::vector<std::uint8_t> bounds(segments.size(), 0);
  const Subgraph drawn = DrawnSegments(segments, counts);
  if (!HasOdd(OddVertices(vertices.size(), drawn)))
  {
    for (std::size_t s = 0; s < segments.size(); ++s)
    {
      bounds[s] = static_cast<std::uint8_t>(counts[s] % 2);
    }
    return bounds;
  }
  ComponentJudge(vertices, WithoutBridges(vertices, drawn)).Run(bounds);
  return bounds;
}

} // namespace biting
