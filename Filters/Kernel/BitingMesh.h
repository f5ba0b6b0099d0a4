// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingMesh_h
#define BitingMesh_h

#include "Base/Crew.h"
#include "Base/Monitor.h"
#include "Base/Problem.h"
#include "Domain/Polylines.h"
#include "Mesh/BitingMesh.h"
#include "Mesh/BitingMeshOptions.h"

namespace biting
{

/// The way of the data: polylines -> domain -> simplification -> spacing -> biting -> Delaunay ->
/// relaxation -> quality -> mesh.
/// Repairs and refusals are added to `problems`; where it has errors afterwards the mesh is empty.
/// Deterministic: the same input gives the same mesh, bit for bit. Members of a crew call it with
/// the same input and options; where it is meshed in blocks these stay with those that made them,
/// and each gets a piece. The first one calls the others as soon as there are blocks, else never;
/// where it has no piece of several it has the whole. Throws bad_alloc where another is lost.
BitingMesh MakeBitingMesh(const Polylines& input, const BitingMeshOptions& options,
  ProblemList& problems, Monitor& monitor, Crew& crew = NoCrew());

} // namespace biting

#endif
