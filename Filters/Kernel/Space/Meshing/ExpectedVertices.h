// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingExpectedVertices_h
#define BitingExpectedVertices_h

#include "../Features/SurfaceGround.h"

#include <algorithm>  // for max, min
#include <array>      // for corners
#include <cmath>      // for sqrt
#include <functional> // for f
#include <vector>     // for the pieces that wait

namespace biting
{

/// About how many vertices a mesh of the surface has: the integral of 2 / (sqrt(3) f^2), as so many
/// equilateral triangles of edge f have. Triangles are halved where f differs in them. Ends above
/// `most`, and where f is not above zero.
inline double ExpectedVertices(
  const SurfaceMesh& mesh, const std::function<double(const Point3&)>& f, double most)
{
  constexpr double Alike = 1.5;    // values that differ by less need no halving
  constexpr double LongEdge = 2.0; // nor do triangles whose edges are shorter, in f
  double sum = 0.0;
  std::vector<std::array<Point3, 3>> pieces;
  for (std::size_t t = 0; t < mesh.NumberOfTriangles() && sum <= most; ++t)
  {
    pieces.assign(1, mesh.Triangle(t));
    while (!pieces.empty() && sum <= most)
    {
      const std::array<Point3, 3> p = pieces.back();
      pieces.pop_back();
      const double own = f((1.0 / 3.0) * (p[0] + p[1] + p[2]));
      double low = own;
      double high = own;
      std::size_t longest = 0; // its edge goes to the next corner
      for (std::size_t k = 0; k < 3; ++k)
      {
        const double value = f(p[k]);
        low = std::min(low, value);
        high = std::max(high, value);
        const double length = Distance(p[k], p[(k + 1) % 3]);
        longest = length > Distance(p[longest], p[(longest + 1) % 3]) ? k : longest;
      }
      if (!(low > 0.0))
      {
        return sum;
      }
      const Point3& from = p[longest];
      const Point3& to = p[(longest + 1) % 3];
      const Point3& apex = p[(longest + 2) % 3];
      if (high > Alike * low && Distance(from, to) > LongEdge * low)
      {
        const Point3 half = Midpoint(from, to);
        pieces.push_back({ from, half, apex });
        pieces.push_back({ half, to, apex });
      }
      else
      {
        sum += Length(Cross(p[1] - p[0], p[2] - p[0])) / (std::sqrt(3.0) * own * own);
      }
    }
  }
  return sum;
}

/// About how many vertices a mesh of the ground has at least: the integral of 2 / (sqrt(3) f^2) on
/// it, or that of 1 / f along its chains where this is more. f is linear in triangles, and these
/// functions of it are convex: their values in the middle are no more than their means.
inline double LeastVertices(const SurfaceGround& ground)
{
  const FeatureChains& chains = ground.Chains;
  double inside = 0.0;
  double along = 0.0;
  for (std::size_t t = 0; t < ground.Mesh.NumberOfTriangles(); ++t)
  {
    const Id* c = &ground.Mesh.Corners[3 * t];
    const double sum = ground.Sizes[At(c[0])] + ground.Sizes[At(c[1])] + ground.Sizes[At(c[2])];
    inside += 9.0 * Length(ground.Mesh.Normal(t)) / (std::sqrt(3.0) * sum * sum);
  }
  for (Id chain = 0; chain < chains.Size(); ++chain)
  {
    for (Id k = chains.Begin(chain) + 1; k < chains.End(chain); ++k)
    {
      const std::size_t a = At(chains.At(k - 1));
      const std::size_t b = At(chains.At(k));
      along += 2.0 * Distance(ground.Mesh.Points[a], ground.Mesh.Points[b]) /
        (ground.Sizes[a] + ground.Sizes[b]);
    }
  }
  return std::max(inside, along);
}

} // namespace biting

#endif
