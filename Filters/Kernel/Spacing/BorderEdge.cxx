// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "BorderEdge.h"

#include <algorithm> // for min, max

namespace biting
{

NearestValue NearestOnEdge(const BorderEdge& edge, const Point2& x)
{
  const Point2 direction = edge.End - edge.Start;
  const Point2 offset = x - edge.Start;
  const double length = Dot(direction, direction);
  const double along = length > 0.0 ? Dot(offset, direction) / length : 0.0;
  const double weight = std::min(std::max(0.0, along), 1.0);
  const Point2 toFoot = weight * direction;
  return { Length(offset - toFoot), (1.0 - weight) * edge.StartValue + weight * edge.EndValue,
    edge.Start + toFoot, &edge };
}

NearestValue Nearest(const BoxTree<BorderEdge>& border, const Point2& x, const NearestValue& known)
{
  NearestValue best = known;
  border.Search(x, 1.0, known.Distance,
    [&x, &best](const BorderEdge& edge, double)
    {
      const NearestValue found = NearestOnEdge(edge, x);
      best = found.Distance < best.Distance ? found : best;
      return best.Distance;
    });
  return best;
}

} // namespace biting
