// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingConeTree_h
#define BitingConeTree_h

#include "../Base/Monitor.h"
#include "Orthtree.h"
#include "SegmentCone.h"

#include <limits> // for infinity
#include <vector> // for the arrays

namespace biting
{

/// The minimum of many cones of one slope, over a box, at constant cost.
///
/// A quadtree whose leaves list the cones that may be lowest there. It is built from the root down
/// with lists of candidates: a square drops every cone that the one which is lowest at its center
/// beats all over it, but for Slack. It is a leaf when few candidates are left, or when it is much
/// smaller than the value itself. So the result is nowhere below the minimum, and above it by no
/// more than Tolerance: that is tested, not proven, as of many cones each may be dropped for the
/// next one. Across the borders of leaves it may jump as much.
/// Cost: n log n for n cones; a lookup and a handful of cones for an evaluation.
/// Nothing but the four quarters of a square, and its corners, is tied to the plane.
class ConeTree
{
public:
  static constexpr double Tolerance = 0.01;

  ConeTree() = default;

  /// `slope` is that of all the cones; values are positive, and nobody asks for those above `most`.
  /// Incomplete if the monitor asks to stop: it must not be evaluated then.
  ConeTree(const std::vector<SegmentCone>& cones, double slope, const Box2& bounds,
    double most = std::numeric_limits<double>::infinity(), Monitor& monitor = NoMonitor());

  /// Infinite where all of the leaf is above `most`. Outside of the box the value of the nearest
  /// point in it.
  double operator()(const Point2& x) const
  {
    const Point2 inside{ std::min(std::max(this->Bounds.Low.X, x.X), this->Bounds.High.X),
      std::min(std::max(this->Bounds.Low.Y, x.Y), this->Bounds.High.Y) };
    const Id leaf = this->Tree.Locate({ inside.X, inside.Y });
    const Id* list = &this->Lists[static_cast<std::size_t>(leaf)];
    const Id* end = list + 1 + *list;
    double least = std::numeric_limits<double>::infinity();
    for (const Id* cone = list + 1; cone < end; ++cone)
    {
      const double value = this->Cones[static_cast<std::size_t>(*cone)](inside, this->Slope);
      least = value < least ? value : least;
    }
    return least;
  }

  std::size_t NumberOfLeaves() const { return this->LeafCount; }
  std::size_t NumberOfCones() const { return this->Cones.size(); }

private:
  class Builder;

  double Slope = 0.0;
  Box2 Bounds;
  Orthtree<2> Tree;               ///< the number of a leaf is where its list starts in Lists
  std::vector<Id> Lists;          ///< each is a count, and as many cones
  std::vector<SegmentCone> Cones; ///< those near each other mostly one after the other
  std::size_t LeafCount = 0;
};

} // namespace biting

#endif
