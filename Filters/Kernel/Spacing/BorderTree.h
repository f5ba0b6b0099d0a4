// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingBorderTree_h
#define BitingBorderTree_h

#include "BoxTree.h"

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
  Point2 Foot{};     ///< where it is
  Id StartId = NoId; ///< of the edge that has it
  Id EndId = NoId;
};

/// The nearest point of an edge, and its value.
NearestValue NearestOnEdge(const BorderEdge& edge, const Point2& x);

/// Finds the nearest of many edges.
class BorderTree
{
public:
  BorderTree() = default;
  BorderTree(const std::vector<BorderEdge>& edges, Pulse& pulse)
    : Tree(edges, pulse)
  {
  }

  /// The value at the nearest point of all edges, or `known` where none is nearer than that.
  NearestValue Nearest(const Point2& x, const NearestValue& known) const;

  const std::vector<BorderEdge>& AllEdges() const { return this->Tree.Items(); }

private:
  BoxTree<BorderEdge> Tree;
};

} // namespace biting

#endif
