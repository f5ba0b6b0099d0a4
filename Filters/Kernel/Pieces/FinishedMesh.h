// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingFinishedMesh_h
#define BitingFinishedMesh_h

#include "../Base/Crew.h"
#include "../Base/PartOfStage.h"
#include "../Base/Problem.h"
#include "../Biting/BitingScheme.h"
#include "../Blocks/BlockMesher.h"
#include "../Delaunay/Triangulation.h"
#include "../Mesh/BitingMesh.h"
#include "../Mesh/BitingMeshOptions.h"
#include "../Simplification/Simplification.h"
#include "../Spacing/Spacing.h"

namespace biting
{

/// What is meshed, and how.
struct MeshingInput
{
  const SimplifiedDomain& Simplified;
  const Spacing& F;
  const BitingMeshOptions& Options;
  Crew& Members;
};

/// Whether the mesh is relaxed: not where biting was stopped, as then the front is to be seen as it
/// is.
bool IsRelaxed(const BitingMeshOptions& options);

/// Whether nothing is left to do: there is a refusal, or the monitor wants to stop.
bool IsOver(const PartOfStage& whole, ProblemList& problems);

/// The last stage: the mesh as it is handed out, checked and measured. Of several members that of
/// the first, which shares it with the others. Empty where there are errors then.
BitingMesh FinishMesh(const MeshingInput& input, BlockMesher& blocks, BitingResult bites,
  Triangulation& triangulation, ProblemList& problems, PartOfStage& whole);

/// What a member that is not the first has in the end.
BitingMesh TakeOwnPiece(
  const MeshingInput& input, BlockMesher& blocks, ProblemList& problems, PartOfStage& whole);

} // namespace biting

#endif
