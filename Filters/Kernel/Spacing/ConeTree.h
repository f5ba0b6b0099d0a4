// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingConeTree_h
#define BitingConeTree_h

#include "../Base/Monitor.h"
#include "../Base/Numbers.h"
#include "Orthtree.h"
#include "SegmentCone.h"

#include <vector> // for the arrays

namespace biting
{

/// The minimum of many cones of one slope, over a box of the plane (D = 2) or of space (D = 3), at
/// constant cost: the one gradation of all that limits f.
///
/// A 2^D-tree whose leaves list the cones that may be lowest there. It is built from the root down
/// with lists of candidates: a cube drops each cone that is, all over the cube, at least 0.99 times
/// the cone lowest at its center. A cube with few candidates, or much smaller than the value there,
/// is a leaf. So the result is nowhere below the minimum m, and at most (1 + Tolerance) m: tested,
/// not proven, as a cone may be dropped for one that a smaller cube drops. Across the borders of
/// leaves the result may jump by as much.
/// Cost: n log n for n cones; a lookup and a handful of cones for an evaluation.
template <std::size_t D = 2>
class ConeTree
{
public:
  static constexpr double Tolerance = 0.01;

  ConeTree() = default;

  /// `slope` is that of all the cones. Values are positive; values above `most` are not needed.
  /// Incomplete if the monitor asks to stop: it must not be evaluated then. The result does not
  /// depend on the number of threads.
  ConeTree(const std::vector<Cone<D>>& cones, double slope, const Box<D>& bounds,
    double most = Infinity, Monitor& monitor = NoMonitor());

  /// Infinite where the minimum is above `most` in the whole leaf. Outside of the box: the value at
  /// the nearest point of the box.
  double operator()(const Point<D>& x) const
  {
    Point<D> inside;
    for (std::size_t d = 0; d < D; ++d)
    {
      inside[d] = std::min(std::max(this->Bounds.Low[d], x[d]), this->Bounds.High[d]);
    }
    const Id* list = &this->Lists[this->Tree.Locate(inside)];
    const Id* end = list + 1 + *list;
    double least = Infinity;
    for (const Id* cone = list + 1; cone < end; ++cone)
    {
      const double value = this->Cones[*cone](inside, this->Slope);
      least = value < least ? value : least;
    }
    return least;
  }

  std::size_t NumberOfCones() const { return this->Cones.size(); }

  /// The length of all lists.
  std::size_t NumberOfEntries() const { return this->Lists.size(); }

private:
  class Cutter;
  struct Branch;

  double Slope = 0.0;
  Box<D> Bounds;
  Orthtree<D> Tree;           ///< the number of a leaf is where its list starts in Lists
  std::vector<Id> Lists{ 0 }; ///< each is a count, and as many cones
  std::vector<Cone<D>> Cones; ///< mostly in spatial order
};

extern template class ConeTree<2>;
extern template class ConeTree<3>;

} // namespace biting

#endif
