// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingJumpsOutside_h
#define BitingJumpsOutside_h

#include "TriangleInterpolator.h"

namespace biting
{

/// Adds segments and points where the values outside of triangles, those of the nearest border, are
/// steeper than the rule's slope: beside steep borders, and where they jump from one border to
/// another one.
///
/// Method: from the lower end of each steep border edge a ray goes out along its normal, as far as
/// its value is the nearest one. For the jumps, squares over the rule's bounds, of 3 x 3 samples each, are cut where values are not
/// linear or a border is near, until they are a third of the spacing there. In the last ones each
/// sample that is low beside another one is a point. Jumps between samples of squares that are
/// large, far from any border, are not seen.
void AddJumpsOutside(
  const TriangleInterpolator& source, const SteepRule& rule, SegmentSource& edges, Pulse& pulse);

} // namespace biting

#endif
