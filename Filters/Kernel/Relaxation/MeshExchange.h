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

/// Fills `mesh` (MutableMesh::IsDivided is set before) with the triangles of `input`, and returns
/// for each of its vertices which one of `input` it is. Vertices are numbered as the triangles
/// meet them, so that neighbors are near each other in memory, in whatever order they were bitten.
/// Those that no triangle uses are left out. Where the monitor wants to stop neither `mesh` nor the
/// result has a meaning.
std::vector<Id> ReadMesh(const RelaxationMesh& input, MutableMesh& mesh, Pulse& pulse);

/// The inverse: writes what is alive of `mesh` to `output`, which is what it was read from, and
/// returns RelaxationResult::Origins. `origins` is what ReadMesh returned. Where the monitor wants
/// to stop `output` stays as it was.
std::vector<Id> WriteMesh(
  const MutableMesh& mesh, const std::vector<Id>& origins, RelaxationMesh& output, Pulse& pulse);

} // namespace biting

#endif
