// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingJumpsOutside_h
#define BitingJumpsOutside_h

#include "TriangleInterpolator.h"

namespace biting
{

/// Adds points where the values outside of triangles, those of the nearest border, are
/// steeper than the rule's slope: beside steep borders, and where they jump from one border to
/// another one.
///
/// Method: from each border point that is lower than its neighbors rays go out, as far as values
/// along them are low. For the jumps, squares over the rule's bounds, of 3 x 3 samples
/// each, are cut where values are not linear or a border is near, until they are 0.7 of the spacing
/// there. In the last ones each sample that is low beside another one is a point. Jumps between the
/// samples of large squares, far from any border, are not seen.
void AddJumpsOutside(
  const TriangleInterpolator& source, const SteepRule& rule, SegmentSource& points, Pulse& pulse);

} // namespace biting

#endif
