// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingBorderEdge_h
#define BitingBorderEdge_h

#include "../Base/BoxTree.h"

namespace biting
{

/// Values given at the ends of an edge, linear between. Its triangles lie left of start -> end.
struct BorderEdge
{
  Point2 Start;
  Point2 End;
  double StartValue = 0.0;
  double EndValue = 0.0;
  Id StartId = NoId; ///< of the points that it joins
  Id EndId = NoId;

  // For a BoxTree.
  Box2 Box() const { return Box2::Around(this->Start, this->End); }
  double Least() const { return 0.0; }
};

/// A value at some distance.
struct NearestValue
{
  double Distance;
  double Value;
  Point2 Foot{};                    ///< where it is
  const BorderEdge* Edge = nullptr; ///< that has it; of the tree that found it
};

/// The nearest point of an edge, and its value.
inline NearestValue NearestOnEdge(const BorderEdge& edge, const Point2& x)
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

/// The value at the nearest point of all edges, or `known` where none is nearer than that.
inline NearestValue Nearest(const BoxTree<BorderEdge>& border, const Point2& x, NearestValue known)
{
  border.Search(x, 1.0, known.Distance,
    [&x, &known](const BorderEdge& edge, double)
    {
      const NearestValue found = NearestOnEdge(edge, x);
      known = found.Distance < known.Distance ? found : known;
      return known.Distance;
    });
  return known;
}

} // namespace biting

#endif
