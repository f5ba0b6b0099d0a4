// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingDividedEdges_h
#define BitingDividedEdges_h

#include "../Base/Point.h"
#include "ChangedRegion.h"
#include "OldMesh.h"

#include <cstdint> // for flags
#include <vector>  // for the arrays

namespace biting
{

/// The middles of the inner edges between two triangles of the region, all of whose edges have
/// halves of the length that is wanted: from sqrt(2) to 2 sqrt(2) in units of the mean f of the
/// ends, which are kept both. Where f is halved the new mesh then has the old one's vertices and
/// shapes: four similar triangles of each. `spacings` is f, one a vertex of the region.
///
/// Left out are edges beside a flat triangle, and middles that are nearer to one chosen before, on
/// an edge of the same triangle, than the acceptance radius. Cost O(n).
std::vector<Point2> FindMiddles(const OldMesh& mesh, const ChangedRegion& region,
  const std::vector<std::uint8_t>& isKept, const std::vector<double>& spacings);

} // namespace biting

#endif
