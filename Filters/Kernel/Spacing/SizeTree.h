// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSizeTree_h
#define BitingSizeTree_h

#include "../Base/Numbers.h"
#include "Orthtree.h"
#include "Source.h"

namespace biting
{

/// The gradation of sampled sources, over a box in the plane (D = 2) or in space (D = 3):
/// f(x) = min over y of given(y) + g |x - y|.
///
/// A 2^D-tree whose leaves are about f/2 where that matters (CellGradation). Each corner of a leaf
/// has an origin: the place y from which f is lowest there, and given(y). f within the leaf is the
/// minimum of what is given at x and of given(y) + g |x - y| over the origins of its corners and
/// its lowest place. A leaf where all of these are above what is given has no origins: there f is
/// as given, exactly.
///
/// Tolerance: 5 % of f at 99 % of places, 10 % anywhere; what is given changes within less than f/2
/// is seen by its low places. Cost: 2 to 6 leaves for each vertex of a mesh where f is below what
/// is given, none elsewhere; at most 2 million cells, or 8 for each low place. The result does not
/// depend on the number of threads.
template <std::size_t D>
class SizeTree
{
public:
  SizeTree() = default;

  /// f is asked for in `bounds`; outside of them it is an upper bound. `places` are the low places
  /// of the sources; `hasGaps`: a place between others that are inside may be outside. Incomplete
  /// if the pulse stops.
  SizeTree(const GivenAt<D>& givenAt, bool hasGaps, std::vector<LowPlace<D>> places,
    const Box<D>& bounds, double gradation, Pulse& pulse);

  /// Whether f is as given everywhere.
  bool IsEmpty() const { return this->Origins.empty(); }

  /// f(x), where `given` is what is given at x.
  double operator()(const Point<D>& x, double given) const
  {
    const Id* list = &this->Lists[static_cast<std::size_t>(this->Tree.Locate(x))];
    double least = given;
    for (const Id* origin = list + 1; origin <= list + *list; ++origin)
    {
      const LowPlace<D>& low = this->Origins[static_cast<std::size_t>(*origin)];
      least = std::min(least, low.Value + this->Gradation * Distance<D>(low.At, x));
    }
    return least;
  }

  std::size_t NumberOfLeaves() const { return this->LeafCount; }

private:
  class Leaves;

  double Gradation = 0.0;
  Orthtree<D> Tree;      ///< the number of a leaf is where its list starts in Lists
  std::vector<Id> Lists; ///< each is a count, and as many origins
  std::vector<LowPlace<D>> Origins;
  std::size_t LeafCount = 0;
};

extern template class SizeTree<2>;
extern template class SizeTree<3>;

} // namespace biting

#endif
