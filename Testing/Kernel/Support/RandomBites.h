// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingRandomBites_h
#define BitingRandomBites_h

#include "Biting/BiteOutline.h"
#include "Biting/Bites.h"
#include "MeshShapes.h"

#include <algorithm> // for max, min
#include <array>     // for triangles
#include <utility>   // for swap

namespace biting
{

using Triangle = std::array<Point2, 3>;

constexpr double Slack = 1e-12;

inline void AddBite(const Point2& center, bool isCircle, TestNumbers& numbers, Bites& bites)
{
  bites.Centers.push_back(center);
  bites.Axes.push_back(isCircle ? Point2{} : UnitVector(DegreesPerTurn * numbers.Unit()));
  bites.HalfWidths.push_back(0.4 + 0.5 * numbers.Unit());
}

inline Point2 PointNear(TestNumbers& numbers)
{
  return { 2.0 * numbers.Unit() - 1.0, 2.0 * numbers.Unit() - 1.0 };
}

inline Triangle RandomTriangle(TestNumbers& numbers)
{
  Triangle triangle{ PointNear(numbers), PointNear(numbers), PointNear(numbers) };
  if (Cross(triangle[1] - triangle[0], triangle[2] - triangle[0]) < 0.0)
  {
    std::swap(triangle[1], triangle[2]);
  }
  return triangle;
}

inline Point2 PointOf(const Triangle& triangle, TestNumbers& numbers)
{
  double u = numbers.Unit();
  double v = numbers.Unit();
  u = u + v > 1.0 ? 1.0 - u : u;
  v = u + v > 1.0 ? 1.0 - v : v;
  return triangle[0] + u * (triangle[1] - triangle[0]) + v * (triangle[2] - triangle[0]);
}

// The largest of p's depths in bites.
inline double DepthIn(const Bites& bites, const Point2& p)
{
  double depth = -1.0;
  for (Id bite = 0; bite < bites.Size(); ++bite)
  {
    depth = std::max(depth, Depth(bites, bite, p));
  }
  return depth;
}

inline double LeastDepth(const Bites& bites, const Triangle& triangle, TestNumbers& numbers)
{
  double least = 1.0;
  for (int sample = 0; sample < 300; ++sample)
  {
    least = std::min(least, DepthIn(bites, PointOf(triangle, numbers)));
  }
  return least;
}

} // namespace biting

#endif
