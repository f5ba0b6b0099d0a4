// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingCollarOwners_h
#define BitingCollarOwners_h

#include "../Base/Ids.h"
#include "../Delaunay/Triangulation.h"
#include "WholeNumbers.h"

#include <vector> // for the owners

namespace biting
{

/// Which member of a crew is to have each triangle of the collars' mesh: the one that holds its
/// block; of those that come from strips the block is the first one that has a corner for its own,
/// or else that of a triangle nearby, across edges.
std::vector<Id> OwnersOfTriangles(
  const Triangulation& mesh, const WholeNumbers& numbers, const std::vector<Id>& holders);

/// Whether all that is within so many rings of vertices around what triangles of different owners
/// share is in the mesh: none of these vertices is at an edge with nothing across and no
/// constraint.
bool HasRingsAround(const Triangulation& mesh, const std::vector<Id>& owners,
  std::size_t numberOfVertices, int rings);

} // namespace biting

#endif
