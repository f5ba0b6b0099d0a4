// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "EndPairs.h"

#include <algorithm> // for binary_search, lower_bound, max, sort
#include <cmath>     // for abs
#include <limits>    // for infinity
#include <utility>   // for pair

namespace biting
{

namespace
{

using Flags = std::vector<std::uint8_t>;

constexpr std::size_t MostEnds = 10000;

/// How many edges end at each vertex, those that are drawn several times as often.
std::vector<Id> Degrees(const Arrangement& arrangement)
{
  std::vector<Id> degrees(arrangement.Vertices.size(), 0);
  for (const ArrangementEdge& edge : arrangement.Edges)
  {
    const Id count = std::max<Id>(1, edge.BoundaryCount + edge.OpenCount + edge.Faces.Count);
    degrees[edge.Ends.Start] += count;
    degrees[edge.Ends.End] += count;
  }
  return degrees;
}

/// Of edges that are not kept, by their vertices.
std::vector<OpenEnd> FindEnds(const Arrangement& arrangement, const Flags& isKept)
{
  const std::vector<Id> degrees = Degrees(arrangement);
  std::vector<OpenEnd> ends;
  for (std::size_t e = 0; e < isKept.size(); ++e)
  {
    const ArrangementEdge& edge = arrangement.Edges[e];
    for (const Id vertex : { edge.Ends.Start, edge.Ends.End })
    {
      if (!isKept[e] && degrees[vertex] == 1 && arrangement.VertexPoints[vertex] != NoId)
      {
        ends.push_back({ vertex, edge.Cell });
      }
    }
  }
  std::sort(ends.begin(), ends.end(),
    [](const OpenEnd& a, const OpenEnd& b) { return a.Vertex < b.Vertex; });
  return ends;
}

/// By number, for each of `ends`, which are sorted along the first axis, the nearest other one.
std::vector<std::size_t> NearestOthers(
  const Arrangement& arrangement, const std::vector<OpenEnd>& ends, Pulse& pulse)
{
  std::vector<std::size_t> nearest;
  for (std::size_t i = 0; i < ends.size() && pulse.Beat(); ++i)
  {
    const Point2& place = arrangement.At(ends[i].Vertex);
    double least = std::numeric_limits<double>::infinity();
    nearest.push_back(i);
    const auto look = [&arrangement, &ends, &place, &least, &nearest](std::size_t other)
    {
      const Point2& there = arrangement.At(ends[other].Vertex);
      const double distance = Distance(place, there);
      if (distance < least)
      {
        least = distance;
        nearest.back() = other;
      }
      return std::abs(there.X - place.X) <= least;
    };
    for (std::size_t below = i; below > 0 && look(below - 1); --below)
    {
    }
    for (std::size_t above = i + 1; above < ends.size() && look(above); ++above)
    {
    }
  }
  return nearest;
}

/// Those that are the nearest of each other become partners, then those of the rest, and so on.
void FindPartners(const Arrangement& arrangement, std::vector<OpenEnd>& ends, Pulse& pulse)
{
  std::vector<OpenEnd> left = ends;
  std::sort(left.begin(), left.end(),
    [&arrangement](const OpenEnd& a, const OpenEnd& b)
    { return arrangement.At(a.Vertex) < arrangement.At(b.Vertex); });
  std::vector<OpenEnd> done;
  while (left.size() > 1 && left.size() <= MostEnds && !pulse.HasStopped())
  {
    const std::vector<std::size_t> nearest = NearestOthers(arrangement, left, pulse);
    std::vector<OpenEnd> rest;
    for (std::size_t i = 0; i < nearest.size(); ++i)
    {
      const bool isPair = nearest[nearest[i]] == i;
      OpenEnd& end = left[i];
      end.Partner = isPair ? left[nearest[i]].Vertex : NoId;
      end.Gap = isPair ? Distance(arrangement.At(end.Vertex), arrangement.At(end.Partner)) : 0.0;
      (isPair ? done : rest).push_back(end);
    }
    if (rest.size() == left.size())
    {
      break;
    }
    left.swap(rest);
  }
  done.insert(done.end(), left.begin(), left.end());
  ends.swap(done);
}

/// The vertices at which an odd number of the edges of a cell end, by cells; of those of the ends.
std::vector<std::pair<Id, Id>> EndsOfCells(
  const Arrangement& arrangement, const std::vector<OpenEnd>& ends)
{
  std::vector<Id> wanted;
  wanted.reserve(ends.size());
  for (const OpenEnd& end : ends)
  {
    wanted.push_back(end.Cell);
  }
  std::sort(wanted.begin(), wanted.end());
  std::vector<std::pair<Id, Id>> places;
  for (const ArrangementEdge& edge : arrangement.Edges)
  {
    if (std::binary_search(wanted.begin(), wanted.end(), edge.Cell))
    {
      places.emplace_back(edge.Cell, edge.Ends.Start);
      places.emplace_back(edge.Cell, edge.Ends.End);
    }
  }
  std::sort(places.begin(), places.end());
  std::vector<std::pair<Id, Id>> odd;
  for (const std::pair<Id, Id>& place : places)
  {
    const bool isSecond = !odd.empty() && odd.back() == place;
    isSecond ? odd.pop_back() : odd.push_back(place);
  }
  return odd;
}

void PreferOwnCell(const Arrangement& arrangement, std::vector<OpenEnd>& ends)
{
  const std::vector<std::pair<Id, Id>> endsOfCells = EndsOfCells(arrangement, ends);
  for (OpenEnd& end : ends)
  {
    const std::pair<Id, Id> lowest(end.Cell, NoId);
    const auto first = std::lower_bound(endsOfCells.begin(), endsOfCells.end(), lowest);
    const bool areTwo = endsOfCells.end() - first >= 2 && first[1].first == end.Cell &&
      (endsOfCells.end() - first == 2 || first[2].first != end.Cell);
    const Id other = areTwo ? first[first->second == end.Vertex ? 1 : 0].second : NoId;
    const double gap =
      areTwo ? Distance(arrangement.At(end.Vertex), arrangement.At(other)) : end.Gap;
    if (areTwo && (end.Partner == NoId || gap < end.Gap))
    {
      end.Partner = other;
      end.Gap = gap;
    }
  }
}

} // namespace

std::vector<OpenEnd> PairOpenEnds(
  const Arrangement& arrangement, const std::vector<std::uint8_t>& isKept, Pulse& pulse)
{
  std::vector<OpenEnd> ends = FindEnds(arrangement, isKept);
  FindPartners(arrangement, ends, pulse);
  PreferOwnCell(arrangement, ends);
  std::sort(ends.begin(), ends.end(),
    [](const OpenEnd& a, const OpenEnd& b)
    { return a.Gap != b.Gap ? a.Gap > b.Gap : a.Vertex < b.Vertex; });
  return ends;
}

} // namespace biting
