// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSteepTriangles_h
#define BitingSteepTriangles_h

#include "../Base/Pulse.h"
#include "ConeCollector.h"

namespace biting
{

/// Adds to `cones` what makes a triangulated source that is steeper than the gradation Lipschitz:
/// below the interpolant, f grows from the edges of steep triangles (SteepTriangles.cxx). Those are
/// steeper, by more than a margin, in the mean gradient around one of their corners; or by so much
/// of their own gradient that it counts in f.
/// Cones that another one stands for, and those that are nowhere below the values, are left out. So
/// a field that is as steep as the gradation, or a little steeper, is left with cones of its low
/// places, if any.
/// Without meaning if the pulse stops. Cost: n log n for n steep triangles, few of them at a point.
void AddSteepTriangles(
  const TriangulatedSource& source, double gradation, ConeCollector& cones, Pulse& pulse);

} // namespace biting

#endif
