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
#include "../Simplification/Simplification.h"
#include "../Spacing/Spacing.h"
#include "../Stages/MeshSettings.h"

namespace biting
{

/// The domain, f, and the options of a mesh.
struct MeshingInput
{
  const SimplifiedDomain& Simplified;
  const Spacing& F;
  const BitingMeshOptions& Options;
  const MeshSettings& Settings; ///< of the options
  Crew& Members;
};

/// The last stage: the mesh as it is handed out, checked and measured. Of several members the first
/// shares it with the others, which take their pieces. Empty where there are errors then.
BitingMesh FinishMesh(const MeshingInput& input, BlockMesher& blocks, BitingResult bites,
  Triangulation& triangulation, ProblemList& problems, PartOfStage& whole);

} // namespace biting

#endif
