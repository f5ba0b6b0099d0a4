// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingOldMeshRepair_h
#define BitingOldMeshRepair_h

#include "FlatTriangles.h"
#include "OldMesh.h"

#include <vector> // for the arrays

namespace biting
{

/// What was found out of a mesh that was mended.
struct MendedMesh
{
  std::vector<Id> Numbers; ///< of each vertex of the input: the one that it was made; empty: itself
  std::vector<Id> Crowded; ///< triangles at edges of more than two

  /// Sides that are no edges any more, the smaller end first, ascending.
  std::vector<DividedSide> Divided;
};

/// Makes vertices of free edges one, divides triangles at vertices that hang on them, and mends
/// flat triangles, as ReadOldMesh (OldMesh.h) states, with a word in `problems`, and links the
/// triangles of `mesh`, a copy of `input`. They have any orientation. Cost O(n) in the triangles
/// and O(m log m) in the free edges.
MendedMesh MendOldMesh(
  const RemeshInput& input, double nearest, OldMesh& mesh, ProblemList& problems);

} // namespace biting

#endif
