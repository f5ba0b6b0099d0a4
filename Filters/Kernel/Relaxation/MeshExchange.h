// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingMeshExchange_h
#define BitingMeshExchange_h

#include "../Base/Ids.h"
#include "../Base/Pulse.h"
#include "MutableMesh.h"
#include "Relaxation.h"

#include <vector> // for the numbers

namespace biting
{

/// Fills `mesh` (MutableMesh::IsDivided is set before) with the triangles of `input`. Returns the
/// number in `input` of each of its vertices. Vertices are numbered in the order in which the
/// triangles use them, so that neighbors are near each other in memory. Unused ones are left out.
/// Each array of `input` is given back as soon as it is read, so that the mesh does not stand in
/// memory twice; places, spacings and segments of the vertices of the domain are left. Where the
/// monitor wants to stop neither mesh nor the result has a meaning.
std::vector<Id> ReadMesh(RelaxationMesh& input, MutableMesh& mesh, Pulse& pulse);

/// The inverse: writes the live triangles of `mesh` to `output`, the rest that ReadMesh left of its
/// input. Returns RelaxationResult::Origins. `origins` is the result of ReadMesh. The arrays of
/// `mesh` are given back as they are written. Where the monitor wants to stop nothing has a
/// meaning.
std::vector<Id> WriteMesh(
  MutableMesh& mesh, const std::vector<Id>& origins, RelaxationMesh& output, Pulse& pulse);

} // namespace biting

#endif
