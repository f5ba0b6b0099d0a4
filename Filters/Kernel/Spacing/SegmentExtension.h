// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSegmentExtension_h
#define BitingSegmentExtension_h

#include "../Base/BoxTree.h"
#include "SegmentCone.h"

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
  SegmentExtension(const std::vector<SegmentCone>& cones, double slope, Pulse& pulse)
    : Slope(slope)
    , Tree(cones, pulse)
  {
  }

  /// Or `known`, if that is less.
  double operator()(const Point2& x, double known = Infinity) const
  {
    this->Tree.Search(x, this->Slope, known,
      [this, &x, &known](const SegmentCone& cone, double)
      {
        known = std::min(known, cone(x, this->Slope));
        return known;
      });
    return known;
  }

private:
  double Slope;
  BoxTree<SegmentCone> Tree;
};

} // namespace biting

#endif
