// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "CornerCover.h"

#include "BiteOutline.h" // for Gauge

namespace biting
{

namespace
{

bool Contains(const Bites& bites, Id bite, const Point2& p)
{
  return Gauge(bites, bite, p) <= bites.HalfWidths[bite];
}

// Whether two bites, the ends of an edge their centres, cover it.
bool CoverEdge(const Bites& bites, Id first, Id second)
{
  const double there = Gauge(bites, first, bites.Centers[second]);
  const double back = Gauge(bites, second, bites.Centers[first]);
  return bites.HalfWidths[first] * back + bites.HalfWidths[second] * there >= there * back;
}

} // namespace

// With sides of lengths u, v, w and A the doubled area, the circumradius is u v w / (2 A).
bool IsWithinOfCorners(const std::array<Point2, 3>& corners, double distance)
{
  const Point2 u = corners[1] - corners[0];
  const Point2 v = corners[2] - corners[0];
  const Point2 w = corners[2] - corners[1];
  const double doubledArea = Cross(u, v);
  const double reach = 2.0 * distance * doubledArea;
  return Dot(u, u) * Dot(v, v) * Dot(w, w) <= reach * reach;
}

// A place that all three share, and one on each edge that two do, cut the triangle into three
// parts: the four places of each lie in one bite, which is convex.
bool CoverTriangle(const Bites& bites, const std::array<Id, 3>& atCorners)
{
  const auto& [a, b, c] = atCorners;
  const double weightA = bites.HalfWidths[b] * bites.HalfWidths[c];
  const double weightB = bites.HalfWidths[c] * bites.HalfWidths[a];
  const double weightC = bites.HalfWidths[a] * bites.HalfWidths[b];
  const double perSum = 1.0 / (weightA + weightB + weightC);
  const Point2& origin = bites.Centers[a];
  const Point2 shared = origin +
    perSum * (weightB * (bites.Centers[b] - origin) + weightC * (bites.Centers[c] - origin));
  return Contains(bites, a, shared) && Contains(bites, b, shared) && Contains(bites, c, shared) &&
    CoverEdge(bites, a, b) && CoverEdge(bites, b, c) && CoverEdge(bites, c, a);
}

} // namespace biting
