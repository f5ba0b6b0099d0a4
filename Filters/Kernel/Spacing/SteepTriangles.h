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
/// steeper, by more than a margin, along one of their edges, or in the mean gradient around one of
/// their corners; or by so much of their own gradient that it counts in f.
/// Without meaning if the pulse stops. Linear.
void AddSteepTriangles(
  const TriangulatedSource& source, double gradation, ConeCollector& cones, Pulse& pulse);

} // namespace biting

#endif
