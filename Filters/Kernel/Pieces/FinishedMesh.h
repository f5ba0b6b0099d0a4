// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingFinishedMesh_h
#define BitingFinishedMesh_h

#include "../Base/Crew.h"
#include "../Base/Ids.h"
#include "../Base/Monitor.h"
#include "../Base/Problem.h"
#include "../Biting/BitingScheme.h"
#include "../Blocks/BlockMesher.h"
#include "../Blocks/WholeNumbers.h"
#include "../Delaunay/Triangulation.h"
#include "../Domain/Domain.h"
#include "../Mesh/BitingMesh.h"
#include "../Quality/ExactSum.h"
#include "../Simplification/Simplification.h"
#include "../Spacing/Spacing.h"
#include "../Stages/MeshSettings.h"

#include <vector> // for constraints

namespace biting
{

/// The part of a spread mesh that one member of a crew has: blocks stay where they were made.
struct SpreadInput
{
  const Domain& Geometry;
  const Spacing& F;
  KeptBlocks& Kept;
  Crew& Members;
  int GhostLevels = 0;
};

/// For the first member: `collars` is the assembled mesh of all collars, its triangles in the order
/// in which `input.Kept` numbers them, with `constraints`. Gives each member its part, and makes
/// its own piece, with the figures of the whole; `density` is what CountAsked says of the whole,
/// where that is asked for. Empty where the monitor wants to stop, or there is a problem.
BitingMesh ShareMesh(const SpreadInput& input, BitingMesh collars,
  const std::vector<Id>& constraints, bool countsAsked, ExactSum& density, ProblemList& problems,
  PartOfStage& part);

/// For the others: their piece, empty where there is none.
BitingMesh TakePiece(const SpreadInput& input, ProblemList& problems, PartOfStage& part);

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
