// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingBorderTree_h
#define BitingBorderTree_h

#include "../Base/Box2.h"
#include "../Base/Ids.h"

#include <vector> // for the arrays

namespace biting
{

/// Values given at the ends of an edge, linear between.
struct BorderEdge
{
  Point2 Start;
  Point2 End;
  double StartValue = 0.0;
  double EndValue = 0.0;
};

/// A value at some distance.
struct NearestValue
{
  double DistanceSquared;
  double Value;
};

/// The nearest point of an edge, and its value.
NearestValue NearestOnEdge(const BorderEdge& edge, const Point2& x);

/// The nearest of many edges: a tree of boxes, searched by branch and bound, logarithmic in
/// ordinary cases.
class BorderTree
{
public:
  BorderTree() = default;
  explicit BorderTree(std::vector<BorderEdge> edges);

  /// The value at the nearest point of all edges, or `known` where none is nearer than that.
  NearestValue Nearest(const Point2& x, const NearestValue& known) const;

private:
  /// Leaf: edges [First, First + Count). Otherwise the children are nodes First and First + 1.
  struct Node
  {
    Box2 Box;
    Id First = 0;
    Id Count = 0;
  };

  void Build(Id nodeId, Id first, Id last);

  std::vector<BorderEdge> Edges;
  std::vector<Node> Nodes;
};

} // namespace biting

#endif
