// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingJumpsOutside_h
#define BitingJumpsOutside_h

#include "TriangleInterpolator.h"

namespace biting
{

/// Adds what limits f outside of triangles, where the value is that of the nearest place y of their
/// border: v(y) on the whole ray from y along the normal, up to where another place of the border
/// is as near. Rays are added from steep edges, and where the other value is another one; they are
/// half of f apart. `most` is a bound of f at each point of the source, infinite where not known:
/// where v(y) is above it all along a ray, that is left out.
void AddJumpsOutside(const TriangleInterpolator& source, const std::vector<double>& most,
  const SteepRule& rule, SegmentSource& edges, Pulse& pulse);

} // namespace biting

#endif
