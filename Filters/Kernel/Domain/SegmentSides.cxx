// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SegmentSides.h"

#include "../Predicates/Predicates.h"

#include <cmath> // for abs

namespace biting
{

namespace
{

constexpr double PassMargin = 1e-6; // of a box: more than rounding

} // namespace

bool PassesBox(const Domain& domain, Id segment, const Box2& box)
{
  const Point2& a = domain.Vertices[domain.Starts[segment]];
  const Point2& b = domain.Vertices[domain.Ends[segment]];
  const double margin = PassMargin * box.Width() + domain.Resolution;
  Box2 grown = box;
  grown.Grow(margin);
  Box2 span;
  span.Add(a);
  span.Add(b);
  if (!grown.Meets(span))
  {
    return false;
  }
  const Point2 direction = b - a;
  const double reach =
    0.5 * (std::abs(direction.X) * grown.Height() + std::abs(direction.Y) * grown.Width());
  return std::abs(Cross(direction, grown.Center() - a)) <= reach * (1.0 + PassMargin);
}

bool Separates(const Domain& domain, Id segment, const Point2& p, const Point2& q)
{
  const Point2& a = domain.Vertices[domain.Starts[segment]];
  const Point2& b = domain.Vertices[domain.Ends[segment]];
  if ((Orient2D(a, b, p) > 0) == (Orient2D(a, b, q) > 0))
  {
    return false;
  }
  return (Orient2D(p, q, a) >= 0) != (Orient2D(p, q, b) >= 0);
}

} // namespace biting
