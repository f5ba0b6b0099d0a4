// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingBorderEdge_h
#define BitingBorderEdge_h

#include "../Base/BoxTree.h"

namespace biting
{

/// Values given at the ends of an edge, linear between.
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
NearestValue NearestOnEdge(const BorderEdge& edge, const Point2& x);

/// The value at the nearest point of all edges, or `known` where none is nearer than that.
NearestValue Nearest(const BoxTree<BorderEdge>& border, const Point2& x, const NearestValue& known);

} // namespace biting

#endif
