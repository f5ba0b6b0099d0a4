// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingReleasedVertices_h
#define BitingReleasedVertices_h

#include "../Biting/BitingScheme.h"
#include "../Delaunay/Triangulation.h"
#include "../Domain/Domain.h"
#include "InnerPlaces.h"
#include "OldMesh.h"

#include <cstdint> // for flags
#include <vector>  // for the flags

namespace biting
{

/// 1 for the embedded vertices of the domain, fixed ones apart.
std::vector<std::uint8_t> FindVerticesThatMayGo(const OldMesh& old, const Domain& domain);

/// 1 for those of no old mesh.
std::vector<std::uint8_t> FindAddedVertices(const Domain& domain);

/// Takes these vertices out of the domain: they become inner vertices of the mesh like new ones.
void ReleaseVertices(const std::vector<std::uint8_t>& isReleased, Domain& domain,
  BitingResult& bites, Triangulation& mesh);

/// The points of those of the flagged vertices that are of the old mesh, in their order.
std::vector<Id> ListHeld(const std::vector<std::uint8_t>& isHeld, const Domain& domain);

/// The inverse of ReleaseVertices, for inner vertices that are at one of `places`: they are
/// vertices of the domain, after the others.
void ReturnVertices(
  const InnerPlaces& places, Domain& domain, BitingResult& bites, Triangulation& mesh);

} // namespace biting

#endif
