// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSimplifiedDrawing_h
#define BitingSimplifiedDrawing_h

#include "../Support/MeshShapes.h"
#include "../Support/PolylineShapes.h"
#include "Base/DistanceToSegment.h"
#include "Simplification/Simplification.h"

#include <algorithm>  // for max, min, sort
#include <cmath>      // for floor
#include <functional> // for spacing
#include <limits>     // for infinity
#include <map>        // for numbers
#include <set>        // for places
#include <vector>     // for the arrays

namespace biting
{

/// A drawing before and after.
struct Simplified
{
  Domain Before;
  SimplifiedDomain After;
  ProblemList Problems;
  std::string Violation; ///< of the result
};

inline Simplified SimplifyLines(const Polylines& lines, const SimplificationOptions& options,
  const std::function<double(const Point2&)>& spacing)
{
  Simplified made;
  SilentMonitor monitor;
  made.Before = MakeDomain(lines, {}, made.Problems, monitor);
  made.After = Simplify(made.Before, options, spacing, made.Problems, monitor);
  made.Violation = CheckDomain(made.After.Drawing);
  return made;
}

inline Simplified SimplifyLines(const Polylines& lines, double tolerance, double spacing)
{
  SimplificationOptions options;
  options.Tolerance = tolerance;
  return SimplifyLines(lines, options, [spacing](const Point2&) { return spacing; });
}

/// The largest distance of places on the segments of one domain, so many on each, to the nearest
/// segment of the other, over the spacing there. By comparing all with all.
inline double LargestDistance(const Domain& from, const Domain& to,
  const std::function<double(const Point2&)>& spacing, int places = 5)
{
  double largest = 0.0;
  for (Id segment = 0; segment < from.NumberOfSegments(); ++segment)
  {
    for (int k = 0; k <= places; ++k)
    {
      const Point2& start = from.Vertices[from.Starts[segment]];
      const Point2 p =
        start + (static_cast<double>(k) / places) * (from.Vertices[from.Ends[segment]] - start);
      double nearest = std::numeric_limits<double>::infinity();
      for (Id other = 0; other < to.NumberOfSegments(); ++other)
      {
        nearest = std::min(nearest,
          DistanceToSegment(p, to.Vertices[to.Starts[other]], to.Vertices[to.Ends[other]]));
      }
      largest = std::max(largest, nearest / spacing(p));
    }
  }
  return largest;
}

/// Numbers that say how a drawing hangs together: pieces, faces and lone vertices.
struct Connections
{
  Id Pieces = 0; ///< connected ones
  Id Cycles = 0; ///< independent ones: as many as bounded faces
  Id Lone = 0;

  bool operator==(const Connections& other) const
  {
    return this->Pieces == other.Pieces && this->Cycles == other.Cycles && this->Lone == other.Lone;
  }
};

inline Connections ConnectionsOf(const Domain& domain)
{
  std::vector<Id> parents(domain.Vertices.size());
  for (std::size_t v = 0; v < parents.size(); ++v)
  {
    parents[v] = static_cast<Id>(v);
  }
  const std::function<Id(Id)> find = [&parents](Id vertex)
  {
    while (parents[vertex] != vertex)
    {
      parents[vertex] = parents[parents[vertex]];
      vertex = parents[vertex];
    }
    return vertex;
  };
  Connections connections;
  connections.Pieces = domain.NumberOfVertices();
  for (Id segment = 0; segment < domain.NumberOfSegments(); ++segment)
  {
    const Id a = find(domain.Starts[segment]);
    const Id b = find(domain.Ends[segment]);
    connections.Pieces -= a == b ? 0 : 1;
    parents[a] = b;
  }
  connections.Cycles = domain.NumberOfSegments() - domain.NumberOfVertices() + connections.Pieces;
  for (const std::uint8_t isEmbedded : domain.IsEmbedded)
  {
    connections.Lone += isEmbedded;
  }
  return connections;
}

/// The places of the vertices, sorted.
inline std::vector<Point2> PlacesOf(const Domain& domain)
{
  std::vector<Point2> places = domain.Vertices;
  std::sort(places.begin(), places.end());
  return places;
}

/// The outline of pixels of size one whose centres lie in a disc, counterclockwise.
inline std::vector<Point2> PixelDisc(const Point2& center, double radius)
{
  const auto isIn = [radius](double x, double y) { return x * x + y * y < radius * radius; };
  std::vector<Point2> right;
  const int rows = static_cast<int>(std::floor(radius));
  for (int row = -rows; row < rows; ++row)
  {
    int width = 0;
    while (isIn(width + 0.5, row + 0.5))
    {
      ++width;
    }
    for (const int y : { row, row + 1 })
    {
      right.push_back({ static_cast<double>(width), static_cast<double>(y) });
    }
  }
  std::vector<Point2> outline;
  const auto walkTo = [&outline, &center](const Point2& corner)
  {
    const Point2 end = center + corner;
    while (!outline.empty() && outline.back() != end)
    {
      const Point2 rest = end - outline.back();
      const Point2 step{ rest.X > 0.0 ? 1.0
          : rest.X < 0.0              ? -1.0
                                      : 0.0,
        rest.Y > 0.0     ? 1.0
          : rest.Y < 0.0 ? -1.0
                         : 0.0 };
      outline.push_back(outline.back() + step);
    }
    if (outline.empty())
    {
      outline.push_back(end);
    }
  };
  for (const Point2& corner : right)
  {
    walkTo(corner);
  }
  for (auto corner = right.rbegin(); corner != right.rend(); ++corner)
  {
    walkTo({ -corner->X, corner->Y });
  }
  walkTo(right.front());
  outline.pop_back();
  return outline;
}

/// A loop around the origin with a rough outline, of 2^levels segments.
inline std::vector<Point2> RoughLoop(int levels, double radius, int seed)
{
  TestNumbers numbers(static_cast<std::uint64_t>(seed));
  const int count = 1 << levels;
  std::vector<double> radii(static_cast<std::size_t>(count), 0.0);
  radii[0] = radius;
  for (int step = count; step > 1; step /= 2)
  {
    for (int k = 0; k < count; k += step)
    {
      const double mean = 0.5 *
        (radii[static_cast<std::size_t>(k)] + radii[static_cast<std::size_t>((k + step) % count)]);
      const double length = radius * step / count;
      radii[static_cast<std::size_t>(k + step / 2)] =
        std::max(0.3 * radius, mean + length * (numbers.Below(2001) - 1000) / 1000.0);
    }
  }
  std::vector<Point2> places;
  for (int k = 0; k < count; ++k)
  {
    places.push_back(radii[static_cast<std::size_t>(k)] * UnitVector(360.0 * k / count));
  }
  return places;
}

} // namespace biting

#endif
