// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingDelaunayScene_h
#define BitingDelaunayScene_h

#include "../Support/Dice.h"
#include "../Support/TriangulationCheck.h"
#include "Delaunay/Triangulation.h"
#include "Predicates/Predicates.h"

#include <algorithm> // for sort, rotate
#include <array>     // for triangles
#include <cmath>     // for floor
#include <cstdint>   // for seeds
#include <map>       // for edges
#include <utility>   // for pair
#include <vector>    // for the arrays

namespace biting
{

/// Points and constraints of a test.
struct Scene
{
  std::vector<Point2> Points;
  ConstraintEdges Edges;

  Id AddPoint(double x, double y)
  {
    this->Points.push_back({ x, y });
    return static_cast<Id>(this->Points.size()) - 1;
  }

  Id AddEdge(Id start, Id end, bool isBoundary)
  {
    this->Edges.Starts.push_back(start);
    this->Edges.Ends.push_back(end);
    this->Edges.IsBoundary.push_back(isBoundary ? 1 : 0);
    return static_cast<Id>(this->Edges.Starts.size()) - 1;
  }

  /// A closed boundary through new points; returns the first of them.
  Id AddLoop(const std::vector<Point2>& loop)
  {
    const Id first = static_cast<Id>(this->Points.size());
    const Id size = static_cast<Id>(loop.size());
    this->Points.insert(this->Points.end(), loop.begin(), loop.end());
    for (Id i = 0; i < size; ++i)
    {
      this->AddEdge(first + i, first + (i + 1) % size, true);
    }
    return first;
  }

  Id AddSquare(double low, double high)
  {
    return this->AddLoop({ { low, low }, { high, low }, { high, high }, { low, high } });
  }

  TriangulationResult Triangulate(double phi = 1.0) const
  {
    SilentMonitor monitor;
    return biting::Triangulate(this->Points, this->Edges, { phi }, monitor);
  }
};

/// `count` distinct points with whole coordinates in 1 .. size - 1.
inline std::vector<Point2> RandomPoints(int count, int size, std::uint64_t seed)
{
  Dice dice(seed);
  std::map<std::pair<int, int>, int> taken;
  std::vector<Point2> points;
  while (static_cast<int>(points.size()) < count)
  {
    const int x = 1 + dice.Below(size - 1);
    const int y = 1 + dice.Below(size - 1);
    if (taken.emplace(std::make_pair(x, y), 0).second)
    {
      points.push_back({ static_cast<double>(x), static_cast<double>(y) });
    }
  }
  return points;
}

/// A boundary square from 0 to `size`, with random points inside.
inline Scene RandomScene(int count, int size, std::uint64_t seed)
{
  Scene scene;
  scene.AddSquare(0.0, size);
  const std::vector<Point2> inner = RandomPoints(count, size, seed);
  scene.Points.insert(scene.Points.end(), inner.begin(), inner.end());
  return scene;
}

/// Twice the area: exact where coordinates are whole and moderate.
inline double DoubledArea(const std::vector<Point2>& points, const Triangulation& mesh)
{
  double sum = 0.0;
  for (Id t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    const Point2& a = points[mesh.Corners[3 * t]];
    sum += Cross(points[mesh.Corners[3 * t + 1]] - a, points[mesh.Corners[3 * t + 2]] - a);
  }
  return sum;
}

using TriangleSet = std::vector<std::array<Id, 3>>;

/// The triangles, each from its least corner on, sorted.
inline TriangleSet Triangles(const Triangulation& mesh)
{
  TriangleSet set;
  for (Id t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    std::array<Id, 3> corners{ mesh.Corners[3 * t], mesh.Corners[3 * t + 1],
      mesh.Corners[3 * t + 2] };
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    set.push_back(corners);
  }
  std::sort(set.begin(), set.end());
  return set;
}

/// Edges of the mesh, a triangle's edge as (from, to), with their constraints.
using EdgeMap = std::map<std::pair<Id, Id>, Id>;

inline EdgeMap DirectedEdges(const Triangulation& mesh)
{
  EdgeMap edges;
  for (Id t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    for (Id k = 0; k < 3; ++k)
    {
      edges[{ mesh.Corners[3 * t + (k + 1) % 3], mesh.Corners[3 * t + (k + 2) % 3] }] =
        mesh.Constraints[3 * t + k];
    }
  }
  return edges;
}

/// Whether the constraint is a chain of marked edges through all points that lie on it.
inline bool IsCovered(const Scene& scene, const EdgeMap& edges, std::size_t constraint)
{
  const Point2& start = scene.Points[scene.Edges.Starts[constraint]];
  const Point2& end = scene.Points[scene.Edges.Ends[constraint]];
  std::vector<std::pair<Point2, Id>> chain;
  for (std::size_t i = 0; i < scene.Points.size(); ++i)
  {
    if (IsOnSegment(scene.Points[i], start, end))
    {
      chain.push_back({ scene.Points[i], static_cast<Id>(i) });
    }
  }
  std::sort(
    chain.begin(), chain.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (std::size_t i = 1; i < chain.size(); ++i)
  {
    const auto left = edges.find({ chain[i - 1].second, chain[i].second });
    const auto right = edges.find({ chain[i].second, chain[i - 1].second });
    const bool isMarked = (left != edges.end() && left->second != NoId) ||
      (right != edges.end() && right->second != NoId);
    if (!isMarked)
    {
      return false;
    }
  }
  return true;
}

/// The region of the triangle that contains `place` in its interior; NoId where there is none.
inline Id RegionAt(const Scene& scene, const Triangulation& mesh, const Point2& place)
{
  for (Id t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    const Point2& a = scene.Points[mesh.Corners[3 * t]];
    const Point2& b = scene.Points[mesh.Corners[3 * t + 1]];
    const Point2& c = scene.Points[mesh.Corners[3 * t + 2]];
    if (Orient2D(a, b, place) >= 0 && Orient2D(b, c, place) >= 0 && Orient2D(c, a, place) >= 0)
    {
      return mesh.Regions[t];
    }
  }
  return NoId;
}

} // namespace biting

#endif
