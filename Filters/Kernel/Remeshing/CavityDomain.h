// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingCavityDomain_h
#define BitingCavityDomain_h

#include "../Domain/Domain.h"
#include "ChangedRegion.h"
#include "OldMesh.h"
#include "RegionEdges.h"

#include <cstdint> // for flags
#include <vector>  // for the arrays

namespace biting
{

/// What is meshed in the place of a region: its edges are the segments, in their order, those of
/// the rim and frozen ones preserved, and all of them where the policy is Frozen; its vertices are
/// those that are kept, with old ids as VertexPoints, and embedded where they are on no edge; then
/// `added`, embedded, without an id.
///
/// The invariant of a domain holds, as the old mesh is valid; straight parts that lost vertices are
/// off these by rounding.
Domain MakeCavityDomain(const OldMesh& mesh, const ChangedRegion& region, const RegionEdges& edges,
  const std::vector<std::uint8_t>& isKept, const std::vector<Point2>& added, EdgePolicy policy);

} // namespace biting

#endif
