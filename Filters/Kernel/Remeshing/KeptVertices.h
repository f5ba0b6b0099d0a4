// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingKeptVertices_h
#define BitingKeptVertices_h

#include "ChangedRegion.h"
#include "KeepRules.h"
#include "OldMesh.h"
#include "RegionEdges.h"

#include <cstdint> // for flags
#include <vector>  // for the arrays

namespace biting
{

/// Which vertices of the region stay, 1 each (paper, section 7): those on the rim, the fixed ones
/// and those that `edges` keep; of the inner ones a maximal independent set, chosen one after the
/// other. Two vertices depend on each other if they are nearer than 0.7 of the mean f of the two,
/// so a mesh that has the spacing that is wanted stays whole; 0.9, if the later one has mean edges
/// below the band of the rules, as the choice among these is large.
///
/// Before that, vertices go that KeepRules::IsInTheWay names; then, twice, those with more than
/// half of their neighbors gone: the rest of a lattice along its border.
///
/// The order is that of a front: next are the vertices just beyond the radius of those that stay,
/// the nearest first. So of a lattice that is too fine a coarser one is left. The search goes along
/// edges: it does not reach across a hole. Cost O(n).
std::vector<std::uint8_t> ChooseKeptVertices(const OldMesh& mesh, const ChangedRegion& region,
  const RegionEdges& edges, const std::vector<double>& spacings, const KeepRules& rules);

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
