// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingBoundaryCheck_h
#define BitingBoundaryCheck_h

#include "SurfaceBoundary.h"

namespace biting
{

/// The certificates of facets: each bite is a vertex, each piece of a chain an edge, each other
/// edge has two facets, the facets of a vertex are one fan (at features those between chains), and
/// are within 60 degrees of the surface. Each failure is added to Offences.
void CheckBoundary(
  const SurfaceGround& ground, const SurfaceBites& bites, SurfaceBoundary& boundary, Pulse& pulse);

} // namespace biting

#endif
