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
/// and those that `edges` keep; then, one after the other, the inner ones that no bite of an
/// earlier one holds, the acceptance radius: a maximal independent set.
///
/// A vertex is held by another that is nearer than 0.7 of the mean f of the two; than 0.9 of it,
/// where its mean length is below the band of the rules, as there the choice is large. So a mesh
/// that has the spacing that is wanted stays whole. Those that the rules say are in the way go, and
/// what of a lattice is left along their border: twice, those with more than half of their
/// neighbors in the way.
///
/// The order is that of a front: next are the vertices just beyond the bites of those that stay,
/// the nearest to these first, so that of a lattice that is too fine a coarser one is left. Bites
/// go along edges: they do not reach across a hole. Cost O(n).
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
