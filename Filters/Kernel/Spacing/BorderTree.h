// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingBorderTree_h
#define BitingBorderTree_h

#include "BoxTree.h"

#include <cmath> // for abs

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
  Point2 Along() const { return this->End - this->Start; }
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

/// Finds the nearest of many edges. Boxes of long edges that meet in a hub all overlap: so each
/// node of a tree of boxes has a wedge, too, and edges of very different lengths are in different
/// trees.
class BorderTree
{
public:
  BorderTree() = default;
  BorderTree(const std::vector<BorderEdge>& edges, Pulse& pulse);

  /// The value at the nearest point of all edges, or `known` where none is nearer than that.
  NearestValue Nearest(const Point2& x, const NearestValue& known) const;

  /// Calls visit(edge, limit) for all edges that may be nearer than `limit`, likely ones first.
  /// Each call returns the limit from then on. Cost: logarithmic, also where long edges meet in a
  /// hub.
  template <typename Visit>
  void Search(const Point2& x, double limit, Visit visit) const
  {
    const auto look = [&limit, &visit](const BorderEdge& edge, double)
    { return limit = visit(edge, limit); };
    for (const Part& part : this->Parts)
    {
      const auto leastIn = [&part, &x](Id node)
      { return part.Wedges[static_cast<std::size_t>(node)].Bound(x); };
      part.Tree.Search(x, 1.0, limit, look, leastIn);
    }
  }

  /// Those near each other are mostly near each other there.
  const std::vector<BorderEdge>& AllEdges() const { return this->Edges; }

private:
  /// What is within a distance of an axis that is linear along it.
  struct Wedge
  {
    static constexpr double Rounding = 1e-14;

    Point2 Start;
    Point2 Axis;
    double Width = 0.0;  ///< at the start, measured across a side
    double Growth = 0.0; ///< the sine of the angle between a side and the axis
    double Cosine = 0.0;

    Wedge() = default;
    Wedge(const BorderEdge* begin, const BorderEdge* end);

    /// How far it is to there at least.
    double Bound(const Point2& x) const
    {
      const Point2 offset = x - this->Start;
      const double across = std::abs(Cross(this->Axis, offset));
      const double along = Dot(this->Axis, offset);
      return this->Cosine * across - this->Width - this->Growth * along -
        Rounding * (across + std::abs(along));
    }
  };

  /// Of edges of similar lengths.
  struct Part
  {
    Part(const std::vector<BorderEdge>& edges, Pulse& pulse);

    BoxTree<BorderEdge> Tree;
    std::vector<Wedge> Wedges; ///< one a node
  };

  std::vector<Part> Parts;
  std::vector<BorderEdge> Edges;
};

} // namespace biting

#endif
