// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingReleasedVertices_h
#define BitingReleasedVertices_h

#include "../Biting/BitingScheme.h"
#include "../Delaunay/Triangulation.h"
#include "../Domain/Domain.h"
#include "KeepRules.h"
#include "OldMesh.h"

#include <cstdint> // for flags
#include <vector>  // for the flags

namespace biting
{

/// 1 for the embedded vertices of the domain, fixed ones apart.
std::vector<std::uint8_t> FindVerticesThatMayGo(const OldMesh& old, const Domain& domain);

/// 1 for those of them that are in the way of a better mesh: of each triangle with an angle, and of
/// each edge, beyond what `rules` say, one; that of most such triangles and edges.
std::vector<std::uint8_t> FindVerticesInTheWay(const OldMesh& old, const Domain& domain,
  const BitingResult& bites, const Triangulation& mesh, const KeepRules& rules);

/// Takes these vertices out of the domain: they become inner vertices of the mesh like new ones.
void ReleaseVertices(const std::vector<std::uint8_t>& isReleased, Domain& domain,
  BitingResult& bites, Triangulation& mesh);

} // namespace biting

#endif
