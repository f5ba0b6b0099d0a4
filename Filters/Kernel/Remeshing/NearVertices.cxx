// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "NearVertices.h"

#include <algorithm> // for sort, unique
#include <cmath>     // for floor
#include <tuple>     // for the order of vertices

namespace biting
{

namespace
{

/// A vertex in one of many upright strips.
struct StripVertex
{
  double Strip = 0.0;
  Point2 Place;
  Id Vertex = NoId;
};

bool operator<(const StripVertex& a, const StripVertex& b)
{
  return std::tie(a.Strip, a.Place.Y, a.Place.X, a.Vertex) <
    std::tie(b.Strip, b.Place.Y, b.Place.X, b.Vertex);
}

} // namespace

// Strips are twice as wide as vertices may be apart: two of them share a strip, or one of those
// that lie half a width beside. Of many at one place each is paired with the next.
std::vector<std::pair<Id, Id>> FindNearVertices(
  const std::vector<Point2>& points, std::vector<Id> vertices, double nearest)
{
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  std::vector<std::pair<Id, Id>> pairs;
  std::vector<StripVertex> ordered(vertices.size());
  for (const double shift : { 0.0, nearest })
  {
    for (std::size_t k = 0; k < vertices.size(); ++k)
    {
      const Point2& place = points[vertices[k]];
      const double strip =
        nearest > 0.0 ? std::floor((place.X + shift) / (2.0 * nearest)) : place.X;
      ordered[k] = { strip, place, vertices[k] };
    }
    std::sort(ordered.begin(), ordered.end());
    for (auto one = ordered.begin(); one != ordered.end(); ++one)
    {
      for (auto other = one + 1; other != ordered.end() && other->Strip == one->Strip &&
           other->Place.Y - one->Place.Y <= nearest;
           ++other)
      {
        if (Distance(one->Place, other->Place) <= nearest)
        {
          pairs.emplace_back(one->Vertex, other->Vertex);
        }
        if (other->Place == one->Place)
        {
          break; // what is near to the one is near to the other
        }
      }
    }
  }
  return pairs;
}

} // namespace biting
