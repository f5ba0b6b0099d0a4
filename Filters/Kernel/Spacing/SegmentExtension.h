// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSegmentExtension_h
#define BitingSegmentExtension_h

#include "BoxTree.h"
#include "SegmentCone.h"

#include <limits> // for infinity

namespace biting
{

/// The minimum of many cones of one slope, exact: the Lipschitz extension of the values along
/// segments. For values asked a few times a segment; ConeTree takes longer to build, and a tenth
/// of the time to answer. The cost of a call is logarithmic, and a few steps where all cones are
/// above what is known.
class SegmentExtension
{
public:
  /// Without cones if the pulse stops: it must not be evaluated then.
  SegmentExtension(const std::vector<SegmentCone>& cones, double slope, Pulse& pulse);

  /// The same cones, in the order of a tree: those near each other mostly one after the other.
  const std::vector<SegmentCone>& OrderedCones() const { return this->Cones; }

  /// Or `known`, if that is less.
  double operator()(const Point2& x, double known = std::numeric_limits<double>::infinity()) const
  {
    this->Tree.Search(x, this->Slope, known,
      [this, &x, &known](Id position, double)
      {
        const SegmentCone& cone = this->Cones[static_cast<std::size_t>(position)];
        known = std::min(known, cone(x, this->Slope));
        return known;
      });
    return known;
  }

private:
  double Slope;
  BoxTree Tree;
  std::vector<SegmentCone> Cones; ///< in the order of the tree
};

} // namespace biting

#endif
