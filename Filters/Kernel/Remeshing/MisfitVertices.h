// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingMisfitVertices_h
#define BitingMisfitVertices_h

#include "OldMesh.h"
#include "RegionEdges.h"

#include <cstdint> // for flags
#include <vector>  // for the arrays

namespace biting
{

/// What of the marked edges may change.
struct EdgeFreedom
{
  EdgePolicy Policy = EdgePolicy::Free;
  bool MayBend = false; ///< vertices may go also where edges bend
};

/// 1 at the vertices where the mesh does not have the spacing that is wanted, and may get it: the
/// mean length of their edges says so (KeepRules::IsUnchanged), and one of them is shorter or
/// longer than the band of edges, from 1 / sqrt(2) to sqrt(2) spacings, of which an end may go, or
/// that may be divided. So a mesh whose boundary is finer than the spacing, as it was drawn, stays.
/// `lengths` is what MeanLengths returned. Cost O(n), little a triangle.
std::vector<std::uint8_t> FindMisfits(const OldMesh& mesh, const std::vector<double>& spacings,
  const std::vector<double>& lengths, const EdgeFreedom& freedom);

} // namespace biting

#endif
